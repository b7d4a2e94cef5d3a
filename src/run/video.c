/* Hands the scene's wishes about compression to encoders, and says which of them no output heeds. */
#include "run/video.h"

#include "base/log.h"
#include "encode/container.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* NULL leaves it to the codec. */
static const char *said(const char *text)
{
    return strcmp(text, "auto") == 0 || !text[0] ? NULL : text;
}

struct encode_video video_of_scene(const struct scene *scene, char crf[VIDEO_NUMBER])
{
    snprintf(crf, VIDEO_NUMBER, "%g", scene->movie.crf);
    return (struct encode_video){.codec = said(scene->movie.codec),
                                 .crf = isnan(scene->movie.crf) ? NULL : crf,
                                 .preset = said(scene->movie.preset),
                                 .tune = said(scene->movie.tune),
                                 .pixel_format = said(scene->movie.pixel_format),
                                 .options = said(scene->movie.options)};
}

static bool chooses(const struct encoder_row *row)
{
    return row->container && row->container->chooses;
}
static bool formats(const struct encoder_row *row)
{
    return row->container && row->container->formats;
}
static bool is_film(const struct encoder_row *row)
{
    return row->container;
}
static bool is_drawn(const struct encoder_row *row)
{
    return row->wants_pixels && row->extensions[0][0] == '.';
}

/* "mp4, webm, mkv" */
static void names_of(bool (*heeds)(const struct encoder_row *), char *text, size_t size)
{
    size_t used = 0;
    text[0] = 0;
    for (size_t i = 0; i < encode_table.count; i++)
        if (heeds((const struct encoder_row *)encode_table.rows[i]) && used < size)
            used += (size_t)snprintf(text + used, size - used, "%s%s", used ? ", " : "",
                                     encode_table.rows[i]->name);
}

void video_warn(const struct scene *scene, const struct encode_video *video, const char *const *outputs, size_t count)
{
    const struct {
        const char *key, *value;
        bool (*heeds)(const struct encoder_row *);
    } rows[] = {{"codec", video->codec, chooses},   {"crf", video->crf, chooses},
                {"preset", video->preset, chooses}, {"tune", video->tune, chooses},
                {"options", video->options, chooses},
                {"pixel_format", video->pixel_format, formats}};
    char names[80];
    if (scene->render.transparent && !video->pixel_format && encode_any(outputs, count, is_film))
        log_info("warning: the film has no alpha, so that render.transparent makes its background black; movie.pixel_format "
                 "yuva420p (webm, vp9) or bgra (mkv, ffv1) has some");
    if (!encode_any(outputs, count, is_drawn))
        return;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!rows[i].value || encode_any(outputs, count, rows[i].heeds))
            continue;
        names_of(rows[i].heeds, names, sizeof names);
        log_info("warning: movie.%s has no effect: it is for %s, and no output is one", rows[i].key, names);
    }
}
