/* Finds and says the cause that stopped a run. */
#include "run/give_up.h"

#include "run/limits.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#define NEAR 0.3  /* spacings; particles that start closer overlap */
#define DENSE 1.5 /* times rest density; more at once is overlap, not flow */
enum {
    STEPS_NEAR = 100, /* a failure later than this has another cause than the start */
    STEPS_DENSE = 5   /* the same for density, which a flow changes */
};

struct cause {
    char what[240];
    const char *change;
};

static double length3(const float v[3])
{
    return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

/* The first value of a particle that is not finite, or NULL. `field` is now or before. */
static const char *not_finite(void *const field[FIELD_COUNT], size_t i)
{
    const struct position *x = field[FIELD_POSITION];
    const struct motion *v = field[FIELD_MOTION];
    const struct rate *rate = field[FIELD_RATE];
    const float *density = field[FIELD_DENSITY];
    if (x && !isfinite(x[i].volume))
        return "position (its volume)";
    if (density && !isfinite(density[i]))
        return "density";
    if (v && !isfinite(v[i].pressure))
        return "pressure";
    if (v && !isfinite(length3(v[i].velocity)))
        return "velocity";
    if (rate && !isfinite(length3(rate[i].acceleration)))
        return "acceleration";
    if (rate && !isfinite(rate[i].density))
        return "rate of density";
    return NULL;
}

/* Place in memory of the particle with the smallest id whose present state is not finite; else of
 * the particle `bad`. */
static size_t culprit(const struct particles *p, uint32_t bad, const char **value)
{
    size_t at = 0, found = p->count;
    for (size_t i = 0; i < p->count; i++) {
        at = particles_id(p)[i] == bad ? i : at;
        if (not_finite(p->now, i) &&
            (found == p->count || particles_id(p)[i] < particles_id(p)[found]))
            found = i;
    }
    *value = found < p->count ? not_finite(p->now, found) : NULL;
    return found < p->count ? found : at;
}

/* Distance at the start to the nearest other particle, in spacings. */
static double nearest(const struct simulation *s, uint32_t id)
{
    const struct space *space = &s->plan->space;
    const struct fill *fill = &s->plan->bodies;
    double least = INFINITY;
    for (size_t j = 0; j < fill->count; j++) {
        double r2 = 0;
        for (int k = 0; k < 3; k++) {
            uint32_t here = space_count(space, k, fill->point[id][k]);
            uint32_t there = space_count(space, k, fill->point[j][k]);
            double r = (int32_t)(here - there) * space->unit[k];
            r2 += r * r;
        }
        least = j != id && r2 < least ? r2 : least;
    }
    return sqrt(least) / s->plan->choice.spacing;
}

/* The particle's density in the rejected try or now, whichever is more, in units of rest. */
static double crowding(const struct simulation *s, const struct particles *p, size_t i)
{
    const float *now = p->now[FIELD_DENSITY], *tried = p->before[FIELD_DENSITY];
    double rest = s->plan->choice.each.rest_density[particles_fluid(p, i)];
    double most = now && isfinite(now[i]) ? now[i] : 0;
    if (tried && isfinite(tried[i]))
        most = fmax(most, tried[i]);
    return most / rest;
}

static bool find_overlap(const struct simulation *s, const struct particles *p, size_t i,
                         struct cause *cause)
{
    double gap = nearest(s, particles_id(p)[i]), dense = crowding(s, p, i);
    bool near = gap < NEAR && s->stats.steps <= STEPS_NEAR;
    if (!near && !(dense > DENSE && s->stats.steps <= STEPS_DENSE))
        return false;
    snprintf(cause->what, sizeof cause->what,
             "overlap: it started %.2g spacings from the nearest particle, and its density is now "
             "%.3g times that at rest", gap, dense);
    cause->change = "separate bodies that overlap, use fill \"grid\", or lower jitter";
    return true;
}

/* Too fast for the numerical speed of sound, which implicit solvers do not have. */
static bool find_acoustic(const struct simulation *s, double speed, struct cause *cause)
{
    double c0 = s->plan->choice.sound_speed;
    if (!(c0 > 0 && speed > MACH_MAX * c0))
        return false;
    snprintf(cause->what, sizeof cause->what,
             "acoustic: flow faster than half the numerical speed of sound (%.4g m/s), where "
             "density is wrong", c0);
    cause->change = strcmp(s->plan->solver->variant.name, "muller") == 0
                        ? "raise solver.stiffness to 100 times the square of the fastest flow"
                        : "raise solver.sound_speed to 10 times the fastest flow";
    return true;
}

/* The try that was rejected overflowed, from a state that is finite. */
static bool find_overflow(const struct simulation *s, const struct particles *p, size_t i,
                          struct cause *cause)
{
    const char *value = not_finite(p->before, i);
    if (!value)
        return false;
    snprintf(cause->what, sizeof cause->what, "not finite: %s after the step", value);
    cause->change = s->plan->choice.is_implicit
                        ? "look for overlapping bodies, extreme speeds or densities"
                        : "lower solver.sound_speed or stiffness, or look for overlapping bodies";
    return true;
}

/* What binds the step that could not be taken. */
static void find_limit(const struct simulation *s, struct cause *cause)
{
    double limit[LIMIT_COUNT];
    enum limit which;
    limits_now(s, limit);
    double least = limits_least(limit, LIMITS_PHYSICAL, &which);
    if (which == LIMIT_VISCOUS) {
        snprintf(cause->what, sizeof cause->what,
                 "viscous: viscosity moves momentum across a particle in %.3g s", least);
        cause->change = "lower fluids[].viscosity, or use a larger spacing";
        return;
    }
    if (which == LIMIT_CAPILLARY) {
        snprintf(cause->what, sizeof cause->what,
                 "capillary: surface tension moves particles in %.3g s", least);
        cause->change = "lower fluids[].surface_tension, or use a larger spacing";
        return;
    }
    snprintf(cause->what, sizeof cause->what, "force: a force that no time step resolves");
    cause->change = s->plan->choice.is_implicit
                        ? "slow the bodies down, lower time.cfl, or use a smaller spacing"
                        : "lower the stiffness (solver.sound_speed), or use a smaller spacing";
}

static void find_cause(const struct simulation *s, const struct particles *p, size_t i,
                       const char *value, double speed, struct cause *cause)
{
    if (value) {
        snprintf(cause->what, sizeof cause->what, "not finite: %s", value);
        cause->change = "look for overlapping bodies or extreme values in the scene";
        return;
    }
    if (find_overlap(s, p, i, cause) || find_acoustic(s, speed, cause) ||
        find_overflow(s, p, i, cause))
        return;
    find_limit(s, cause);
}

enum status give_up(struct simulation *s, double dt, int halvings, uint32_t bad, struct error *e)
{
    const struct particles *p = s->row->state(s->backend, UINT_MAX, e);
    if (!p)
        return e->status;
    const struct space *space = &s->plan->space;
    const char *value;
    size_t i = culprit(p, bad, &value);
    const struct position *x = &particles_position(p)[i];
    const struct rate *rate = p->now[FIELD_RATE];
    double speed = length3(particles_motion(p)[i].velocity);
    char force[64] = "";
    struct cause cause;
    find_cause(s, p, i, value, speed, &cause);
    if (rate && !s->plan->choice.is_implicit)
        snprintf(force, sizeof force, ", acceleration %.4g m/s^2", length3(rate[i].acceleration));
    return error_set(e, STATUS_RUN,
                     "stopped at t = %.6g s: particle %u at (%.4g, %.4g, %.4g) m, speed %.4g m/s%s, "
                     "after %d halvings of the time step (now %.3g s); cause: %s; %s. Frames up to "
                     "now are kept",
                     s->time, particles_id(p)[i], space_metres(space, 0, x->count[0]),
                     space_metres(space, 1, x->count[1]), space_metres(space, 2, x->count[2]),
                     speed, force, halvings, dt, cause.what, cause.change);
}

enum status strict_check(const struct simulation *s, double rejected, uint32_t bad,
                         struct error *e)
{
    double limit[LIMIT_COUNT], user = s->plan->choice.limits.user;
    enum limit which;
    if (!s->strict)
        return STATUS_OK;
    if (isfinite(rejected))
        return error_set(e, STATUS_RUN,
                         "--strict: at t = %.6g s particle %u cannot take a step of %.4g s (it "
                         "would go non-finite or move half a spacing), so time.step %.4g s is too "
                         "long; lower it to %.3g or less, or leave out --strict",
                         s->time, bad, rejected, user, rejected / 2);
    limits_now(s, limit);
    double least = limits_least(limit, LIMITS_PHYSICAL, &which);
    if (!(least < user))
        return STATUS_OK;
    return error_set(e, STATUS_RUN,
                     "--strict: at t = %.6g s the %s asks for a step of %.4g s, %.3g times less "
                     "than time.step %.4g s; lower time.step to %.3g or less, or leave out --strict",
                     s->time, limit_names[which], least, user / least, user, 0.9 * least);
}
