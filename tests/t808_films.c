/* Films other than the plain mp4: every container and codec, pixel formats, and what is refused. */
#include "base/log.h"
#include "encode/encode.h"
#include "picture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

#if HAVE_LIBAV

#include "encode/codec.h"
#include "encode/palette.h"
#include "film_file.h"

#include <fcntl.h>
#include <libavcodec/avcodec.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>

enum { FRAMES = 7 };

static bool has_encoder(const char *codec)
{
    const struct codec_row *row = (const struct codec_row *)variant_find(&codec_table, codec);
    return avcodec_find_encoder_by_name(row->encoder) != NULL;
}

/* Each kind of file holds its frames, in its size; only subsampled chroma needs even sides. */
static void every_container(void **state)
{
    static const struct { const char *name, *codec, *format; bool padded, tagged; } rows[] = {
        {"f.webm", "vp9", "yuv420p", true, true}, {"f.mkv", "h264", "yuv420p", true, true},
        {"f.gif", "gif", "bgra", false, false},   {"f.apng", "apng", "rgb24", false, false},
        {"f.y4m", "raw", "yuv420p", true, false}};
    struct error e;
    struct film film;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct encode_target target = target_of(in_directory(rows[i].name), 161, 97);
        if (!has_encoder(rows[i].codec))
            continue;
        target.fps = 25;
        assert_int_equal(encode_check(&target, &e), STATUS_OK);
        assert_int_equal(write_film(target, MOVING, FRAMES, true, &e), STATUS_OK);
        assert_int_equal(directory_count(), 1);
        assert_true(decode(target.path, &film));
        assert_int_equal(film.frames, FRAMES);
        assert_int_equal(film.width, rows[i].padded ? 162 : 161);
        assert_int_equal(film.height, rows[i].padded ? 98 : 97);
        assert_string_equal(film.format, rows[i].format);
        assert_true(fabs(film.fps - 25) < 1e-6);
        if (rows[i].tagged) {
            assert_string_equal(film.title, "Dam break");
            assert_string_equal(film.comment, "sph-render 1, scene 5");
        }
        unlink(target.path);
    }
}

static const char *const names[] = {"s.webm", "s.mkv", "s.gif", "s.apng", "s.y4m"};
enum { NAMES = sizeof names / sizeof *names };

/* A file that meets its limit at the header, on the way or only at the end. */
static void limits_are_caught(void **state)
{
    static const rlim_t limits[] = {20, 3000, 30000};
    struct rlimit limit, old;
    struct error e;
    (void)state;
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old);
    limit = old;
    for (int i = 0; i < NAMES * 3; i++) {
        const char *path = in_directory(names[i / 3]);
        file_write(path, "earlier");
        limit.rlim_cur = limits[i % 3];
        setrlimit(RLIMIT_FSIZE, &limit);
        enum status status = write_film(target_of(path, 160, 96), NOISE, 12, true, &e);
        setrlimit(RLIMIT_FSIZE, &old);
        if (status != STATUS_OUTPUT || !strstr(e.text, "File too large") || !strstr(e.text, path))
            fail_msg("%s, %d bytes: status %d, %s", path, (int)limit.rlim_cur, status, e.text);
        assert_true(file_is(path, "earlier"));
        assert_int_equal(directory_count(), 1);
        unlink(path);
    }
}

static void same_frames_same_file(void **state)
{
    struct error e;
    (void)state;
    for (int i = 0; i < NAMES; i++) {
        char command[700], other[300];
        const char *path = in_directory(names[i]);
        snprintf(other, sizeof other, "%s-first", path);
        for (int k = 0; k < 2; k++) {
            assert_int_equal(write_film(target_of(path, 160, 96), MOVING, 20, true, &e), STATUS_OK);
            if (k == 0)
                assert_int_equal(rename(path, other), 0);
        }
        snprintf(command, sizeof command, "cmp '%s' '%s'", path, other);
        assert_int_equal(system(command), 0);
    }
}

/* Keys reach the codec: what the file holds is what they say. */
static void keys_are_followed(void **state)
{
    static const struct { const char *name; struct encode_video video; const char *format; } rows[] = {
        {"a.mp4", {.codec = "h264", .crf = "30", .preset = "ultrafast", .tune = "animation",
                   .pixel_format = "yuv444p"}, "yuv444p"},
        {"b.mp4", {.codec = "h264", .pixel_format = "yuv420p10", .options = "x264-params=ref=2 g=5"},
         "yuv420p10le"},
        {"c.mp4", {.codec = "hevc", .preset = "ultrafast", .crf = "30"}, "yuv420p"},
        {"d.mp4", {.codec = "av1", .preset = "12", .pixel_format = "yuv420p10"}, "yuv420p10le"},
        {"e.webm", {.codec = "vp9", .preset = "8", .pixel_format = "yuv444p"}, "yuv444p"},
        {"f.mkv", {.codec = "mpeg4"}, "yuv420p"},
    };
    struct error e;
    struct film film;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct encode_target target = target_of(in_directory(rows[i].name), 160, 96);
        if (!has_encoder(rows[i].video.codec))
            continue;
        target.video = rows[i].video;
        assert_int_equal(write_film(target, PATCHES, FRAMES, true, &e), STATUS_OK);
        assert_true(decode(target.path, &film));
        assert_int_equal(film.frames, FRAMES);
        assert_string_equal(film.format, rows[i].format);
        assert_true(film.tagged || strcmp(rows[i].video.codec, "mpeg4") == 0);
    }
}

/* ffv1 and apng give back every byte; so a picture of noise stays noise. */
static void lossless_films(void **state)
{
    struct encode_target targets[] = {target_of(in_directory("l.mkv"), 64, 48),
                                      target_of(in_directory("l.apng"), 64, 48)};
    struct error e;
    struct film film;
    struct image image;
    (void)state;
    targets[0].video.codec = "ffv1";
    image_create(&image, 64, 48, &e);
    picture_noise(&image, 2);
    for (int i = 0; i < 2; i++) {
        bool rgb = i == 1; /* else blue first, and a byte unused */
        assert_int_equal(write_film(targets[i], NOISE, 3, true, &e), STATUS_OK);
        assert_true(decode(targets[i].path, &film));
        for (int p = 0; p < 4; p++)
            for (int c = 0; c < 3; c++)
                assert_int_equal(film.first[rgb ? 3 * p + c : 4 * p + 2 - c], image.rgba[4 * p + c]);
    }
    image_free(&image);
}

/* Few colours come back as they were; of many the mean error is small. */
static void palettes_fit_pictures(void **state)
{
    struct palette *palette = palette_create();
    struct image image;
    struct error e;
    uint32_t colors[PALETTE_SIZE];
    double sum = 0;
    (void)state;
    image_create(&image, 256, 256, &e);
    picture_patches(&image);
    palette_choose(palette, &image, colors);
    for (size_t i = 0; i < 256 * 256; i++) {
        const uint8_t *p = image.rgba + 4 * i;
        uint32_t color = colors[palette_index(palette, p)];
        assert_int_equal(color, 0xff000000u | (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2]);
    }
    for (size_t i = 0; i < 256 * 256; i++) { /* 65536 colours of a plane */
        image.rgba[4 * i] = (uint8_t)(i % 256);
        image.rgba[4 * i + 1] = (uint8_t)(i / 256);
        image.rgba[4 * i + 2] = 77;
    }
    palette_choose(palette, &image, colors);
    for (size_t i = 0; i < 256 * 256; i++) {
        uint32_t color = colors[palette_index(palette, image.rgba + 4 * i)];
        sum += fabs((double)(color >> 16 & 255) - (double)(i % 256)) / 65536;
        assert_int_equal(color & 255, 77);
    }
    assert_true(sum < 6); /* 16 x 16 squares would have 4 */
    image_free(&image);
    palette_free(palette);
}

/* Reads the whole file; *size bytes. */
static char *file_bytes(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *bytes = malloc(1 << 20);
    *size = fread(bytes, 1, 1 << 20, file);
    fclose(file);
    return bytes;
}

/* The header line, then for each frame a line and its planes: nothing more, nothing less. */
static void check_y4m(const char *path, const char *header, size_t frame_bytes, long frames)
{
    size_t size, line;
    char *bytes = file_bytes(path, &size);
    assert_memory_equal(bytes, header, strlen(header));
    line = (size_t)((char *)memchr(bytes, '\n', size) - bytes) + 1;
    assert_int_equal(size, line + (size_t)frames * (6 + frame_bytes));
    for (long i = 0; i < frames; i++)
        assert_memory_equal(bytes + line + (size_t)i * (6 + frame_bytes), "FRAME\n", 6);
    free(bytes);
}

static void y4m_is_plain(void **state)
{
    struct encode_target target = target_of(in_directory("p.y4m"), 64, 48);
    struct error e;
    (void)state;
    target.fps = 29.97;
    assert_int_equal(write_film(target, MOVING, 3, true, &e), STATUS_OK);
    check_y4m(target.path, "YUV4MPEG2 W64 H48 F2997:100 Ip A1:1 C420", 64 * 48 * 3 / 2, 3);
    target.video.pixel_format = "yuv444p10";
    target.width = 63;
    assert_int_equal(write_film(target, MOVING, 2, true, &e), STATUS_OK);
    check_y4m(target.path, "YUV4MPEG2 W63 H48 F2997:100 Ip A1:1 C444p10", 63 * 48 * 3 * 2, 2);
}

static void y4m_to_standard_output(void **state)
{
    const char *path = in_directory("o.y4m");
    struct error e;
    (void)state;
    fflush(stdout);
    int kept = dup(STDOUT_FILENO), file = open(path, O_WRONLY | O_CREAT, 0666);
    dup2(file, STDOUT_FILENO);
    enum status status = write_film(target_of("-", 64, 48), MOVING, 3, true, &e);
    dup2(kept, STDOUT_FILENO);
    close(kept);
    close(file);
    assert_int_equal(status, STATUS_OK);
    check_y4m(path, "YUV4MPEG2 W64 H48 F30:1 ", 64 * 48 * 3 / 2, 3);
    assert_int_equal(directory_count(), 1);
}

/* What a scene asks for in vain is said with what there is, before anything is written. */
static void wishes_are_checked(void **state)
{
    static const struct { const char *name; struct encode_video video; const char *text; } rows[] = {
        {"x.webm", {.codec = "h264"}, "webm files cannot hold h264; they hold"},
        {"x.mp4", {.codec = "mpeg4", .crf = "20"}, "movie.crf: codec mpeg4 has no such option; it has"},
        {"x.mp4", {.codec = "mpeg4", .options = "prest=1"}, "movie.options: prest: codec mpeg4 has no"},
        {"x.mp4", {.codec = "mpeg4", .options = "prest"}, "no list of the form"},
        {"x.mp4", {.codec = "mpeg4", .pixel_format = "yuv444p"}, "it takes yuv420p"},
        {"x.mp4", {.codec = "mpeg4", .pixel_format = "yuv999"}, "it takes yuv420p"},
        {"x.mp4", {.codec = "mpeg4", .options = "b_strategy=many"}, "does not take \"many\""},
        {"x.y4m", {.pixel_format = "yuv999"}, "does not take \"yuv999\""},
    };
    struct error e;
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct encode_target target = target_of(in_directory(rows[i].name), 64, 48);
        if (rows[i].video.codec && !has_encoder(rows[i].video.codec))
            continue;
        target.video = rows[i].video;
        assert_int_equal(encode_check(&target, &e), STATUS_USAGE);
        if (!strstr(e.text, rows[i].text))
            fail_msg("\"%s\" lacks \"%s\"", e.text, rows[i].text);
    }
    assert_int_equal(directory_count(), 0);
}

#define IN_DIRECTORY(f) cmocka_unit_test_setup_teardown(f, directory_make, directory_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        IN_DIRECTORY(every_container), IN_DIRECTORY(limits_are_caught),
        IN_DIRECTORY(same_frames_same_file), IN_DIRECTORY(keys_are_followed),
        IN_DIRECTORY(lossless_films),  cmocka_unit_test(palettes_fit_pictures),
        IN_DIRECTORY(y4m_is_plain),
        IN_DIRECTORY(y4m_to_standard_output), IN_DIRECTORY(wishes_are_checked),
    };
    log_set_level(LOG_ERROR);
    return cmocka_run_group_tests_name("films", tests, NULL, NULL);
}

#else

static void not_in_this_build_is_said(void **state)
{
    static const char *const names[] = {"x.webm", "x.mkv", "x.gif", "x.apng", "x.y4m", "-"};
    struct error e;
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct encode_target target = {.path = names[i], .width = 64, .height = 48, .fps = 30};
        assert_int_equal(encode_check(&target, &e), STATUS_BACKEND);
        assert_non_null(strstr(e.text, "LIBAV=1"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(not_in_this_build_is_said)};
    return cmocka_run_group_tests_name("films", tests, NULL, NULL);
}

#endif
