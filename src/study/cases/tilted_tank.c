/* Case "hydrostatic-tilted": pressure in a full box with gravity of any direction. Means and norms in
 * time are over the last 25 % of a run. */
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/fit.h"
#include "study/reference/norm.h"

#include <math.h>

enum { LINES = 3, POINTS = 10, ALL = LINES * POINTS };

static const char *const line_names[LINES] = {"across", "up", "along"};

static double interval(const struct scene *scene)
{
    return scene->time.end / 40;
}

static double gravity(const struct scene *scene)
{
    const double *g = scene->gravity;
    return sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
}

static const char *lacks(const struct scene *scene)
{
    if (!case_has_shape(scene, SHAPE_BOX))
        return "a first body that is a box";
    return gravity(scene) > 0 ? NULL : "gravity";
}

/* Ends of a line through the middle along x, y or gravity, 3 spacings off the nearest walls, which is
 * more than a support radius, where there is room. */
static void line_ends(const struct scene *scene, int line, double from[3], double to[3])
{
    const struct scene_body *body = &scene->bodies[0];
    double direction[3] = {line == 0, line == 1, 0}, reach = INFINITY, middle[3];
    for (int a = 0; a < 3; a++) {
        double half = (body->shape.max[a] - body->shape.min[a]) / 2;
        half -= fmin(3 * scene->particles.spacing, half / 2);
        if (line == 2)
            direction[a] = scene->gravity[a] / gravity(scene);
        if (direction[a] != 0)
            reach = fmin(reach, half / fabs(direction[a]));
    }
    case_box_middle(scene, middle);
    for (int a = 0; a < 3; a++) {
        from[a] = middle[a] - reach * direction[a];
        to[a] = middle[a] + reach * direction[a];
    }
}

static void measure(const struct scene *scene, FILE *out)
{
    fputs("{\"quantity\": \"energy\"}, {\"quantity\": \"mass-centre\"}", out);
    for (int line = 0; line < LINES; line++) {
        double from[3], to[3];
        line_ends(scene, line, from, to);
        fprintf(out, ", {\"quantity\": \"profile\", \"name\": \"%s\", \"points\": %d, \"from\": ",
                line_names[line], POINTS);
        case_write_point(out, from);
        fputs(", \"to\": ", out);
        case_write_point(out, to);
        fputs("}", out);
    }
}

/* Pressure below the box's highest corner, Pa. */
static double exact_pressure(const struct scene *scene, const double x[3])
{
    const struct scene_body *body = &scene->bodies[0];
    double pressure = 0;
    for (int a = 0; a < 3; a++) {
        double g = scene->gravity[a];
        pressure += case_fluid(scene)->density * g * (x[a] - (g > 0 ? body->shape.min[a] : body->shape.max[a]));
    }
    return pressure;
}

static void exact_pressures(const struct scene *scene, double out[ALL])
{
    for (int k = 0; k < ALL; k++) {
        double from[3], to[3], x[3], part = k % POINTS / (POINTS - 1.0);
        line_ends(scene, k / POINTS, from, to);
        for (int a = 0; a < 3; a++)
            x[a] = from[a] + part * (to[a] - from[a]);
        out[k] = exact_pressure(scene, x);
    }
}

/* Of all points in that row; false when there are no such columns. */
static bool read_row(const struct columns *columns, size_t row, double out[ALL])
{
    for (int line = 0; line < LINES; line++)
        if (columns_line(columns, line_names[line], "pressure", row, out + line * POINTS,
                         POINTS) != POINTS)
            return false;
    return true;
}

/* Without a surface the level of pressure is free: that of the late mean is taken off. */
static enum status pressure_error(const struct columns *columns, const struct scene *scene,
                                  double *error, struct error *e)
{
    double exact[ALL], values[ALL], level = 0, squares = 0;
    size_t first = fit_late(columns_time(columns), columns->rows), rows = columns->rows - first;
    exact_pressures(scene, exact);
    for (size_t row = first; row < columns->rows; row++) {
        if (!read_row(columns, row, values))
            return error_set(e, STATUS_USAGE, "there are no columns \"across.0.pressure\" and on");
        for (int k = 0; k < ALL; k++)
            level += (values[k] - exact[k]) / (double)(ALL * rows);
    }
    for (size_t row = first; row < columns->rows; row++) {
        read_row(columns, row, values);
        for (int k = 0; k < ALL; k++)
            values[k] -= level;
        double l2 = norm_l2(values, exact, ALL);
        squares += l2 * l2 / (double)rows;
    }
    *error = sqrt(squares);
    return STATUS_OK;
}

/* How far the late mean of the mass centre is from the first, m. */
static enum status centre_moved(const struct columns *columns, double *moved, struct error *e)
{
    static const char *const names[3] = {"mass-centre.x", "mass-centre.y", "mass-centre.z"};
    double square = 0;
    for (int a = 0; a < 3; a++) {
        const double *x = columns_need(columns, names[a], e);
        if (!x)
            return e->status;
        double off = fit_late_mean(columns_time(columns), x, columns->rows) - x[0];
        square += off * off;
    }
    *moved = sqrt(square);
    return STATUS_OK;
}

/* From the highest corner to the lowest, along gravity, m. */
static double drop(const struct scene *scene)
{
    double sum = 0;
    for (int a = 0; a < 3; a++)
        sum += fabs(scene->gravity[a]) * (scene->bodies[0].shape.max[a] - scene->bodies[0].shape.min[a]);
    return sum / gravity(scene);
}

static enum status compare(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e)
{
    double pressure = 0, moved = 0;
    const double *kinetic = columns_need(columns, "energy.kinetic", e);
    if (!kinetic || pressure_error(columns, scene, &pressure, e) ||
        centre_moved(columns, &moved, e))
        return e->status;
    study_error_add(errors, pressure, "%", 0.01,
                    "pressure but for a constant, L2 over points and time");
    study_error_add(errors, moved / drop(scene), "%", 0.005, "mass centre moved, of H");
    study_error_add(errors, fit_late_mean(columns_time(columns), kinetic, columns->rows) /
                    (case_box_mass(scene) * gravity(scene) * drop(scene)), "", 1e-6,
                    "kinetic energy / M g H");
    return STATUS_OK;
}

extern const struct case_row case_hydrostatic_tilted;
const struct case_row case_hydrostatic_tilted = {
    .variant = {.name = "hydrostatic-tilted",
                .doc = "pressure and rest of a full box under gravity of any direction, against "
                       "rho g depth and a constant"},
    .interval = interval, .lacks = lacks, .measure = measure, .compare = compare};
