/* The table of solvers, and the choices that are common to them. */
#include "solver/solver.h"

#include "particles/flows.h"

#include <math.h>
#include <string.h>

static const struct variant *const rows[] = {
    &solver_isph.variant,
    &solver_wcsph.variant,
    &solver_dfsph.variant,
    &solver_muller.variant,
};

const struct variant_table solver_table = {
    .name = "solvers",
    .doc = "pressure solvers",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

double solver_support(const struct solver_row *solver, const struct scene *scene,
                      const struct kernel_row **kernel)
{
    const char *name = scene->solver.kernel;
    if (strcmp(name, "auto") == 0 || strcmp(solver->kernel, "poly6") == 0)
        name = solver->kernel;
    *kernel = (const struct kernel_row *)variant_find(&kernel_table, name);
    double support = scene->solver.support, usual = (*kernel)->support;
    usual = solver->support > 0 ? solver->support : usual;
    return (isnan(support) ? usual : support) * scene->particles.spacing;
}

static double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* How far a body reaches along the unit vector `up`. */
static double body_top(const struct scene_body *b, const double up[3])
{
    double low[3], high[3], top = 0;
    shape_bounds(&b->shape, low, high);
    for (int a = 0; a < 3; a++)
        top += up[a] > 0 ? up[a] * high[a] : up[a] * low[a];
    return top;
}

/* Expected depth of fluid and largest speed: the fall from the highest point of any body to the
 * lowest point of the domain, with the body's own speed. */
static void expect(const struct scene *scene, struct solver_choice *choice)
{
    double g = length3(scene->gravity), up[3] = {0}, floor = 0;
    choice->depth = choice->fastest = 0;
    for (int a = 0; a < 3; a++) {
        up[a] = g > 0 ? -scene->gravity[a] / g : 0;
        floor += up[a] * (up[a] > 0 ? scene->domain.min[a] : scene->domain.max[a]);
    }
    for (size_t b = 0; b < scene->body_count; b++) {
        double speed = flow_fastest(&scene->bodies[b]);
        double depth = g > 0 ? fmax(0, body_top(&scene->bodies[b], up) - floor) : 0;
        choice->depth = fmax(choice->depth, depth);
        choice->fastest = fmax(choice->fastest, sqrt(speed * speed + 2 * g * depth));
    }
}

/* On a periodic axis with gravity along it nothing stops the fall; the depth is then meaningless. */
static void expect_driven(const struct scene *scene, struct solver_choice *choice)
{
    for (int a = 0; a < 3; a++)
        if (scene->domain.walls[2 * a] == WALL_PERIODIC && scene->gravity[a] != 0) {
            double speed = 0;
            for (size_t b = 0; b < scene->body_count; b++)
                speed = fmax(speed, flow_fastest(&scene->bodies[b]));
            choice->depth = 0;
            choice->fastest = speed;
        }
}

static void choose_walls(const struct scene *scene, const struct space *space,
                         struct solver_choice *choice)
{
    struct explicit_constants *each = &choice->each;
    for (int f = 0; f < FACE_COUNT; f++) {
        enum wall_kind kind = scene->domain.walls[f];
        each->closed[f / 2] = kind != WALL_PERIODIC;
        each->plane[f] = kind == WALL_CLOSED;
        for (int a = 0; a < 3; a++)
            each->wall_velocity[f][a] = (float)scene->domain.wall_velocity[f][a];
        choice->wall_speed = fmax(choice->wall_speed, length3(scene->domain.wall_velocity[f]));
        choice->wall_planes = choice->wall_planes || kind == WALL_CLOSED;
        choice->wall_particles = choice->wall_particles || kind == WALL_PARTICLES;
    }
    choice->fastest = fmax(choice->fastest, choice->wall_speed);
    memcpy(each->low, space->low, sizeof each->low);
    memcpy(each->high, space->high, sizeof each->high);
    each->restitution = (float)scene->domain.restitution;
    each->no_slip = scene->domain.no_slip;
}

static void choose_fluids(const struct scene *scene, const double *fluid_volume,
                          const size_t *fluid_particles, struct solver_choice *choice)
{
    struct explicit_constants *each = &choice->each;
    double d = choice->spacing, cell = d * d * d;
    double lattice = kernel_lattice_sum(choice->kernel, choice->support / d), viscosity = 0;
    bool differ = false;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        const struct scene_fluid *fluid = &scene->fluids[f];
        double volume = fluid_particles[f] ? fluid_volume[f] / (double)fluid_particles[f] : cell;
        each->rest_density[f] = (float)fluid->density;
        each->mass[f] = (float)(fluid->density * volume / cell / lattice);
        each->viscosity[f] = (float)fluid->viscosity;
        viscosity = fmax(viscosity, fluid->viscosity / fluid->density);
        differ = differ || fluid->viscosity != scene->fluids[0].viscosity;
    }
    choice->mixed = false;
    for (size_t f = 1; f < scene->fluid_count; f++)
        choice->mixed = choice->mixed || scene->fluids[f].density != scene->fluids[0].density;
    if (viscosity > 0)
        choice->flags |= differ ? PAIR_OWN_VISCOSITY : PAIR_VISCOUS;
    choice->pair.viscosity = (float)(2 * scene->fluids[0].viscosity / choice->smoothing_length);
    choice->pair.inverse_h = (float)(1 / choice->smoothing_length);
    choice->limits.viscous =
        viscosity > 0 ? 0.125 * choice->smoothing_length * choice->smoothing_length / viscosity
                      : INFINITY;
}

void solver_mix(struct solver_choice *choice)
{
    if (!choice->mixed)
        return;
    choice->flags |= PAIR_MIXED;
    if (choice->flags & PAIR_VISCOUS)
        choice->flags ^= PAIR_VISCOUS | PAIR_OWN_VISCOSITY;
}

static void choose_scales(const struct scene *scene, const struct space *space,
                          struct solver_choice *choice)
{
    double h = choice->smoothing_length, d = choice->spacing, sigma = choice->kernel->sigma;
    choice->moment = kernel_lattice_moment(choice->kernel, 2 * h / d) /
                     kernel_lattice_sum(choice->kernel, 2 * h / d);
    choice->pair.gradient = (float)(sigma * d * d * d / (h * h * h * h) / choice->moment);
    choice->each.normal = (float)(1 / choice->moment);
    choice->pair.density = (float)(sigma * d * d * d / (h * h * h));
    choice->pair.self = 1; /* w(0) of every kernel */
    for (int a = 0; a < 3; a++) {
        choice->pair.scale[a] = (float)(space->unit[a] / h);
        choice->pair.gravity[a] = (float)scene->gravity[a];
        choice->each.gravity[a] = space->periodic[a] ? 0 : (float)scene->gravity[a];
        choice->pair.head[a] = (float)(choice->each.gravity[a] * h);
        choice->each.unit[a] = space->unit[a];
        choice->each.per_metre[a] = (float)(1 / space->unit[a]);
        choice->each.near[a] = (uint32_t)(2 * h / space->unit[a] * (1 - 1e-6));
        choice->each.q_per_count[a] = (float)(space->unit[a] / h);
    }
    choice->each.spacing = (float)d;
    choice->each.h = (float)h;
    choice->each.number_density = choice->pair.density;
    kernel_plane_table(choice->kernel, choice->support / d, &choice->each.planes);
}

/* Whether the bodies fill the domain, but for obstacles; these share no space, or the sum of their volumes is
 * too large and a surface is missed that is not there. */
static bool is_enclosed(const struct scene *scene, const double *fluid_volume)
{
    double fluid = 0, domain = 1;
    for (size_t f = 0; f < scene->fluid_count; f++)
        fluid += fluid_volume[f];
    for (int a = 0; a < 3; a++)
        domain *= scene->domain.max[a] - scene->domain.min[a];
    for (size_t k = 0; k < scene->obstacle_count; k++)
        domain -= shape_volume(&scene->obstacles[k].shape);
    return fluid > 0.98 * domain;
}

/* What velocity takes back of a density error is a part in each step: in steps that the scene makes
 * short it would be speed without bound. */
static void choose_restore(const struct scene *scene, struct solver_choice *choice)
{
    double step = fmin(choice->limits.user, choice->limits.viscous);
    double usual = fmin(0.1 * sqrt(choice->spacing / length3(scene->gravity)),
                        0.4 * choice->cfl * choice->spacing / choice->fastest);
    if (choice->is_implicit && isfinite(usual) && step < usual)
        choice->implicit.restore *= (float)(step / usual);
}

void solver_choose(const struct solver_row *solver, const struct scene *scene,
                   const struct space *space, const double *fluid_volume,
                   const size_t *fluid_particles, struct solver_choice *choice)
{
    *choice = (struct solver_choice){0};
    choice->support = solver_support(solver, scene, &choice->kernel);
    choice->spacing = scene->particles.spacing;
    choice->smoothing_length = choice->support / 2;
    choice->flags = choice->kernel->flag;
    choice->enclosed = is_enclosed(scene, fluid_volume);
    expect(scene, choice);
    expect_driven(scene, choice);
    choose_walls(scene, space, choice);
    obstacles_choose(scene, space, choice);
    choose_scales(scene, space, choice);
    choose_fluids(scene, fluid_volume, fluid_particles, choice);
    tension_choose(scene, choice);
    external_choose(scene, space, fluid_volume, choice);
    choice->cfl = isnan(scene->time.cfl) ? solver->cfl : scene->time.cfl;
    choice->limits.acoustic = choice->cfl * choice->smoothing_length;
    choice->limits.force = 0.25;
    choice->limits.user = isnan(scene->time.step) ? INFINITY : scene->time.step;
    solver->choose(scene, choice);
    if (!choice->is_implicit) /* forces see a velocity that is predicted by the last forces: drag of */
        choice->limits.viscous /= 2; /* rate z is stable for z dt < 1, not 2 as by Euler's method */
    bool applied = choice->flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY) && !choice->implicit_viscosity;
    choice->starts_rate = choice->is_implicit && !applied;
    choose_restore(scene, choice);
    choice->each.rest_speed = (float)(1e-12 * fmax(choice->sound_speed, choice->fastest));
}
