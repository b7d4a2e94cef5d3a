/* Cases "poiseuille" and "couette": velocity across channels that start from rest. */
#include "study/cases/case.h"
#include "study/cases/case_scene.h"
#include "study/reference/exact.h"
#include "study/reference/norm.h"

#include <math.h>

enum { LAYERS_MAX = 1000, TIMES = 5 };

/* t nu/H^2 of Morris, Fox & Zhu (1997) and between, all multiples of the interval between rows. */
static const double told[TIMES] = {0.0225, 0.045, 0.1125, 0.225, 1}, rows_apart = 0.0025;

static double width(const struct scene *scene)
{
    return scene->domain.max[1] - scene->domain.min[1];
}

/* H^2/nu, s */
static double diffusion_time(const struct scene *scene)
{
    return width(scene) * width(scene) / case_viscosity(scene);
}

static double interval(const struct scene *scene)
{
    return rows_apart * diffusion_time(scene);
}

static const char *walls_lack(const struct scene *scene)
{
    const enum wall_kind *walls = scene->domain.walls;
    if (walls[0] != WALL_PERIODIC || walls[2] == WALL_PERIODIC)
        return "faces that are periodic along x and walls across y";
    return case_fluid(scene)->viscosity > 0 ? NULL : "a viscosity";
}

static const char *poiseuille_lacks(const struct scene *scene)
{
    return scene->gravity[0] == 0 ? "gravity along x" : walls_lack(scene);
}

static const char *couette_lacks(const struct scene *scene)
{
    return scene->domain.wall_velocity[3][0] == 0 ? "an upper wall that moves along x"
                                                  : walls_lack(scene);
}

/* A slab for each layer of particles. */
static void measure(const struct scene *scene, FILE *out)
{
    double layers = fmin(rint(width(scene) / scene->particles.spacing), LAYERS_MAX);
    fprintf(out, "{\"quantity\": \"layers\", \"points\": %.0f}", layers);
}

/* Velocity at y above the lower wall, m/s. */
typedef double solution(const struct scene *scene, double y, double t);

static double poiseuille(const struct scene *scene, double y, double t)
{
    return exact_poiseuille(y, t, case_viscosity(scene), scene->gravity[0], width(scene));
}

static double couette(const struct scene *scene, double y, double t)
{
    return exact_couette(y, t, case_viscosity(scene), scene->domain.wall_velocity[3][0],
                         width(scene));
}

/* L2 over the slabs in that row. */
static enum status row_error(const struct columns *columns, const struct scene *scene, size_t row,
                             solution *exact, double *error, struct error *e)
{
    double ys[LAYERS_MAX], us[LAYERS_MAX], references[LAYERS_MAX];
    double t = columns_time(columns)[row];
    size_t count = columns_line(columns, "layers", "coordinate", row, ys, LAYERS_MAX);
    if (!count || columns_line(columns, "layers", "velocity.x", row, us, LAYERS_MAX) != count)
        return error_set(e, STATUS_USAGE, "there are no columns of \"layers\"");
    for (size_t k = 0; k < count; k++)
        references[k] = exact(scene, ys[k] - scene->domain.min[1], t);
    *error = norm_l2(us, references, count);
    return STATUS_OK;
}

/* At the times that the run reaches. */
static enum status channel(const struct columns *columns, const struct scene *scene,
                           solution *exact, struct study_errors *errors, struct error *e)
{
    double last = columns_time(columns)[columns->rows - 1] * (1 + 1e-9), error = 0;
    size_t row = 0;
    if (last < told[0] * diffusion_time(scene))
        return error_set(e, STATUS_RUN, "the run ends at %g s; the case compares from %g s on",
                         last, told[0] * diffusion_time(scene));
    for (int k = 0; k < TIMES && told[k] * diffusion_time(scene) <= last; k++) {
        if (case_row_at(columns, told[k] * diffusion_time(scene), &row, e) ||
            row_error(columns, scene, row, exact, &error, e))
            return e->status;
        study_error_add(errors, error, "%", 0.01, "velocity, L2 at t nu/H^2 = %g", told[k]);
    }
    return STATUS_OK;
}

static enum status compare_poiseuille(const struct columns *columns, const struct scene *scene,
                                      struct study_errors *errors, struct error *e)
{
    return channel(columns, scene, poiseuille, errors, e);
}

static enum status compare_couette(const struct columns *columns, const struct scene *scene,
                                   struct study_errors *errors, struct error *e)
{
    return channel(columns, scene, couette, errors, e);
}

extern const struct case_row case_poiseuille, case_couette;
const struct case_row case_poiseuille = {
    .variant = {.name = "poiseuille",
                .doc = "velocity of a channel that a force starts, against the series (Morris, "
                       "Fox & Zhu 1997)"},
    .interval = interval, .lacks = poiseuille_lacks, .measure = measure,
    .compare = compare_poiseuille};
const struct case_row case_couette = {
    .variant = {.name = "couette",
                .doc = "velocity of a channel that a moving wall starts, against the series "
                       "(Morris, Fox & Zhu 1997)"},
    .interval = interval, .lacks = couette_lacks, .measure = measure, .compare = compare_couette};
