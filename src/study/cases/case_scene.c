/* What several cases read from a scene and its columns. */
#include "study/cases/case_scene.h"

#include "base/memory.h"

#include <string.h>

const struct scene_fluid *case_fluid(const struct scene *scene)
{
    return &scene->fluids[scene->bodies[0].fluid];
}

double case_viscosity(const struct scene *scene)
{
    return case_fluid(scene)->viscosity / case_fluid(scene)->density;
}

bool case_has_shape(const struct scene *scene, enum shape_kind shape)
{
    return scene->bodies[0].shape.kind == shape;
}

bool case_has_flow(const struct scene *scene, const char *flow)
{
    return strcmp(scene->bodies[0].flow, flow) == 0;
}

bool case_has_gravity_down(const struct scene *scene)
{
    const double *g = scene->gravity;
    return g[0] == 0 && g[1] < 0 && g[2] == 0;
}

void case_box_middle(const struct scene *scene, double middle[3])
{
    const struct scene_body *body = &scene->bodies[0];
    for (int a = 0; a < 3; a++)
        middle[a] = (body->shape.min[a] + body->shape.max[a]) / 2;
}

double case_box_mass(const struct scene *scene)
{
    const struct scene_body *body = &scene->bodies[0];
    double mass = case_fluid(scene)->density;
    for (int a = 0; a < 3; a++)
        mass *= body->shape.max[a] - body->shape.min[a];
    return mass;
}

void case_write_point(FILE *out, const double x[3])
{
    fprintf(out, "[%.17g, %.17g, %.17g]", x[0], x[1], x[2]);
}

enum status case_row_at(const struct columns *columns, double time, size_t *row, struct error *e)
{
    long at = columns_row(columns, time);
    if (at < 0)
        return error_set(e, STATUS_RUN, "there is no row at %g s, where the case compares", time);
    *row = (size_t)at;
    return STATUS_OK;
}

double case_change(const struct columns *columns, const double *values)
{
    return values[columns->rows - 1] / values[0] - 1;
}

double *case_series(const struct columns *columns, struct error *e)
{
    return memory_create("studies", columns->rows, sizeof(double), e);
}
