/* Case "capillary-drop": a sphere that oscillates by surface tension in its second mode. */
#include "base/memory.h"
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/exact.h"
#include "study/reference/fit.h"

#include <math.h>

static double frequency(const struct scene *scene)
{
    const struct scene_fluid *fluid = case_fluid(scene);
    return exact_capillary_frequency(fluid->surface_tension, fluid->density,
                                     scene->bodies[0].shape.radius);
}

static double interval(const struct scene *scene)
{
    return 2 * M_PI / frequency(scene) / 40;
}

static const char *lacks(const struct scene *scene)
{
    const struct scene_fluid *fluid = case_fluid(scene);
    if (!case_has_shape(scene, SHAPE_SPHERE) || !case_has_flow(scene, "elliptic"))
        return "a first body that is a sphere with the flow \"elliptic\"";
    return fluid->surface_tension > 0 && fluid->viscosity > 0 ? NULL
                                                              : "surface_tension and viscosity";
}

/* The pressure is that of the inner half. */
static void measure(const struct scene *scene, FILE *out)
{
    fputs("{\"quantity\": \"spread\"}, {\"quantity\": \"pressure\", \"at\": ", out);
    case_write_point(out, scene->bodies[0].shape.center);
    fprintf(out, ", \"radius\": %.17g}", scene->bodies[0].shape.radius / 2);
}

/* Of x^2 - y^2 by spreads, which passes zero each half period. */
static enum status find_oscillation(const struct columns *columns, const struct scene *scene,
                                    struct fit_oscillation *found, struct error *e)
{
    const double *x = columns_need(columns, "spread.x", e);
    const double *y = x ? columns_need(columns, "spread.y", e) : NULL;
    double *waves = y ? case_series(columns, e) : NULL;
    if (!waves)
        return e->status;
    for (size_t k = 0; k < columns->rows; k++)
        waves[k] = x[k] * x[k] - y[k] * y[k];
    bool whole = fit_oscillation(columns_time(columns), waves, columns->rows,
                                 2 * M_PI / frequency(scene) / 10, found);
    memory_free(waves);
    return whole ? STATUS_OK
                 : error_set(e, STATUS_RUN, "the drop does not oscillate for three half periods");
}

/* The pressure is the mean of the second half of the rows. */
static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    struct fit_oscillation found;
    const double *pressures = columns_need(columns, "pressure", e);
    if (!pressures || find_oscillation(columns, scene, &found, e))
        return e->status;
    double radius = scene->bodies[0].shape.radius, pressure = 0;
    double damping = log(found.first / found.last) / ((double)found.halves * found.half);
    size_t late = columns->rows / 2;
    for (size_t k = late; k < columns->rows; k++)
        pressure += pressures[k] / (double)(columns->rows - late);
    study_error_add(errors, found.half * frequency(scene) / M_PI - 1, "%", NAN, "period");
    study_error_add(errors, damping / exact_capillary_damping(case_viscosity(scene), radius) - 1,
                    "%", NAN, "damping");
    study_error_add(errors, pressure / (2 * case_fluid(scene)->surface_tension / radius) - 1, "%",
                    NAN, "pressure");
    return STATUS_OK;
}

extern const struct case_row case_capillary_drop;
const struct case_row case_capillary_drop = {
    .variant = {.name = "capillary-drop",
                .doc = "period, damping and pressure of a sphere under surface tension (Rayleigh "
                       "1879; Lamb, art. 355; Laplace)"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
