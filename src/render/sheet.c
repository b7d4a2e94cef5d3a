/* Lays pictures out as a contact sheet. */
#include "render/sheet.h"

#include "base/vectors.h"
#include "render/camera.h"
#include "render/overlay.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The time stamp stands so many text sizes above the lower edge of an image: so high is the band
 * under a picture that it falls into. */
static const double band_sizes = 2.6;

enum { LABEL_WIDTH = 216, LABEL_HEIGHT = 140 }; /* the least picture that text is written over */

struct sheet {
    int cells[2];
    int count;               /* pictures so far */
    int gap, band;           /* pixels between columns, and under a picture */
    struct image image, cell; /* the sheet; a picture with its band, and room above and beside it that
                                 the smallest text asks for */
    int width, height;        /* of a picture, pixels */
    struct scene labels;     /* a scene that asks for nothing but a time stamp */
    struct render_setup setup; /* of the labels */
    struct overlay *overlay;
};

/* The picture that labels are made for: small ones get the smallest text rather than none. */
static void label_scene(const struct scene *scene, struct scene *labels)
{
    memset(labels, 0, sizeof *labels);
    memcpy(labels->render.background, scene->render.background, sizeof labels->render.background);
    labels->render.time = true;
    labels->movie.size[0] = scene->movie.size[0] > LABEL_WIDTH ? scene->movie.size[0] : LABEL_WIDTH;
    labels->movie.size[1] =
        scene->movie.size[1] > LABEL_HEIGHT ? scene->movie.size[1] : LABEL_HEIGHT;
    labels->movie.fps = 1000; /* time with three decimals */
    labels->movie.speed = 1;
}

static void measure(const struct scene *scene, int *gap, int *band)
{
    struct scene labels;
    label_scene(scene, &labels);
    double text = camera_text_size(&labels);
    *gap = (int)ceil(text);
    *band = (int)ceil(band_sizes * text);
}

void sheet_size(const struct scene *scene, const int cells[2], int size[2])
{
    int gap, band;
    measure(scene, &gap, &band);
    size[0] = gap + cells[0] * (scene->movie.size[0] + gap);
    size[1] = gap + cells[1] * (scene->movie.size[1] + band);
}

static void fill(struct image *image, const double color[3])
{
    uint8_t pixel[4] = {0, 0, 0, 255};
    for (int k = 0; k < 3; k++)
        pixel[k] = (uint8_t)lround(255 * fmin(1, fmax(0, color[k])));
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
        memcpy(image->rgba + 4 * i, pixel, sizeof pixel);
}

enum status sheet_open(struct sheet **sheet, const struct render_setup *setup, const int cells[2],
                       struct error *e)
{
    const struct scene *scene = setup->scene;
    const int *picture = scene->movie.size;
    struct sheet *s = calloc(1, sizeof *s);
    int size[2];
    *sheet = NULL;
    if (!s)
        return error_set(e, STATUS_RUN, "out of memory");
    memcpy(s->cells, cells, sizeof s->cells);
    label_scene(scene, &s->labels);
    measure(scene, &s->gap, &s->band);
    sheet_size(scene, cells, size);
    s->setup.scene = &s->labels;
    s->width = picture[0];
    s->height = picture[1];
    if (s->labels.movie.size[1] < picture[1] + s->band)
        s->labels.movie.size[1] = picture[1] + s->band;
    if (image_create(&s->image, size[0], size[1], e) ||
        image_create(&s->cell, s->labels.movie.size[0], s->labels.movie.size[1], e) ||
        overlay_open(&s->overlay, &s->setup, e)) {
        sheet_close(s);
        return e->status;
    }
    fill(&s->image, scene->render.background);
    if (setup->vectors && vectors_start(&s->image, e)) {
        sheet_close(s);
        return e->status;
    }
    *sheet = s;
    return STATUS_OK;
}

void sheet_add(struct sheet *s, double time, struct image *picture)
{
    int column = s->count % s->cells[0], row = s->count / s->cells[0];
    size_t left = (size_t)(s->gap + column * (s->width + s->gap));
    size_t top = (size_t)(s->gap + row * (s->height + s->band));
    size_t line = (size_t)s->width * 4, above = (size_t)(s->cell.height - s->band - s->height);
    if (row >= s->cells[1])
        return;
    s->count++;
    fill(&s->cell, s->labels.render.background);
    uint8_t *cell = s->cell.rgba + above * (size_t)s->cell.width * 4;
    for (size_t y = 0; y < (size_t)s->height; y++)
        memcpy(cell + y * (size_t)s->cell.width * 4, picture->rgba + y * line, line);
    overlay_draw(s->overlay, &(struct render_frame){.time = time}, &s->cell);
    for (size_t y = 0; y < (size_t)(s->height + s->band); y++)
        memcpy(s->image.rgba + ((top + y) * (size_t)s->image.width + left) * 4,
               cell + y * (size_t)s->cell.width * 4, line);
    if (s->image.plain) {
        vectors_move(picture, &s->image, (int)left, (int)top);
        overlay_record(&s->setup, &(struct render_frame){.time = time}, &s->image, (int)left,
                       (int)top - (int)above);
    }
}

const struct image *sheet_image(const struct sheet *sheet)
{
    return &sheet->image;
}

void sheet_close(struct sheet *sheet)
{
    if (!sheet)
        return;
    overlay_close(sheet->overlay);
    image_free(&sheet->image);
    image_free(&sheet->cell);
    free(sheet);
}
