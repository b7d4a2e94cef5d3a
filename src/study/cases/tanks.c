/* Cases "hydrostatic" and "deep-column": tanks at rest with a free surface. Means and norms in time are
 * over the last 25 % of a run. */
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/fit.h"
#include "study/reference/norm.h"

#include <math.h>

enum { POINTS_MAX = 1000 };

static double interval(const struct scene *scene)
{
    return scene->time.end / 64;
}

static const char *lacks(const struct scene *scene)
{
    if (!case_has_gravity_down(scene))
        return "gravity along -y";
    return case_has_shape(scene, SHAPE_BOX) ? NULL : "a first body that is a box";
}

static double depth(const struct scene *scene)
{
    return scene->bodies[0].shape.max[1] - scene->bodies[0].shape.min[1];
}

/* From floor and surface to the line of pressures: more than a support radius, where there is room. */
static double margin(const struct scene *scene)
{
    return fmin(3 * scene->particles.spacing, depth(scene) / 3);
}

/* Of depth below the surface, Pa/m. */
static double pressure_rise(const struct scene *scene)
{
    return -case_fluid(scene)->density * scene->gravity[1];
}

/* Energy, volume, floor, a line up the middle with a point for each spacing. */
static void measure(const struct scene *scene, FILE *out)
{
    const struct scene_body *body = &scene->bodies[0];
    double points = rint((depth(scene) - 2 * margin(scene)) / scene->particles.spacing) + 1;
    double low[3], high[3];
    case_box_middle(scene, low);
    case_box_middle(scene, high);
    low[1] = body->shape.min[1] + margin(scene);
    high[1] = body->shape.max[1] - margin(scene);
    fputs("{\"quantity\": \"energy\"}, {\"quantity\": \"volume\"}, {\"quantity\": \"mass-centre\"}, "
          "{\"quantity\": \"wall-pressure\", \"name\": \"floor\", \"face\": \"-y\"}, "
          "{\"quantity\": \"profile\", \"name\": \"up\", \"from\": ", out);
    case_write_point(out, low);
    fputs(", \"to\": ", out);
    case_write_point(out, high);
    fprintf(out, ", \"points\": %.0f}", fmin(fmax(points, 2), POINTS_MAX));
}

/* Pressures along the line. */
struct line {
    size_t count;
    double heights[POINTS_MAX]; /* above the floor, m */
    double exact[POINTS_MAX];   /* Pa */
    double mean[POINTS_MAX];    /* late, Pa */
    double noise;               /* L2 over points and time */
};

/* Every row has the same exact pressures: L2 over all is the mean square over rows. */
static enum status read_line(struct line *line, const struct columns *columns,
                             const struct scene *scene, struct error *e)
{
    double values[POINTS_MAX], squares = 0;
    size_t first = fit_late(columns_time(columns), columns->rows), rows = columns->rows - first;
    *line = (struct line){.count = columns_line(columns, "up", "pressure", 0, values, POINTS_MAX)};
    if (line->count < 2)
        return error_set(e, STATUS_USAGE, "there are no columns \"up.0.pressure\" and on");
    for (size_t k = 0; k < line->count; k++) {
        double part = (double)k / (double)(line->count - 1);
        line->heights[k] = margin(scene) + part * (depth(scene) - 2 * margin(scene));
        line->exact[k] = pressure_rise(scene) * (depth(scene) - line->heights[k]);
    }
    for (size_t row = first; row < columns->rows; row++) {
        columns_line(columns, "up", "pressure", row, values, POINTS_MAX);
        for (size_t k = 0; k < line->count; k++)
            line->mean[k] += values[k] / (double)rows;
        double error = norm_l2(values, line->exact, line->count);
        squares += error * error / (double)rows;
    }
    line->noise = sqrt(squares);
    return STATUS_OK;
}

/* Late mean of a column, of its first value. */
static double late_drift(const struct columns *columns, const double *values)
{
    return fit_late_mean(columns_time(columns), values, columns->rows) / values[0] - 1;
}

/* Volume, mass centre and energy of every tank. */
static enum status compare_rest(const struct columns *columns, const struct scene *scene,
                                double drift_asked, struct study_errors *errors, struct error *e)
{
    const double *surface = columns_need(columns, "volume.surface", e);
    const double *height = surface ? columns_need(columns, "mass-centre.y", e) : NULL;
    const double *kinetic = height ? columns_need(columns, "energy.kinetic", e) : NULL;
    if (!kinetic)
        return e->status;
    double energy = case_box_mass(scene) * -scene->gravity[1] * depth(scene);
    double floor = scene->bodies[0].shape.min[1];
    double centre = fit_late_mean(columns_time(columns), height, columns->rows);
    study_error_add(errors, late_drift(columns, surface), "%", drift_asked,
                    "volume below the surface, drift");
    study_error_add(errors, (centre - floor) / (height[0] - floor) - 1, "%", drift_asked,
                    "mass centre, drift");
    study_error_add(errors,
                    fit_late_mean(columns_time(columns), kinetic, columns->rows) / energy, "",
                    1e-6, "kinetic energy / M g H");
    return STATUS_OK;
}

static enum status compare_hydrostatic(const struct columns *columns, const struct scene *scene,
                                       struct study_errors *errors, struct error *e)
{
    struct line line;
    const double *floor = columns_need(columns, "floor", e);
    if (!floor || read_line(&line, columns, scene, e))
        return e->status;
    study_error_add(errors, line.noise, "%", 0.01, "pressure, L2 over points and time");
    study_error_add(errors, norm_l2(line.mean, line.exact, line.count), "%", NAN,
                    "pressure, L2 of its mean");
    study_error_add(errors, fit_late_mean(columns_time(columns), floor, columns->rows) /
                    (pressure_rise(scene) * depth(scene)) - 1, "%", 0.01, "pressure on the floor");
    return compare_rest(columns, scene, 0.005, errors, e);
}

static enum status compare_column(const struct columns *columns, const struct scene *scene,
                                  struct study_errors *errors, struct error *e)
{
    struct line line;
    if (read_line(&line, columns, scene, e))
        return e->status;
    double slope = fit_slope(line.heights, line.mean, line.count);
    study_error_add(errors, slope / -pressure_rise(scene) - 1, "%", 0.01, "slope of pressure");
    return compare_rest(columns, scene, 0.01, errors, e);
}

extern const struct case_row case_hydrostatic, case_deep_column;
const struct case_row case_hydrostatic = {
    .variant = {.name = "hydrostatic",
                .doc = "pressure, volume and rest of a tank, against rho g depth"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare_hydrostatic};
const struct case_row case_deep_column = {
    .variant = {.name = "deep-column",
                .doc = "rise of pressure, volume and rest of a deep tank, against rho g"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare_column};
