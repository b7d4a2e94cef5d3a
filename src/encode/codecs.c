/* The table of video codecs: libavcodec's encoders with the options that suit films of particles. */
#include "encode/codec.h"

/* x264: build 164 gives files that differ from run to run with AVX-512 and mbtree, for widths such
 * as 160, 720 and 854; AVX2 gives the same file always, as fast. */
static const struct codec_row h264 = {
    .variant = {.name = "h264", .doc = "H.264 by libx264, plays everywhere (mp4, mkv)"},
    .encoder = "libx264", .threads = 4, .pixel_format = "yuv420p",
    .crf = "crf", .preset = "preset", .tune = "tune",
    .options = {{"preset", "veryfast", false}, {"crf", "18", false},
                {"x264-params", "asm=avx2", true}}};

/* NVENC is in most builds of libavcodec, yet opens only where a GPU and its driver have it. Its
 * constant quality cq is a variable rate without a target; cq 0 would be libavcodec's target of
 * 2 Mbit/s. HEVC has the B frames of its preset, since with older GPUs it has none. The smallest sizes
 * are those that users report of chips since Turing. */
static const struct codec_row h264_nvenc = {
    .variant = {.name = "h264-nvenc", .doc = "H.264 by an NVIDIA GPU that has an encoder, if named "
                "(mp4, mkv); presets p1 to p7"},
    .encoder = "h264_nvenc", .threads = 1, .pixel_format = "yuv420p",
    .crf = "cq", .preset = "preset", .tune = "tune",
    .least_crf = 1, .least_size = {145, 49}, .without_gpu = "h264",
    .options = {{"preset", "p4", false}, {"rc", "vbr", false}, {"cq", "20", false},
                {"bf", "2", false}}};

static const struct codec_row hevc = {
    .variant = {.name = "hevc", .doc = "H.265 by libx265, smaller files (mp4, mkv)"},
    .encoder = "libx265", .threads = 4, .tag = "hvc1", .pixel_format = "yuv420p",
    .crf = "crf", .preset = "preset", .tune = "tune",
    .options = {{"preset", "fast", false}, {"crf", "20", false},
                {"x265-params", "log-level=none", false}}};

static const struct codec_row hevc_nvenc = {
    .variant = {.name = "hevc-nvenc", .doc = "H.265 by an NVIDIA GPU that has an encoder, if named "
                "(mp4, mkv); presets p1 to p7"},
    .encoder = "hevc_nvenc", .threads = 1, .tag = "hvc1", .pixel_format = "yuv420p",
    .crf = "cq", .preset = "preset", .tune = "tune",
    .least_crf = 1, .least_size = {129, 33}, .without_gpu = "hevc",
    .options = {{"preset", "p4", false}, {"rc", "vbr", false}, {"cq", "22", false}}};

static const struct codec_row av1 = {
    .variant = {.name = "av1", .doc = "AV1 by SVT-AV1 (mp4, webm, mkv); presets 0 to 13"},
    .encoder = "libsvtav1", .threads = 4, .pixel_format = "yuv420p",
    .crf = "crf", .preset = "preset",
    .options = {{"preset", "10", false}, {"crf", "28", false}}};

static const struct codec_row av1_aom = {
    .variant = {.name = "av1-aom", .doc = "AV1 by libaom, slow, has yuv444p (mp4, webm, mkv); presets 0 "
                "to 8"},
    .encoder = "libaom-av1", .threads = 4, .pixel_format = "yuv420p",
    .crf = "crf", .preset = "cpu-used", .tune = "tune",
    .options = {{"cpu-used", "8", false}, {"crf", "28", false}, {"row-mt", "1", false}}};

static const struct codec_row vp9 = {
    .variant = {.name = "vp9", .doc = "VP9 by libvpx, plays in browsers (webm, mp4, mkv); presets "
                "0 to 8"},
    .encoder = "libvpx-vp9", .threads = 4, .pixel_format = "yuv420p",
    .crf = "crf", .preset = "cpu-used", .tune = "tune",
    .options = {{"cpu-used", "5", false}, {"crf", "24", false}, {"b", "0", false},
                {"row-mt", "1", false}}};

/* Quality 3 * FF_QP2LAMBDA. */
static const struct codec_row mpeg4 = {
    .variant = {.name = "mpeg4", .doc = "MPEG-4 part 2, in every libavcodec (mp4, mkv)"},
    .encoder = "mpeg4", .threads = 1, .pixel_format = "yuv420p",
    .options = {{"flags", "+qscale", false}, {"global_quality", "354", false}}};

static const struct codec_row ffv1 = {
    .variant = {.name = "ffv1", .doc = "lossless, every pixel as drawn (mkv)"},
    .encoder = "ffv1", .threads = 4, .pixel_format = "bgr0",
    .options = {{"level", "3", false}, {"slices", "4", false}}};

static const struct codec_row gif = {
    .variant = {.name = "gif", .doc = "256 colours (gif)"},
    .encoder = "gif", .threads = 1, .pixel_format = "pal8",
    .options = {{"gifflags", "0", false}}}; /* frames have different palettes: nothing to share */

static const struct codec_row apng = {
    .variant = {.name = "apng", .doc = "lossless (apng)"},
    .encoder = "apng", .threads = 1, .pixel_format = "rgb24",
    .options = {{"pred", "sub", false}, {"compression_level", "4", false}}};

static const struct codec_row raw = {
    .variant = {.name = "raw", .doc = "not compressed (y4m)"},
    .encoder = "wrapped_avframe", .threads = 1, .pixel_format = "yuv420p"};

static const struct variant *const rows[] = {
    &h264.variant, &h264_nvenc.variant, &hevc.variant,  &hevc_nvenc.variant,
    &av1.variant,  &av1_aom.variant,    &vp9.variant,   &mpeg4.variant,
    &ffv1.variant, &gif.variant,        &apng.variant,  &raw.variant,
};

const struct variant_table codec_table = {
    .name = "codecs",
    .doc = "how a film is compressed (movie.codec), as far as the machine's libavcodec has it",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
