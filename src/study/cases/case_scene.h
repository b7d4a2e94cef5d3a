/* What several cases read from a scene and its columns. */
#ifndef STUDY_CASE_SCENE_H
#define STUDY_CASE_SCENE_H

#include "scene/scene.h"
#include "study/reference/columns.h"

#include <stdio.h>

/* Of the first body: its fluid, and that fluid's kinematic viscosity, m^2/s. */
const struct scene_fluid *case_fluid(const struct scene *scene);
double case_viscosity(const struct scene *scene);

/* Whether the first body has that shape; whether it starts with that flow. */
bool case_has_shape(const struct scene *scene, enum shape_kind shape);
bool case_has_flow(const struct scene *scene, const char *flow);

/* Whether gravity is along -y. */
bool case_has_gravity_down(const struct scene *scene);

/* Middle of the first body, a box, m; and its mass, kg. */
void case_box_middle(const struct scene *scene, double middle[3]);
double case_box_mass(const struct scene *scene);

/* Writes a point as a JSON array. */
void case_write_point(FILE *out, const double x[3]);

/* The row of that time; STATUS_RUN when there is none. */
enum status case_row_at(const struct columns *columns, double time, size_t *row, struct error *e);

/* Change of a column from the first row to the last, of the first. */
double case_change(const struct columns *columns, const double *values);

/* Room for a number for each row, for memory_free; NULL with STATUS_RUN. */
double *case_series(const struct columns *columns, struct error *e);

#endif
