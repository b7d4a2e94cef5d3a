/* Case "free-fall": height of what falls from rest, against a parabola. */
#include "study/case.h"

#include <math.h>

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
    double fallen = low[0] + scene->gravity[1] * t * t / 2;
    study_error_add(errors, low[columns->rows - 1] - fallen, "m", NAN, "height");
    return STATUS_OK;
}

const struct case_row case_free_fall = {
    .variant = {"free-fall", "height of what falls from rest, against y + g t^2/2", NULL, 0, NULL},
    .interval = 0.05, .measure = measure, .compare = compare};
