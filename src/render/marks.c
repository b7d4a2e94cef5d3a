/* Marks of space over a picture: a length, and the directions of the axes. */
#include "render/marks.h"

#if HAVE_CAIRO

#include "render/ticks.h"

#include <math.h>
#include <stdio.h>

#define BAR_MOST 0.2 /* of the picture's width */

/* Orthographic, a length is the same everywhere. */
static void length_text(char *text, size_t size, double metres, bool orthographic)
{
    static const struct { double least; const char *name; } units[] = {
        {1000, "km"}, {1, "m"}, {0.01, "cm"}, {0.001, "mm"}, {1e-6, "\u00b5m"}, {0, "nm"}};
    static const double scales[] = {1e-3, 1, 100, 1000, 1e6, 1e9};
    size_t u = 0;
    while (metres < units[u].least * (1 - 1e-9))
        u++;
    snprintf(text, size, "%g %s%s", metres * scales[u], units[u].name,
             orthographic ? "" : " at target");
}

/* Distance of the target along the line of sight, m. */
static double target_distance(const struct scene *scene, const struct camera *camera)
{
    double target[3], view[3];
    for (int a = 0; a < 3; a++) {
        double edge = scene->domain.max[a] - scene->domain.min[a];
        target[a] = isnan(scene->camera.eye[0]) || isnan(scene->camera.target[0])
                        ? edge / 2
                        : scene->camera.target[a] - scene->domain.min[a];
    }
    camera_view(camera, target, view);
    return view[2];
}

void marks_bar_size(const struct ink *ink, const struct scene *scene, cairo_t *cr, double *width,
                    double *height)
{
    char text[64];
    length_text(text, sizeof text, 500e-6, scene->camera.projection == PROJECTION_ORTHOGRAPHIC);
    *width = ceil(fmax(BAR_MOST * scene->movie.size[0], ink_width(cr, text)));
    *height = ceil(ink->size * 2);
}

void marks_bar_draw(const struct ink *ink, const struct scene *scene, const struct camera *camera,
                    const struct layout_box *box, cairo_t *cr)
{
    double reach = camera->orthographic ? 1 : target_distance(scene, camera), cap = ink->size * 0.3;
    double right = floor(box->x + box->width) - 0.5, y = floor(box->y + box->height - cap) - 0.5;
    double pixels = camera->height / (2 * camera_half_y(camera) * reach); /* of a metre */
    char text[64];
    if (!(reach > 0) || !isfinite(pixels))
        return;
    double metres = ticks_round(BAR_MOST * camera->width / pixels), left;
    left = right - round(metres * pixels);
    cairo_move_to(cr, left, y - cap);
    cairo_line_to(cr, left, y + cap);
    cairo_move_to(cr, left, y);
    cairo_line_to(cr, right, y);
    cairo_move_to(cr, right, y - cap);
    cairo_line_to(cr, right, y + cap);
    ink_stroke(ink, cr, fmax(1, round(ink->size / 12)), NULL);
    length_text(text, sizeof text, metres, camera->orthographic);
    ink_text(ink, cr, right - ink_width(cr, text), y - ink->size * 0.6, text);
}

double marks_axes_size(const struct ink *ink)
{
    return ceil(ink->size * 5.4);
}

/* One axis as an arrow with its letter; along the line of sight only its letter is left. */
static void axis_draw(const struct ink *ink, const struct camera *camera, int axis,
                      const double middle[2], cairo_t *cr)
{
    static const double colors[3][3] = {{0.80, 0.16, 0.13}, {0.12, 0.55, 0.20}, {0.16, 0.36, 0.86}};
    static const char *const letters[] = {"x", "y", "z"};
    double x = camera->right[axis], y = -camera->up[axis], size = ink->size;
    double length = sqrt(x * x + y * y), reach = 1.7 * size, head = 0.42 * size;
    double end[2] = {middle[0] + reach * x, middle[1] + reach * y};
    cairo_move_to(cr, middle[0], middle[1]);
    cairo_line_to(cr, end[0], end[1]);
    if (length * reach > head) {
        double ux = x / length * head, uy = y / length * head;
        cairo_move_to(cr, end[0] - ux + 0.5 * uy, end[1] - uy - 0.5 * ux);
        cairo_line_to(cr, end[0], end[1]);
        cairo_line_to(cr, end[0] - ux - 0.5 * uy, end[1] - uy + 0.5 * ux);
    }
    ink_stroke(ink, cr, fmax(1, size / 9), colors[axis]);
    double away = length > 0.05 ? 0.5 * size / length : 0; /* the letter beyond the arrow's end */
    ink_text(ink, cr, end[0] + away * x - 0.3 * size, end[1] + away * y + 0.27 * size,
             letters[axis]);
}

void marks_axes_draw(const struct ink *ink, const struct camera *camera,
                     const struct layout_box *box, cairo_t *cr)
{
    double middle[2] = {box->x + box->width / 2, box->y + box->height / 2};
    int order[3] = {0, 1, 2}; /* the farthest first */
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            if (camera->forward[order[k]] < camera->forward[order[k + 1]]) {
                int swap = order[k];
                order[k] = order[k + 1];
                order[k + 1] = swap;
            }
    for (int i = 0; i < 3; i++)
        axis_draw(ink, camera, order[i], middle, cr);
}

#endif
