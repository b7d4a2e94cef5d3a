/* Shapes that scenes are built of: boxes along the axes, spheres, cylinders. All are convex. SI units. */
#ifndef SCENE_SHAPE_H
#define SCENE_SHAPE_H

#include <stdbool.h>

enum shape_kind { SHAPE_BOX, SHAPE_SPHERE, SHAPE_CYLINDER };

struct shape {
    enum shape_kind kind;
    double min[3], max[3]; /* m; box */
    double center[3];      /* m; sphere; middle of a cylinder's axis */
    double radius, height; /* m; sphere and cylinder; cylinder's full height along axis */
    int axis;              /* cylinder: 0 x, 1 y, 2 z */
};

/* "box", "sphere", "cylinder". */
extern const char *const shape_words[];

/* Volume, m^3; the bounding box. */
double shape_volume(const struct shape *shape);
void shape_bounds(const struct shape *shape, double min[3], double max[3]);

/* Whether flat faces bound it along the axis: all of a box, the caps of a cylinder. */
bool shape_is_flat(const struct shape *shape, int axis);

/* Whether p, which lies in the bounding box, is inside. */
bool shape_contains(const struct shape *shape, const double p[3]);

/* Distance of p from the surface, m: below 0 inside. */
double shape_distance(const struct shape *shape, const double p[3]);

/* Moves p to the place that is `out` metres outside the nearest point of the surface, if it is nearer than that or
 * inside. */
void shape_push(const struct shape *shape, double out, double p[3]);

/* Whether two shapes share more than `slack` metres. */
bool shape_overlap(const struct shape *a, const struct shape *b, double slack);

#endif
