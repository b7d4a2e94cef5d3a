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
#include <libavutil/opt.h>
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
        {"x.mp4", {.codec = "h264-nvenc"}, "takes 145 x 49 pixels and more, not 64 x 48; smaller ones "
         "are for \"h264\""},
        {"x.mkv", {.codec = "hevc-nvenc"}, "takes 129 x 33 pixels and more, not 64 x 48"},
        {"x.mp4", {.codec = "h264-nvenc", .crf = "0"}, "codec h264-nvenc takes 1 and more, not 0"},
        {"x.mp4", {.codec = "h264-nvenc", .crf = "60"}, "codec h264-nvenc does not take \"60\""},
        {"x.mp4", {.codec = "h264-nvenc", .preset = "veryfast"}, "does not take \"veryfast\""},
        {"x.mp4", {.codec = "h264-nvenc", .pixel_format = "bgr0"}, "it takes yuv420p"},
        {"x.webm", {.codec = "h264-nvenc"}, "webm files cannot hold h264-nvenc"},
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

static void check_option(AVCodecContext *context, const char *key, const char *value)
{
    uint8_t *text = NULL;
    assert_true(av_opt_get(context->priv_data, key, 0, &text) >= 0);
    if (atof((char *)text) != atof(value))
        fail_msg("%s is %s instead of %s", key, text, value);
    av_free(text);
}

/* What NVENC is told: presets and modes have the numbers of libavcodec's and NVIDIA's lists. */
static void gpu_settings(void **state)
{
    static const struct {
        const char *codec;
        struct encode_video video;
        const char *cq, *preset, *tune;
        int format, b_frames;
    } rows[] = {
        {"h264-nvenc", {.codec = NULL}, "20", "p4", "hq", AV_PIX_FMT_YUV420P, 2},
        {"hevc-nvenc", {.codec = NULL}, "22", "p4", "hq", AV_PIX_FMT_YUV420P, -1},
        {"h264-nvenc", {.crf = "18.5", .preset = "p6", .tune = "ll", .pixel_format = "yuv444p",
                        .options = "bf=0"}, "18.5", "p6", "ll", AV_PIX_FMT_YUV444P, 0}};
    const struct codec_picture picture = {161, 97, {25, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct codec_row *row =
            (const struct codec_row *)variant_find(&codec_table, rows[i].codec);
        AVCodecContext *context;
        struct error e = {STATUS_OK, ""};
        int64_t preset, tune, number;
        if (!has_encoder(rows[i].codec))
            continue;
        assert_int_equal(codec_prepare(&context, row, &picture, &rows[i].video, &e), STATUS_OK);
        check_option(context, "cq", rows[i].cq);
        check_option(context, "rc", "1"); /* NV_ENC_PARAMS_RC_VBR */
        assert_true(av_opt_get_int(context->priv_data, "preset", 0, &preset) >= 0);
        assert_true(av_opt_get_int(context->priv_data, "tune", 0, &tune) >= 0);
        av_opt_set(context->priv_data, "preset", rows[i].preset, 0);
        av_opt_set(context->priv_data, "tune", rows[i].tune, 0);
        assert_true(av_opt_get_int(context->priv_data, "preset", 0, &number) >= 0 && number == preset);
        assert_true(av_opt_get_int(context->priv_data, "tune", 0, &number) >= 0 && number == tune);
        assert_int_equal(context->pix_fmt, rows[i].format);
        assert_int_equal(context->width, rows[i].format == AV_PIX_FMT_YUV420P ? 162 : 161);
        assert_int_equal(context->max_b_frames, rows[i].b_frames);
        assert_int_equal(context->gop_size, 50);
        assert_int_equal(context->color_range, AVCOL_RANGE_MPEG);
        assert_int_equal(context->colorspace, AVCOL_SPC_BT709);
        assert_int_equal(context->color_trc, AVCOL_TRC_BT709);
        assert_int_equal(context->color_primaries, AVCOL_PRI_BT709);
        avcodec_free_context(&context);
    }
}

/* A GPU's encoder is tried even when only asked about, other encoders are not; when it opens for other
 * pictures the scene is at fault. An encoder that every machine has stands in for the GPU's. */
static void gpu_is_tried(void **state)
{
    struct codec_row row = {.variant = {.name = "stand-in"}, .encoder = "mpeg4", .threads = 1,
                            .pixel_format = "yuv420p", .least_size = {32, 32}};
    const struct codec_picture fits = {64, 48, {30, 1}}, wide = {16384, 64, {30, 1}};
    const struct encode_video video = {.codec = NULL};
    AVCodecContext *context = NULL;
    struct error e;
    (void)state;
    assert_int_equal(codec_try(NULL, &row, &wide, &video, &e), STATUS_OK);
    assert_int_equal(codec_try(&context, &row, &wide, &video, &e), STATUS_BACKEND);
    row.without_gpu = "h264";
    assert_int_equal(codec_try(NULL, &row, &fits, &video, &e), STATUS_OK);
    assert_int_equal(codec_try(NULL, &row, &wide, &video, &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, "opens here, but not for 16384 x 64 pixels of yuv420p"));
    assert_int_equal(codec_try(&context, &row, &wide, &video, &e), STATUS_USAGE);
    assert_null(context);
    assert_int_equal(codec_try(&context, &row, &fits, &video, &e), STATUS_OK);
    codec_close(&context, false);
}

/* Without such a GPU the refusal says what to use, and leaves an earlier film alone; with one the film
 * is what was drawn. */
static void gpu_encodes_or_refuses(void **state)
{
    static const char *const codecs[][2] = {{"h264-nvenc", "use \"h264\""},
                                            {"hevc-nvenc", "use \"hevc\""}};
    struct encode_target target = target_of(in_directory("g.mp4"), 320, 192);
    struct error e;
    struct film film;
    (void)state;
    fclose(fopen(target.path, "w"));
    for (size_t i = 0; i < sizeof codecs / sizeof *codecs; i++) {
        target.video.codec = codecs[i][0];
        enum status status = encode_check(&target, &e);
        if (status) {
            assert_int_equal(status, STATUS_BACKEND);
            assert_non_null(strstr(e.text, codecs[i][1]));
            assert_int_equal(write_film(target, MOVING, 3, true, &e), STATUS_BACKEND);
            assert_non_null(strstr(e.text, codecs[i][1]));
            struct stat file;
            assert_true(stat(target.path, &file) == 0 && file.st_size == 0);
        } else {
            assert_int_equal(write_film(target, MOVING, FRAMES, true, &e), STATUS_OK);
            assert_true(decode(target.path, &film));
            assert_int_equal(film.frames, FRAMES);
            assert_true(film.tagged);
            fclose(fopen(target.path, "w"));
        }
        assert_int_equal(directory_count(), 1);
    }
}

/* Nothing that a machine's GPU decides is chosen unless it is named. */
static void no_gpu_by_default(void **state)
{
    (void)state;
    for (size_t i = 0; i < encode_table.count; i++) {
        const struct encoder_row *row = (const struct encoder_row *)encode_table.rows[i];
        for (const char *const *name = row->container ? row->container->codecs : NULL; name && *name;
             name++)
            assert_null(((const struct codec_row *)variant_find(&codec_table, *name))->without_gpu);
    }
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
        cmocka_unit_test(gpu_settings), cmocka_unit_test(gpu_is_tried),
        IN_DIRECTORY(gpu_encodes_or_refuses), cmocka_unit_test(no_gpu_by_default),
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
