/* Case "square-patch": a rotating square without forces, which keeps its energy and momentum. */
#include "study/cases/case.h"
#include "study/cases/case_scene.h"

#include <math.h>

/* A tenth of the time of a turn by one radian. */
static double interval(const struct scene *scene)
{
    return 0.1 * scene->bodies[0].flow_length / fabs(scene->bodies[0].flow_speed);
}

static const char *lacks(const struct scene *scene)
{
    if (!case_has_flow(scene, "rotation") || scene->bodies[0].flow_speed == 0)
        return "the flow \"rotation\" in the first body";
    return NULL;
}

static void measure(const struct scene *scene, FILE *out)
{
    fputs("{\"quantity\": \"energy\"}, {\"quantity\": \"angular-momentum\", \"at\": ", out);
    case_write_point(out, scene->bodies[0].flow_center);
    fputs("}", out);
}

static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    const double *energy = columns_need(columns, "energy.kinetic", e);
    const double *turning = energy ? columns_need(columns, "angular-momentum.z", e) : NULL;
    (void)scene;
    if (!turning)
        return e->status;
    study_error_add(errors, case_change(columns, energy), "%", 0.004, "kinetic energy, drift");
    study_error_add(errors, case_change(columns, turning), "%", NAN, "angular momentum, drift");
    return STATUS_OK;
}

extern const struct case_row case_square_patch;
const struct case_row case_square_patch = {
    .variant = {.name = "square-patch",
                .doc = "kinetic energy and angular momentum of a rotating square patch, which it "
                       "keeps (Colagrossi 2005)"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
