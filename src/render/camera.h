/* Where the picture is taken from: camera keys of the scene, orbit, and automatic framing. */
#ifndef RENDER_CAMERA_H
#define RENDER_CAMERA_H

#include "scene/scene.h"

#include <stdbool.h>

/* All lengths in m, positions relative to domain.min; computed in double because a domain may lie
 * far from the origin. */
struct camera {
    double eye[3];
    double right[3], up[3], forward[3]; /* orthonormal */
    double tan_x, tan_y;                /* half the picture's width and height at distance 1 */
    int width, height;                  /* pixels */
    bool orthographic;                  /* all rays run along `forward`; tan_x and tan_y are 0 */
    double half_x, half_y;              /* orthographic: half the picture's width and height, m */
};

/* Half the picture's width and height where a ray's length along `forward` is 1; when orthographic
 * anywhere, m. A point (x, y, z) in camera axes is at x / (z * half), or when orthographic at x / half: from
 * -1 at the left and bottom edge to 1. */
static inline double camera_half_x(const struct camera *camera)
{
    return camera->orthographic ? camera->half_x : camera->tan_x;
}
static inline double camera_half_y(const struct camera *camera)
{
    return camera->orthographic ? camera->half_y : camera->tan_y;
}

/* The camera at `time` (s). A NAN eye frames the whole domain, seen from the front, a little from
 * the right and above (a deep one more from the right); spheres of `radius` (m) on its faces fit
 * too. Orthographic, the eye is moved back until the domain is in front of it, which changes
 * nothing but z. Whatever is not finite or degenerate in the scene is replaced by something that
 * shows the domain. */
void camera_make(struct camera *camera, const struct scene *scene, double radius, double time);

/* Height of text over the picture in pixels, by which its parts are laid out; 0: too small for
 * text. */
double camera_text_size(const struct scene *scene);

/* Into camera axes: x right, y up, z distance in front of the eye. */
void camera_view(const struct camera *camera, const double point[3], double view[3]);

/* Writes "camera": {...} of a scene file that shows what camera_make does: still as at the time, or
 * for several times with a keyframe for each. */
void camera_write(const struct scene *scene, double radius, const double *times, size_t count,
                  FILE *out);

/* Corner `i` (bits: x y z at max) of the domain, relative to domain.min, grown by `margin` m. */
void camera_corner(const struct scene *scene, int i, double margin, double corner[3]);

#endif
