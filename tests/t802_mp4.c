/* The mp4 encoder: what it writes decodes to what was drawn, and no failure leaves a wreck. */
#include "encode/encode.h"
#include "picture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#if HAVE_LIBAV

#include "base/log.h"
#include "encode/codec.h"
#include "film_file.h"

#include <math.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>

static void film_is_what_was_drawn(void **state)
{
    const char *path = in_directory("colon: and 100%d.mp4");
    struct error e;
    struct film film;
    (void)state;
    assert_int_equal(write_film(target_of(path, 160, 96), PATCHES, 65, true, &e), STATUS_OK);
    assert_int_equal(directory_count(), 1);
    assert_true(decode(path, &film));
    assert_int_equal(film.frames, 65);
    assert_int_equal(film.width, 160);
    assert_int_equal(film.height, 96);
    assert_true(fabs(film.fps - 30) < 1e-9);
    assert_true(fabs(film.start) < 1e-9);
    assert_true(fabs(film.duration - 65 / 30.0) < 1e-3);
    assert_true(film.tagged);
    assert_true(film.index_first);
    assert_string_equal(film.title, "Dam break");
    assert_string_equal(film.comment, "sph-render 1, scene 5");
    for (int k = 0; k < PATCH_COUNT; k++)
        for (int c = 0; c < 3; c++)
            if (!(fabs(film.patches[k][c] - patch_colors[k][c]) <= 3))
                fail_msg("patch %d channel %d: %g instead of %d", k, c, film.patches[k][c],
                         patch_colors[k][c]);
}

static void fractional_rates(void **state)
{
    const double rates[] = {29.97, 30000.0 / 1001, 12.5, 0.5, 1000};
    struct error e;
    struct film film;
    (void)state;
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        struct encode_target target = target_of(in_directory("r.mp4"), 64, 48);
        target.fps = rates[i];
        assert_int_equal(write_film(target, MOVING, 10, true, &e), STATUS_OK);
        assert_true(decode(target.path, &film));
        assert_int_equal(film.frames, 10);
        if (!(fabs(film.fps / rates[i] - 1) < 1e-6) ||
            !(fabs(film.duration - 10 / rates[i]) < 2e-3))
            fail_msg("%.9g fps became %.9g, %g s", rates[i], film.fps, film.duration);
    }
}

static void odd_sizes_are_padded(void **state)
{
    const int sizes[][2] = {{161, 97}, {160, 97}, {161, 96}};
    struct error e;
    struct film film;
    (void)state;
    for (int i = 0; i < 3; i++) {
        const char *path = in_directory("odd.mp4");
        assert_int_equal(write_film(target_of(path, sizes[i][0], sizes[i][1]), PATCHES, 3, true,
                                    &e), STATUS_OK);
        assert_true(decode(path, &film));
        assert_int_equal(film.width, sizes[i][0] + sizes[i][0] % 2);
        assert_int_equal(film.height, sizes[i][1] + sizes[i][1] % 2);
        assert_true(fabs(film.patches[3][0] - 255) <= 3);
    }
}

static void same_input_same_file(void **state)
{
    char command[700];
    struct error e;
    (void)state;
    snprintf(command, sizeof command, "cmp '%s' '%s'", in_directory("a.mp4"),
             in_directory("b.mp4"));
    for (int i = 0; i < 8; i++) { /* x264 used to differ now and then */
        const char *path = in_directory(i ? "b.mp4" : "a.mp4");
        assert_int_equal(write_film(target_of(path, 160, 96), MOVING, 40, true, &e), STATUS_OK);
        if (i)
            assert_int_equal(system(command), 0);
    }
}

static void not_kept_or_empty_leaves_the_earlier(void **state)
{
    const char *path = in_directory("f.mp4");
    struct error e;
    (void)state;
    file_write(path, "earlier");
    assert_int_equal(write_film(target_of(path, 160, 96), MOVING, 20, false, &e), STATUS_OK);
    assert_int_equal(write_film(target_of(path, 160, 96), MOVING, 0, true, &e), STATUS_OK);
    assert_true(file_is(path, "earlier"));
    assert_int_equal(directory_count(), 1);
}

/* A film that meets the limit of `bytes` per file; late: only when it is completed. */
static void file_limit(long frames, rlim_t bytes)
{
    const char *path = in_directory("f.mp4");
    struct rlimit limit, old;
    struct error e;
    file_write(path, "earlier");
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old);
    limit = old;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
    enum status status = write_film(target_of(path, 160, 96), NOISE, frames, true, &e);
    setrlimit(RLIMIT_FSIZE, &old);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "File too large"));
    assert_non_null(strstr(e.text, path));
    assert_true(file_is(path, "earlier"));
    assert_int_equal(directory_count(), 1);
}

static void file_limit_at_once(void **state)
{
    (void)state;
    file_limit(10, 100);
}

static void file_limit_on_the_way(void **state)
{
    (void)state;
    file_limit(300, 1 << 20);
}

static void file_limit_at_the_end(void **state)
{
    (void)state;
    file_limit(50, 1 << 18); /* less than one fragment, so nothing is written before the end */
}

/* In a process of its own, on a disk that holds one and a half films of 12 frames; 0 as expected,
 * 77 cannot mount, else what is wrong. */
static int full_disk(void)
{
    const char *path = in_directory("f.mp4");
    struct error e;
    struct film film;
    struct stat info;
    char size[40];
    if (write_film(target_of(path, 160, 96), NOISE, 12, true, &e) || stat(path, &info))
        return 1;
    snprintf(size, sizeof size, "size=%ld", (long)info.st_size * 3 / 2);
    if (unshare(CLONE_NEWNS) || mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) ||
        mount("tmpfs", test_directory, "tmpfs", 0, size))
        return 77;
    file_write(path, "earlier");
    if (write_film(target_of(path, 160, 96), NOISE, 60, true, &e) != STATUS_OUTPUT)
        return 2;
    if (!strstr(e.text, "No space left on device") || !strstr(e.text, path))
        return 3;
    if (!file_is(path, "earlier") || directory_count() != 1)
        return 4;
    /* One film fits, but not its two copies: it is kept as fragments. */
    if (write_film(target_of(path, 160, 96), NOISE, 12, true, &e) || directory_count() != 1)
        return 5;
    if (!decode(path, &film) || film.frames != 12 || film.index_first)
        return 6;
    return 0;
}

static int wait_for(pid_t child)
{
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 100 + WTERMSIG(status);
}

static void disk_is_full(void **state)
{
    (void)state;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0)
        _exit(full_disk());
    int code = wait_for(child);
    if (code == 77)
        skip();
    assert_int_equal(code, 0);
}

static void killed_film_plays(void **state)
{
    char part[300];
    const char *path = in_directory("k.mp4");
    struct film film;
    (void)state;
    snprintf(part, sizeof part, "%s.part", path);
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        struct encode_target target = target_of(path, 160, 96);
        struct encoder *encoder;
        struct image image;
        struct error e;
        image_create(&image, 160, 96, &e);
        encode_find(path, &e)->open(&encoder, &target, &e);
        for (long i = 0; i < 250; i++) {
            picture_moving(&image, i);
            encode_find(path, &e)->frame(encoder, &(struct encode_frame){i, 0, &image, 0}, &e);
        }
        raise(SIGKILL);
    }
    assert_int_equal(wait_for(child), 100 + SIGKILL);
    assert_false(exists(path));
    assert_true(decode(part, &film));
    assert_in_range(film.frames, 170, 250);
    struct error e; /* the next run is not disturbed by what is left */
    assert_int_equal(write_film(target_of(path, 160, 96), MOVING, 10, true, &e), STATUS_OK);
    assert_int_equal(directory_count(), 1);
}

static void missing_directory_is_said(void **state)
{
    struct error e;
    (void)state;
    enum status status = write_film(target_of(in_directory("no/f.mp4"), 64, 48), MOVING, 1, true,
                                    &e);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "No such file or directory"));
}

/* Every codec of the table opens, or says why; so its options exist. */
static void codecs_open_or_say_why(void **state)
{
    const struct codec_picture picture = {160, 96, {30, 1}};
    const struct encode_video video = {.codec = NULL};
    int opened = 0;
    (void)state;
    for (size_t i = 0; i < codec_table.count; i++) {
        struct AVCodecContext *context = NULL;
        struct error e = {STATUS_OK, ""};
        if (codec_try(&context, (const struct codec_row *)codec_table.rows[i], &picture, &video,
                      &e) == STATUS_OK)
            opened++;
        else
            assert_true(e.status == STATUS_BACKEND && strlen(e.text) > 5);
        assert_null(strstr(e.text, "option"));
        codec_close(&context, false);
    }
    assert_true(opened >= 1);
}

static void unknown_option_is_an_error(void **state)
{
    const struct codec_picture picture = {160, 96, {30, 1}};
    const struct encode_video video = {.codec = NULL};
    const struct codec_row row = {.encoder = "mpeg4", .threads = 1, .pixel_format = "yuv420p",
                                  .options = {{"prest", "veryfast", false}}};
    struct AVCodecContext *context = NULL;
    struct error e;
    (void)state;
    assert_int_equal(codec_try(&context, &row, &picture, &video, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "prest=veryfast"));
    assert_null(context);
}

/* No codec takes such a picture: the message names each. */
static void all_failures_are_listed(void **state)
{
    const struct codec_picture picture = {1 << 20, 1 << 20, {30, 1}};
    const struct encode_video video = {.codec = NULL};
    const struct container *container = encode_find("x.mp4", &(struct error){0})->container;
    struct AVCodecContext *context = NULL;
    struct error e;
    (void)state;
    assert_int_equal(codec_open(&context, container, &picture, &video, &e), STATUS_BACKEND);
    for (const char *const *name = container->codecs; *name; name++)
        assert_non_null(strstr(e.text, *name));
}

#define IN_DIRECTORY(f) cmocka_unit_test_setup_teardown(f, directory_make, directory_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_DIRECTORY(disk_is_full),
        IN_DIRECTORY(killed_film_plays),
        IN_DIRECTORY(film_is_what_was_drawn),
        IN_DIRECTORY(fractional_rates),
        IN_DIRECTORY(odd_sizes_are_padded),
        IN_DIRECTORY(same_input_same_file),
        IN_DIRECTORY(not_kept_or_empty_leaves_the_earlier),
        IN_DIRECTORY(file_limit_at_once),
        IN_DIRECTORY(file_limit_on_the_way),
        IN_DIRECTORY(file_limit_at_the_end),
        IN_DIRECTORY(missing_directory_is_said),
        cmocka_unit_test(codecs_open_or_say_why),
        cmocka_unit_test(unknown_option_is_an_error),
        cmocka_unit_test(all_failures_are_listed),
    };
    log_set_level(LOG_ERROR);
    return cmocka_run_group_tests_name("mp4", tests, NULL, NULL);
}

#else

static void not_in_this_build_is_said(void **state)
{
    struct encode_target target = {.path = "x.mp4", .width = 64, .height = 48, .fps = 30};
    struct error e;
    (void)state;
    assert_int_equal(encode_check(&target, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "LIBAV=1"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(not_in_this_build_is_said)};
    return cmocka_run_group_tests_name("mp4", tests, NULL, NULL);
}

#endif
