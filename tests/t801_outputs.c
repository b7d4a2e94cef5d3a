/* Outputs: names, checks before the run, and the encoders png, hash and null. */
#include "encode/encode.h"
#include "picture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

static struct encode_target target_of(const char *path)
{
    return (struct encode_target){.path = path, .width = 64, .height = 48, .fps = 30,
                                  .title = "test"};
}

static enum status check(const char *path, bool single, struct error *e)
{
    struct encode_target target = target_of(path);
    target.single = single;
    return encode_check(&target, e);
}

static void names_choose_encoders(void **state)
{
    struct error e;
    (void)state;
    assert_string_equal(encode_find("a/b.mp4", &e)->variant.name, "mp4");
    assert_string_equal(encode_find("B.MP4", &e)->variant.name, "mp4");
    assert_string_equal(encode_find("x-%04d.png", &e)->variant.name, "png");
    assert_string_equal(encode_find("x.mkv", &e)->variant.name, "mkv");
    assert_string_equal(encode_find("-", &e)->variant.name, "y4m");
    assert_true(encode_is_file(encode_find("x.y4m", &e), "x.y4m"));
    assert_false(encode_is_file(encode_find("-", &e), "-"));
    assert_string_equal(encode_find("null", &e)->variant.name, "null");
    assert_string_equal(encode_find("hash", &e)->variant.name, "hash");
    assert_false(encode_find("null", &e)->wants_pixels);
    assert_true(encode_find("hash", &e)->wants_pixels);
    for (size_t i = 0; i < encode_table.count; i++)
        assert_ptr_equal(variant_find(&encode_table, encode_table.rows[i]->name),
                         encode_table.rows[i]);
}

static void unknown_names_list_the_known(void **state)
{
    const char *names[] = {"x.avi", "x", "out/null", ".mp4", "a.mp4/x", "mp4", ""};
    struct error e;
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        assert_null(encode_find(names[i], &e));
        assert_int_equal(e.status, STATUS_USAGE);
        assert_non_null(strstr(e.text, "NAME.mp4, NAME.webm"));
        assert_non_null(strstr(e.text, "NAME.png, NAME.pdf, NAME.svg, NAME.pfm, NAME.csv, hash, null"));
    }
}

static void patterns_are_checked(void **state)
{
    struct error e;
    (void)state;
    const char *bad[] = {"x.png", "x-%d-%d.png", "x-%s.png", "x-%n.png", "x-%4d.png", "x-%0d.png",
                         "x-%04ld.png", "x-%", "%d/x.png", "x%%.png", "x-%00004d.png"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char path[300];
        snprintf(path, sizeof path, "%s/%s%s", test_directory, bad[i],
                 strstr(bad[i], ".png") ? "" : ".png");
        assert_int_equal(check(path, false, &e), STATUS_USAGE);
        assert_non_null(strstr(e.text, "%04d.png"));
    }
    assert_int_equal(check(in_directory("x-%04d.png"), false, &e), STATUS_OK);
    assert_int_equal(check(in_directory("%d.png"), false, &e), STATUS_OK);
    assert_int_equal(check(in_directory("x.png"), true, &e), STATUS_OK);
    assert_int_equal(check(in_directory("x%s.png"), true, &e), STATUS_USAGE);
    assert_int_equal(directory_count(), 0);
}

static void targets_are_checked(void **state)
{
    struct error e;
    (void)state;
    const char *extensions[] = {"mp4", "%d.png"};
    for (int i = HAVE_LIBAV ? 0 : 1; i < 2; i++) {
        char path[300];
        snprintf(path, sizeof path, "%s/missing/x%s%s", test_directory, i ? "" : ".",
                 extensions[i]);
        assert_int_equal(check(path, false, &e), STATUS_OUTPUT);
        assert_non_null(strstr(e.text, "missing"));
        assert_non_null(strstr(e.text, "No such file or directory"));
    }
    assert_int_equal(mkdir(in_directory("d.png"), 0777), 0);
    assert_int_equal(check(in_directory("d.png"), true, &e), STATUS_OUTPUT);
    struct encode_target target = target_of("null");
    target.fps = 0;
    assert_int_equal(encode_check(&target, &e), STATUS_USAGE);
    target = target_of("null");
    target.width = 0;
    assert_int_equal(encode_check(&target, &e), STATUS_USAGE);
}

/* Writes `count` noise frames; returns the status of the whole. */
static enum status write_frames(struct encode_target target, long count, bool keep,
                                struct error *e)
{
    const struct encoder_row *row = encode_find(target.path, e);
    struct encoder *encoder;
    struct image image;
    assert_int_equal(image_create(&image, target.width, target.height, e), STATUS_OK);
    enum status status = row->open(&encoder, &target, e);
    assert_int_equal(status, STATUS_OK);
    for (long i = 0; !status && i < count; i++) {
        struct encode_frame frame = {i, (double)i / 30, &image, 7};
        picture_noise(&image, (uint32_t)i);
        status = row->frame(encoder, &frame, e);
    }
    struct error closing;
    memset(image.rgba, 0, 64); /* frames must not share the image with us */
    if (row->close(encoder, keep && !status, &closing) && !status) {
        *e = closing;
        status = e->status;
    }
    image_free(&image);
    return status;
}

static void png_sequence_is_named_and_whole(void **state)
{
    struct error e;
    struct image image, expected;
    (void)state;
    assert_int_equal(write_frames(target_of(in_directory("s-%03d.png")), 20, true, &e), STATUS_OK);
    assert_int_equal(directory_count(), 20);
    image_create(&expected, 64, 48, &e);
    for (long i = 0; i < 20; i++) {
        char name[32];
        snprintf(name, sizeof name, "s-%03ld.png", i);
        assert_int_equal(image_read_png(&image, in_directory(name), &e), STATUS_OK);
        picture_noise(&expected, (uint32_t)i);
        assert_int_equal(image.width, 64);
        assert_memory_equal(image.rgba, expected.rgba, 64 * 48 * 4);
        image_free(&image);
    }
    image_free(&expected);
}

static void png_single_and_percent(void **state)
{
    struct error e;
    struct encode_target target = target_of(in_directory("one.png"));
    (void)state;
    target.single = true;
    assert_int_equal(write_frames(target, 1, true, &e), STATUS_OK);
    assert_true(exists(in_directory("one.png")));
    assert_int_equal(write_frames(target_of(in_directory("5%%-%d.png")), 1, true, &e), STATUS_OK);
    assert_true(exists(in_directory("5%-0.png")));
}

static void png_not_kept_leaves_the_earlier(void **state)
{
    struct error e;
    (void)state;
    file_write(in_directory("s-3.png"), "earlier");
    assert_int_equal(write_frames(target_of(in_directory("s-%d.png")), 9, false, &e), STATUS_OK);
    assert_int_equal(directory_count(), 1);
    assert_true(file_is(in_directory("s-3.png"), "earlier"));
    assert_int_equal(write_frames(target_of(in_directory("s-%d.png")), 9, true, &e), STATUS_OK);
    assert_int_equal(directory_count(), 9);
    assert_false(file_is(in_directory("s-3.png"), "earlier"));
}

static void png_worker_errors_surface(void **state)
{
    struct error e;
    struct encode_target target = target_of(in_directory("gone/x-%d.png"));
    const struct encoder_row *row = encode_find(target.path, &e);
    struct encoder *encoder;
    struct image image;
    (void)state;
    mkdir(in_directory("gone"), 0777);
    image_create(&image, 64, 48, &e);
    assert_int_equal(encode_check(&target, &e), STATUS_OK);
    assert_int_equal(row->open(&encoder, &target, &e), STATUS_OK);
    rmdir(in_directory("gone"));
    enum status status = STATUS_OK;
    for (long i = 0; !status && i < 1000; i++)
        status = row->frame(encoder, &(struct encode_frame){i, 0, &image, 0}, &e);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "gone/x-"));
    e.status = STATUS_OK;
    assert_int_equal(row->close(encoder, true, &e), STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "gone/x-"));
    image_free(&image);
}

/* Runs the hash encoder with stdout in a file, whose text is returned. */
static void hash_text(const char *path, char *text, size_t size)
{
    struct error e;
    fflush(stdout);
    int saved = dup(STDOUT_FILENO);
    assert_non_null(freopen(path, "w", stdout));
    enum status status = write_frames(target_of("hash"), 3, true, &e);
    fflush(stdout);
    dup2(saved, STDOUT_FILENO);
    close(saved);
    assert_int_equal(status, STATUS_OK);
    FILE *file = fopen(path, "r");
    size_t used = fread(text, 1, size - 1, file);
    text[used] = 0;
    fclose(file);
}

static void hash_lines(void **state)
{
    char text[500], again[500], state_hash[20], pixel_hash[3][20];
    (void)state;
    hash_text(in_directory("a"), text, sizeof text);
    hash_text(in_directory("b"), again, sizeof again);
    assert_string_equal(text, again);
    char *line = text;
    for (long i = 0; i < 3; i++) {
        char expected[100];
        long index;
        double time;
        assert_int_equal(sscanf(line, "%ld %lf %16s %16s", &index, &time, state_hash,
                                pixel_hash[i]), 4);
        snprintf(expected, sizeof expected, "%ld %.9g 0000000000000007 %s\n", i, (double)i / 30,
                 pixel_hash[i]);
        assert_memory_equal(line, expected, strlen(expected));
        assert_int_equal(strlen(pixel_hash[i]), 16);
        line += strlen(expected);
    }
    assert_string_not_equal(pixel_hash[0], pixel_hash[1]);
    assert_string_not_equal(pixel_hash[1], pixel_hash[2]);
}

static void hash_full_disk(void **state)
{
    struct error e;
    (void)state;
    if (access("/dev/full", W_OK))
        skip();
    fflush(stdout);
    int saved = dup(STDOUT_FILENO);
    assert_non_null(freopen("/dev/full", "w", stdout));
    enum status status = write_frames(target_of("hash"), 3, true, &e);
    clearerr(stdout);
    dup2(saved, STDOUT_FILENO);
    close(saved);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "No space left"));
}

static void null_takes_frames_without_pixels(void **state)
{
    struct error e;
    struct encoder *encoder;
    struct encode_target target = target_of("null");
    const struct encoder_row *row = encode_find("null", &e);
    (void)state;
    assert_int_equal(encode_check(&target, &e), STATUS_OK);
    assert_int_equal(row->open(&encoder, &target, &e), STATUS_OK);
    assert_int_equal(row->frame(encoder, &(struct encode_frame){0}, &e), STATUS_OK);
    assert_int_equal(row->close(encoder, true, &e), STATUS_OK);
}

#define IN_DIRECTORY(f) cmocka_unit_test_setup_teardown(f, directory_make, directory_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_choose_encoders),
        cmocka_unit_test(unknown_names_list_the_known),
        IN_DIRECTORY(patterns_are_checked),
        IN_DIRECTORY(targets_are_checked),
        IN_DIRECTORY(png_sequence_is_named_and_whole),
        IN_DIRECTORY(png_single_and_percent),
        IN_DIRECTORY(png_not_kept_leaves_the_earlier),
        IN_DIRECTORY(png_worker_errors_surface),
        IN_DIRECTORY(hash_lines),
        IN_DIRECTORY(hash_full_disk),
        cmocka_unit_test(null_takes_frames_without_pixels),
    };
    return cmocka_run_group_tests_name("outputs", tests, NULL, NULL);
}
