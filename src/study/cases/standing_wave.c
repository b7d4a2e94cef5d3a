/* Case "standing-wave": frequency, damping and amplitude of a small wave. */
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/exact.h"
#include "study/reference/fit.h"

#include <math.h>

static double depth(const struct scene *scene)
{
    return scene->bodies[0].shape.max[1] - scene->bodies[0].shape.min[1];
}

static struct exact_wave potential_wave(const struct scene *scene)
{
    return exact_wave(depth(scene), scene->bodies[0].flow_length, case_viscosity(scene),
                      -scene->gravity[1]);
}

static double interval(const struct scene *scene)
{
    return 2 * M_PI / potential_wave(scene).frequency / 28;
}

static const char *lacks(const struct scene *scene)
{
    if (!case_has_flow(scene, "standing-wave") || scene->bodies[0].flow_speed == 0 ||
        !case_has_shape(scene, SHAPE_BOX))
        return "a first body that is a box with the flow \"standing-wave\"";
    return case_has_gravity_down(scene) ? NULL : "gravity along -y";
}

static void measure(const struct scene *scene, FILE *out)
{
    const struct scene_body *body = &scene->bodies[0];
    fprintf(out, "{\"quantity\": \"wave\", \"wavelength\": %.17g, \"at\": ", body->flow_length);
    case_write_point(out, body->flow_center);
    fputs("}", out);
}

/* U = a omega / sinh kH, as the flow "standing-wave" has it. */
static double exact_amplitude(const struct scene *scene)
{
    const struct scene_body *body = &scene->bodies[0];
    return fabs(body->flow_speed) * sinh(2 * M_PI / body->flow_length * depth(scene)) /
           potential_wave(scene).frequency;
}

/* The level is A cos kx, A = 2 H <cos kx> of all particles: settling leaves it alone. Without viscosity
 * there is no damping to compare. */
static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    const double *mean = columns_need(columns, "wave.cosine", e);
    if (!mean)
        return e->status;
    struct exact_wave wave = potential_wave(scene);
    struct exact_wave viscous = exact_viscous_wave(depth(scene), scene->bodies[0].flow_length,
                                                   case_viscosity(scene), -scene->gravity[1]);
    struct fit_wave fit = fit_damped_wave(columns_time(columns), mean, columns->rows,
                                          wave.frequency, wave.damping);
    study_error_add(errors, fit.frequency / wave.frequency - 1, "%", 0.01,
                    "frequency, of sqrt(g k tanh kH)");
    if (wave.damping > 0)
        study_error_add(errors, fit.damping / wave.damping - 1, "%", 0.1,
                        "damping rate, of 2 nu k^2");
    study_error_add(errors, fit.frequency / viscous.frequency - 1, "%", 0.01,
                    "frequency, of linear viscous theory");
    if (wave.damping > 0)
        study_error_add(errors, fit.damping / viscous.damping - 1, "%", 0.1,
                        "damping rate, of the same");
    study_error_add(errors, 2 * depth(scene) * fit.amplitude / exact_amplitude(scene) - 1, "%",
                    NAN, "amplitude");
    return STATUS_OK;
}

extern const struct case_row case_standing_wave;
const struct case_row case_standing_wave = {
    .variant = {.name = "standing-wave",
                .doc = "frequency, damping and amplitude of a small wave, against potential flow "
                       "and viscous theory (Lamb, arts. 348, 349)"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
