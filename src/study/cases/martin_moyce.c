/* Case "martin-moyce": front and height of a column of water that collapses, against experiment. */
#include "study/reference/martin_moyce.h"

#include "base/memory.h"
#include "study/cases/case.h"
#include "study/cases/case_scene.h"

#include <math.h>

static double interval(const struct scene *scene)
{
    return scene->time.end / 200;
}

/* The tables are of columns twice as high as wide, and of any width by its scales. */
static const char *lacks(const struct scene *scene)
{
    const struct scene_body *body = &scene->bodies[0];
    if (!case_has_gravity_down(scene))
        return "gravity along -y";
    double width = body->shape.max[0] - body->shape.min[0], height = body->shape.max[1] - body->shape.min[1];
    return case_has_shape(scene, SHAPE_BOX) && fabs(height / width - 2) < 1e-3
               ? NULL : "a first body that is a box twice as high as wide along x";
}

/* Heights at a quarter, half and three quarters of the back wall's length. */
static void measure(const struct scene *scene, FILE *out)
{
    const struct scene_body *body = &scene->bodies[0];
    fputs("{\"quantity\": \"front\"}", out);
    for (int k = 1; k <= 3; k++) {
        double foot[3] = {body->shape.min[0], body->shape.min[1],
                          body->shape.min[2] + k / 4.0 * (body->shape.max[2] - body->shape.min[2])};
        fprintf(out, ", {\"quantity\": \"height\", \"name\": \"wall%d\", \"at\": ", k);
        case_write_point(out, foot);
        fputs("}", out);
    }
}

static double median(double a, double b, double c)
{
    return fmax(fmin(a, b), fmin(fmax(a, b), c));
}

static enum status compare_heights(const struct columns *columns,
                                   const struct martin_moyce_column *column,
                                   struct martin_moyce_errors *found, struct error *e)
{
    static const char *const names[3] = {"wall1", "wall2", "wall3"};
    const double *walls[3];
    for (int k = 0; k < 3; k++)
        if (!(walls[k] = columns_need(columns, names[k], e)))
            return e->status;
    double *heights = case_series(columns, e);
    if (!heights)
        return e->status;
    for (size_t k = 0; k < columns->rows; k++)
        heights[k] = median(walls[0][k], walls[1][k], walls[2][k]);
    bool any = martin_moyce_compare_heights(column, columns_time(columns), heights, columns->rows,
                                            found);
    memory_free(heights);
    return any ? STATUS_OK
               : error_set(e, STATUS_RUN, "the run ends before the first measured height");
}

/* Fronts from the back wall on. */
static enum status compare_fronts(const struct columns *columns, double wall,
                                  const struct martin_moyce_column *column,
                                  struct martin_moyce_errors *found, struct error *e)
{
    const double *places = columns_need(columns, "front.position", e);
    double *fronts = places ? case_series(columns, e) : NULL;
    if (!fronts)
        return e->status;
    for (size_t k = 0; k < columns->rows; k++)
        fronts[k] = places[k] - wall;
    bool any = martin_moyce_compare_fronts(column, columns_time(columns), fronts, columns->rows,
                                           found);
    memory_free(fronts);
    return any ? STATUS_OK
               : error_set(e, STATUS_RUN, "the front does not pass Z = 1.67, where it is compared");
}

static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    const struct scene_body *body = &scene->bodies[0];
    struct martin_moyce_column column = {body->shape.max[0] - body->shape.min[0], -scene->gravity[1]};
    struct martin_moyce_errors front, height;
    if (compare_fronts(columns, body->shape.min[0], &column, &front, e) ||
        compare_heights(columns, &column, &height, e))
        return e->status;
    study_error_add(errors, front.rms, "%", NAN, "time of the front, RMS");
    study_error_add(errors, front.outside, "%", NAN, "front outside of the runs");
    study_error_add(errors, height.rms, "%", NAN, "height at the wall, RMS, of 2 a");
    return STATUS_OK;
}

extern const struct case_row case_martin_moyce;
const struct case_row case_martin_moyce = {
    .variant = {.name = "martin-moyce",
                .doc = "front and height of a collapsing column, against the experiment of Martin "
                       "& Moyce (1952), tables 2 and 6"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
