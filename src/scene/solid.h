/* Obstacles as fluid meets them: without the faces that lie on the domain's, at the nearest of their periodic
 * images. SI units. */
#ifndef SCENE_SOLID_H
#define SCENE_SOLID_H

#include "scene/scene.h"

struct solid {
    struct shape shape;    /* of the obstacle; faces that lie on the domain's are far outside it */
    bool open[FACE_COUNT]; /* sides that fluid reaches */
    double middle[3];      /* of the obstacle, m */
    double period[3];      /* m; 0: the axis is not periodic, or the obstacle fills it */
};

struct solid solid_make(const struct scene *scene, const struct scene_obstacle *obstacle);

/* As shape_distance and shape_push; p is in the domain, and stays where it is or is moved out. */
double solid_distance(const struct solid *solid, const double p[3]);
void solid_push(const struct solid *solid, double out, double p[3]);

#endif
