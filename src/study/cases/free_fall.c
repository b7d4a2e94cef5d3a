/* Case "free-fall": height of what falls freely, against a parabola. */
#include "study/cases/case.h"

#include <math.h>

/* Only the first and the last row are read. */
static double interval(const struct scene *scene)
{
    (void)scene;
    return 0.05;
}

static const char *lacks(const struct scene *scene)
{
    return scene->gravity[1] == 0 ? "gravity along y" : NULL;
}

static void measure(const struct scene *scene, FILE *out)
{
    (void)scene;
    fputs("{\"quantity\": \"extent\"}", out);
}

static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    const double *low = columns_need(columns, "extent.y.min", e);
    if (!low)
        return e->status;
    double t = columns_time(columns)[columns->rows - 1];
    double fallen = low[0] + scene->bodies[0].velocity[1] * t + scene->gravity[1] * t * t / 2;
    study_error_add(errors, low[columns->rows - 1] - fallen, "m", NAN, "height");
    return STATUS_OK;
}

extern const struct case_row case_free_fall;
const struct case_row case_free_fall = {
    .variant = {.name = "free-fall", .doc = "height of what falls, against y + v t + g t^2/2"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
