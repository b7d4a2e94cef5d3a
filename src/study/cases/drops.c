/* Cases "elliptic-drop" and "oscillating-drop": round drops, thin along z, that become ellipses. */
#include "base/memory.h"
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/exact.h"
#include "study/reference/fit.h"

#include <math.h>

static const char axis_names[2] = {'x', 'y'};

/* Rate of the start flow sigma (-x, y), 1/s. */
static double stretching(const struct scene *scene)
{
    return scene->bodies[0].flow_speed / scene->bodies[0].flow_length;
}

static const char *elliptic_lacks(const struct scene *scene)
{
    if (!case_has_shape(scene, SHAPE_CYLINDER) || scene->bodies[0].shape.axis != 2)
        return "a first body that is a cylinder along z";
    if (!case_has_flow(scene, "elliptic") || scene->bodies[0].flow_speed == 0)
        return "the flow \"elliptic\" in the first body";
    return NULL;
}

static const char *oscillating_lacks(const struct scene *scene)
{
    return scene->central_force.frequency > 0 ? elliptic_lacks(scene) : "a central_force";
}

static double elliptic_interval(const struct scene *scene)
{
    return scene->time.end / 20;
}

static double oscillating_interval(const struct scene *scene)
{
    return 0.05 / scene->central_force.frequency;
}

static void measure_elliptic(const struct scene *scene, FILE *out)
{
    (void)scene;
    fputs("{\"quantity\": \"energy\"}, {\"quantity\": \"spread\"}, {\"quantity\": \"extent\"}", out);
}

static void measure_oscillating(const struct scene *scene, FILE *out)
{
    (void)scene;
    fputs("{\"quantity\": \"spread\"}", out);
}

/* Columns of a drop by axis, x and y; NULL where not measured. */
struct drop {
    const double *spread[2];
    const double *min[2], *max[2], *low[2], *high[2];
    double spacing;
};

static enum status read_spread(struct drop *drop, const struct columns *columns,
                               const struct scene *scene, struct error *e)
{
    drop->spacing = scene->particles.spacing;
    drop->spread[0] = columns_need(columns, "spread.x", e);
    drop->spread[1] = drop->spread[0] ? columns_need(columns, "spread.y", e) : NULL;
    return drop->spread[1] ? STATUS_OK : e->status;
}

static enum status read_extents(struct drop *drop, const struct columns *columns, struct error *e)
{
    static const char *const names[2][4] = {
        {"extent.x.min", "extent.x.max", "extent.x.low", "extent.x.high"},
        {"extent.y.min", "extent.y.max", "extent.y.low", "extent.y.high"}};
    for (int a = 0; a < 2; a++) {
        const double **const places[4] = {&drop->min[a], &drop->max[a], &drop->low[a],
                                          &drop->high[a]};
        for (int k = 0; k < 4; k++)
            if (!(*places[k] = columns_need(columns, names[a][k], e)))
                return e->status;
    }
    return STATUS_OK;
}

/* Semi-axes along axis a, m, in that row, by second moments: a uniform ellipse has a quarter of its
 * semi-axis squared, and a particle counts as a square of side d, of moment d^2/12. */
static double by_moments(const struct drop *drop, int a, size_t row)
{
    double spread = drop->spread[a][row];
    return 2 * sqrt(spread * spread + drop->spacing * drop->spacing / 12);
}

/* By the coordinates that 99.5 % of the particles do not pass, on either side. */
static double by_quantiles(const struct drop *drop, int a, size_t row)
{
    return (drop->high[a][row] - drop->low[a][row]) / 2 / exact_ellipse_reach(0.005);
}

/* By the outermost particles, which lie half a spacing inside. */
static double by_outermost(const struct drop *drop, int a, size_t row)
{
    return (drop->max[a][row] - drop->min[a][row] + drop->spacing) / 2;
}

/* What the measuring itself errs: the drop is round at first. */
static void add_start(const struct drop *drop, const struct scene *scene,
                      struct study_errors *errors)
{
    for (int a = 0; a < 2; a++)
        study_error_add(errors, by_moments(drop, a, 0) / scene->bodies[0].shape.radius - 1, "%", NAN,
                        "semi-axis along %c by moments at t = 0", axis_names[a]);
}

static void add_axes(const struct drop *drop, size_t row, const struct exact_ellipse *exact,
                     struct study_errors *errors)
{
    static const struct {
        const char *name;
        double (*axis)(const struct drop *drop, int a, size_t row);
        double asked;
    } ways[3] = {{"moments", by_moments, 0.01},
                 {"99.5 % extents", by_quantiles, NAN},
                 {"outermost particles", by_outermost, NAN}};
    for (int way = 0; way < 3; way++)
        for (int a = 0; a < 2; a++)
            study_error_add(errors, ways[way].axis(drop, a, row) / exact->axes[a] - 1, "%",
                            ways[way].asked, "%s semi-axis by %s",
                            exact->axes[a] < exact->axes[1 - a] ? "short" : "long",
                            ways[way].name);
}

static enum status compare_elliptic(const struct columns *columns, const struct scene *scene,
                                    struct study_errors *errors, struct error *e)
{
    struct drop drop = {.spacing = 0};
    size_t last = columns->rows - 1;
    const double *energy = columns_need(columns, "energy.kinetic", e);
    if (!energy || read_spread(&drop, columns, scene, e) || read_extents(&drop, columns, e))
        return e->status;
    struct exact_ellipse exact = exact_ellipse(columns_time(columns)[last], stretching(scene),
                                               scene->bodies[0].shape.radius);
    add_axes(&drop, last, &exact, errors);
    add_start(&drop, scene, errors);
    study_error_add(errors, case_change(columns, energy), "%", NAN, "kinetic energy, drift");
    return STATUS_OK;
}

/* Of y^2 - x^2 by spreads, which passes zero each half period. */
static enum status find_oscillation(const struct columns *columns, const struct drop *drop,
                                    double period, struct fit_oscillation *found, struct error *e)
{
    const double *times = columns_time(columns), *x = drop->spread[0], *y = drop->spread[1];
    double *waves = case_series(columns, e);
    if (!waves)
        return e->status;
    for (size_t k = 0; k < columns->rows; k++)
        waves[k] = y[k] * y[k] - x[k] * x[k];
    bool whole = fit_oscillation(times, waves, columns->rows, period / 10, found);
    memory_free(waves);
    return whole ? STATUS_OK
                 : error_set(e, STATUS_RUN, "the drop does not oscillate for three half periods");
}

/* The exact amplitude is that of the radius of the particles at the start, whose number is whole. */
static enum status compare_oscillating(const struct columns *columns, const struct scene *scene,
                                       struct study_errors *errors, struct error *e)
{
    struct drop drop = {.spacing = 0};
    struct fit_oscillation found;
    double sigma = stretching(scene), omega = scene->central_force.frequency;
    double period = exact_oscillating_drop_period(sigma, omega);
    if (read_spread(&drop, columns, scene, e) ||
        find_oscillation(columns, &drop, period, &found, e))
        return e->status;
    struct exact_ellipse top = exact_oscillating_drop(period / 4, sigma, omega,
                                                      by_moments(&drop, 0, 0));
    double amplitude = fabs(top.axes[1] * top.axes[1] - top.axes[0] * top.axes[0]) / 4;
    study_error_add(errors, 2 * found.half / period - 1, "%", 0.005, "period");
    study_error_add(errors, found.first / amplitude - 1, "%", NAN, "first amplitude");
    study_error_add(errors, pow(found.last / found.first, 2 / (double)found.halves) - 1, "%", NAN,
                    "amplitude, change in a period");
    add_start(&drop, scene, errors);
    return STATUS_OK;
}

extern const struct case_row case_elliptic_drop, case_oscillating_drop;
const struct case_row case_elliptic_drop = {
    .variant = {.name = "elliptic-drop",
                .doc = "semi-axes of a drop that becomes an ellipse, against its equations "
                       "(Monaghan 1994)"},
    .interval = elliptic_interval, .lacks = elliptic_lacks, .measure = measure_elliptic,
    .compare = compare_elliptic};
const struct case_row case_oscillating_drop = {
    .variant = {.name = "oscillating-drop",
                .doc = "period and amplitude of a drop under a central force, against its "
                       "equations (Monaghan & Rafiee 2013)"},
    .interval = oscillating_interval, .lacks = oscillating_lacks, .measure = measure_oscillating,
    .compare = compare_oscillating};
