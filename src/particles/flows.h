/* Velocity fields that bodies may start with, and the pressure that goes with them where known. */
#ifndef PARTICLES_FLOWS_H
#define PARTICLES_FLOWS_H

#include "base/variant.h"
#include "scene/scene.h"

/* x is the position relative to bodies[].flow_center, m; length, m; speed, m/s (either sign). */
struct flow_row {
    struct variant variant;
    /* Velocity, m/s; NULL: none anywhere. */
    void (*velocity)(const double x[3], double length, double speed, double v[3]);
    /* Pressure / (density speed^2); NULL: not known, or none. */
    double (*pressure)(const double x[3], double length);
};

extern const struct variant_table flow_table; /* "flows" */
extern const struct flow_row flow_none, flow_taylor_green, flow_beltrami, flow_rotation,
    flow_elliptic, flow_standing_wave, flow_shear;

/* Whether a body has neither velocity nor flow. */
bool flow_still(const struct scene_body *body);

/* Start velocity of a body's particle at x (absolute): its own plus the flow's, m/s. */
void flow_velocity(const struct scene_body *body, const double x[3], double v[3]);

/* Start pressure that goes with the body's flow at x in fluid of that density, Pa. */
double flow_pressure(const struct scene_body *body, double density, const double x[3]);

/* The largest start speed in a body, m/s, on a lattice of 17 points an edge over its bounds. */
double flow_fastest(const struct scene_body *body);

#endif
