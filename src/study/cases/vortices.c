/* Cases "taylor-green" and "beltrami": vortices that decay exponentially. */
#include "base/memory.h"
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/exact.h"
#include "study/reference/norm.h"

#include <math.h>

/* Time in which the fastest flow goes its period, L/U, s. */
static double turnover(const struct scene *scene)
{
    return scene->bodies[0].flow_length / fabs(scene->bodies[0].flow_speed);
}

static double interval(const struct scene *scene)
{
    return turnover(scene) / 50;
}

static bool starts(const struct scene *scene, const char *flow)
{
    return case_has_flow(scene, flow) && scene->bodies[0].flow_speed != 0;
}

static const char *taylor_green_lacks(const struct scene *scene)
{
    return starts(scene, "taylor-green") ? NULL : "the flow \"taylor-green\" in the first body";
}

static const char *beltrami_lacks(const struct scene *scene)
{
    return starts(scene, "beltrami") ? NULL : "the flow \"beltrami\" in the first body";
}

/* Of velocity, 1/s. */
static double taylor_green_decay(const struct scene *scene)
{
    return exact_taylor_green_rate(case_viscosity(scene), scene->bodies[0].flow_length);
}

static double beltrami_decay(const struct scene *scene)
{
    return exact_beltrami_rate(case_viscosity(scene), scene->bodies[0].flow_length);
}

static void measure_decay(const struct scene *scene, double decay, FILE *out)
{
    const struct scene_body *body = &scene->bodies[0];
    fprintf(out, "{\"quantity\": \"energy\"}, {\"quantity\": \"flow-error\", \"flow\": \"%s\", "
            "\"flow_length\": %.17g, \"flow_speed\": %.17g, \"decay\": %.17g, \"flow_center\": ",
            body->flow, body->flow_length, body->flow_speed, decay);
    case_write_point(out, body->flow_center);
    fputs("}", out);
}

static void measure_taylor_green(const struct scene *scene, FILE *out)
{
    measure_decay(scene, taylor_green_decay(scene), out);
}

static void measure_beltrami(const struct scene *scene, FILE *out)
{
    measure_decay(scene, beltrami_decay(scene), out);
}

/* Kinetic energies, of the first one, against e^(-2 decay t): that of a row, and L2 over rows. */
static enum status compare_energy(const struct columns *columns, const double *energy, double decay,
                                  size_t row, struct study_errors *errors, struct error *e)
{
    double *parts = case_series(columns, e), *exact = parts ? case_series(columns, e) : NULL;
    if (exact) {
        for (size_t k = 0; k < columns->rows; k++) {
            parts[k] = energy[k] / energy[0];
            exact[k] = exp(-2 * decay * columns_time(columns)[k]);
        }
        study_error_add(errors, parts[row] / exact[row] - 1, "%", 0.05,
                        "kinetic energy at t = %g s", columns_time(columns)[row]);
        study_error_add(errors, norm_l2(parts, exact, columns->rows), "%", NAN,
                        "kinetic energy, L2");
    }
    memory_free(parts);
    memory_free(exact);
    return exact ? STATUS_OK : e->status;
}

static enum status vortices(const struct columns *columns, const struct scene *scene, double decay,
                            struct study_errors *errors, struct error *e)
{
    const double *energy = columns_need(columns, "energy.kinetic", e);
    const double *speed = energy ? columns_need(columns, "flow-error.speed", e) : NULL;
    size_t row = 0, last = columns->rows - 1;
    if (!speed || case_row_at(columns, turnover(scene), &row, e) ||
        compare_energy(columns, energy, decay, row, errors, e))
        return e->status;
    study_error_add(errors, speed[last], "%", 0.03, "speed, L1 at t = %g s",
                    columns_time(columns)[last]);
    return STATUS_OK;
}

static enum status compare_taylor_green(const struct columns *columns, const struct scene *scene,
                                        struct study_errors *errors, struct error *e)
{
    return vortices(columns, scene, taylor_green_decay(scene), errors, e);
}

static enum status compare_beltrami(const struct columns *columns, const struct scene *scene,
                                    struct study_errors *errors, struct error *e)
{
    return vortices(columns, scene, beltrami_decay(scene), errors, e);
}

extern const struct case_row case_taylor_green, case_beltrami;
const struct case_row case_taylor_green = {
    .variant = {.name = "taylor-green",
                .doc = "plane vortices that decay, against e^(-2 nu k^2 t) (Taylor & Green 1937)"},
    .interval = interval, .lacks = taylor_green_lacks, .measure = measure_taylor_green,
    .compare = compare_taylor_green};
const struct case_row case_beltrami = {
    .variant = {.name = "beltrami",
                .doc = "ABC flow that decays, against e^(-nu k^2 t) (Dombre et al. 1986)"},
    .interval = interval, .lacks = beltrami_lacks, .measure = measure_beltrami,
    .compare = compare_beltrami};
