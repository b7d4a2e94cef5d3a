/* The time loop: limits, steps, rejections. */
#include "run/simulation.h"

#include "base/log.h"
#include "particles/start.h"
#include "run/give_up.h"
#include "run/step.h"

#include <math.h>
#include <string.h>

enum { HALVINGS_MAX = 12 };

/* The largest step that every limit allows from the present state, s; *which is the least of them. */
static double natural_step(const struct simulation *s, enum limit *which)
{
    double limit[LIMIT_COUNT];
    limits_now(s, limit);
    return limits_least(limit, LIMITS_ALL, which);
}

/* How far any particle can move in a step of dt from the present state, m. */
static double reach(const struct simulation *s, double dt)
{
    return dt * (sqrt(s->extremes.speed2) + dt * sqrt(s->extremes.acceleration2)) * 1.001;
}

/* Sorts and builds rows when this step could carry a particle out of its row's reach. The skin of
 * the rows balances fewer builds against longer rows: with u = 2 move / support, and a build twice
 * the cost of a pass, the cost (1 + s)^3 (1 + 2 u/s) is least near s = sqrt(2 u/3). */
static enum status keep_rows(struct simulation *s, double dt, struct error *e)
{
    double support = s->plan->choice.support;
    double move = s->plan->choice.is_implicit ? 0 : reach(s, dt); /* before rows are read */
    if (s->stats.sorts > 0 && s->moved + move <= s->allowance)
        return STATUS_OK;
    double soon = dt * (sqrt(s->extremes.speed2) + 4 * dt * sqrt(s->extremes.acceleration2));
    double skin = sqrt(4 * soon / support / 3), given = s->plan->scene->solver.skin;
    if (s->plan->choice.is_implicit) /* many passes over each build: no pair more than needed */
        skin = 0;
    skin = isnan(given) ? skin : given;
    if (!s->plan->choice.is_implicit)
        skin = fmax(skin, fmax(0.01, 2.02 * move / support));
    skin = fmin(skin, SKIN_MAX);
    struct step step = {.list_radius = support * (1 + skin)};
    s->allowance = support * skin / 2;
    s->moved = 0;
    s->stats.sorts++;
    if (step_pass(s, PASS_SORT, &step, e))
        return e->status;
    return step_pass(s, PASS_NEIGHBOURS, &step, e);
}

/* The particle that moves fastest. */
static uint32_t fastest(struct simulation *s)
{
    unsigned fields = FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_ID);
    struct error e = {0};
    const struct particles *p = s->row->state(s->backend, fields, &e);
    uint32_t id = UINT32_MAX;
    for (size_t i = 0; p && i < p->count; i++) {
        const float *v = particles_motion(p)[i].velocity;
        float speed2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (speed2 == s->extremes.speed2 && particles_id(p)[i] < id)
            id = particles_id(p)[i];
    }
    return id;
}

static enum status accept(struct simulation *s, double dt, double limit, bool last, double target,
                          struct error *e)
{
    double most = MACH_MAX * s->plan->choice.sound_speed;
    s->time = last ? target : s->time + dt;
    s->last_dt = limit;
    s->stats.steps++;
    s->stats.dt_sum += dt;
    s->stats.dt_min = fmin(s->stats.dt_min, dt);
    s->stats.dt_max = fmax(s->stats.dt_max, dt);
    if (most > 0 && s->extremes.speed2 > most * most)
        return give_up(s, dt, 0, fastest(s), e);
    return STATUS_OK;
}

enum status simulation_step(struct simulation *s, double target, struct error *e)
{
    enum limit which;
    double limit = natural_step(s, &which), left = target - s->time, most = limit;
    if (strict_check(s, INFINITY, 0, e))
        return e->status;
    for (int halvings = 0; halvings <= HALVINGS_MAX; halvings++) {
        double parts = ceil(left / most * (1 - 1e-9)); /* equal steps up to the target */
        double dt = isfinite(left) ? left / fmax(parts, 1) : most;
        uint32_t bad = UINT32_MAX;
        if (keep_rows(s, dt, e) || step_try(s, dt, halvings > 0, &bad, e))
            return e->status;
        if (bad == UINT32_MAX) {
            s->stats.bound[which]++;
            return accept(s, dt, most, parts <= 1, target, e);
        }
        log_detail("t = %.6g s: step of %.3g s rejected (particle %u)", s->time, dt, bad);
        if (strict_check(s, dt, bad, e))
            return e->status;
        if (halvings == HALVINGS_MAX || dt < s->least_dt)
            return give_up(s, dt, halvings, bad, e);
        most = dt / 2;
    }
    return STATUS_OK;
}

enum status simulation_advance(struct simulation *s, double target, struct error *e)
{
    while (s->time < target)
        if (simulation_step(s, target, e))
            return e->status;
    return STATUS_OK;
}

/* What the first step needs to know: for explicit solvers the forces at the start. */
static enum status first_forces(struct simulation *s, struct error *e)
{
    struct step step = {0};
    if (s->plan->choice.is_implicit) {
        const struct particles *p = s->row->state(s->backend, FIELD_BIT(FIELD_MOTION), e);
        if (!p)
            return e->status;
        for (size_t i = 0; i < p->count; i++) {
            const float *v = particles_motion(p)[i].velocity;
            s->extremes.speed2 = fmaxf(s->extremes.speed2, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        }
        return STATUS_OK;
    }
    s->last_dt = natural_step(s, NULL);
    if (keep_rows(s, 0, e) ||
        (s->plan->choice.continuity && step_pass(s, PASS_PRESSURE, &step, e)) ||
        step_forces(s, &step, e) || step_pass(s, PASS_CORRECT, &step, e) ||
        step_settle(s, &step, e))
        return e->status;
    s->extremes = step.extremes;
    return STATUS_OK;
}

/* Threads and instruction sets are the cpu's: who asks for them means it. */
const struct backend_row *simulation_backend(const struct plan *plan, const struct run_options *options)
{
    bool cpu = options->threads > 0 || (options->isa && strcmp(options->isa, "auto") != 0);
    return plan->backend ? plan->backend : cpu ? &backend_cpu : backend_first();
}

enum status simulation_open(struct simulation *s, const struct plan *plan,
                            const struct run_options *options, struct error *e)
{
    struct particles particles = {0}, walls = {0};
    struct backend_setup setup = {
        .choice = &plan->choice,
        .space = &plan->space,
        .search = plan->search,
        .isa = options->isa ? options->isa : "auto",
        .threads = options->threads,
        .device = plan->device,
        .block = plan->block,
        .timed = options->timed,
    };
    const struct backend_row *row = simulation_backend(plan, options);
    *s = (struct simulation){.plan = plan, .row = row, .last_dt = INFINITY,
                             .relax = {1, 1, 1}, .strict = options->strict,
                             .queues = row->settle && !options->timed};
    s->stats.dt_min = INFINITY;
    if (start_bodies(plan->scene, &plan->space, &plan->bodies, plan->fields, &particles, e) ||
        solver_start(&plan->choice, &particles, e) ||
        start_walls(&plan->space, &plan->walls, &walls, e) ||
        s->row->open(&s->backend, &setup, &particles, &walls, e)) {
        particles_free(&particles);
        particles_free(&walls);
        return e->status;
    }
    if (first_forces(s, e))
        goto failed;
    s->last_dt = INFINITY;
    limits_now(s, s->stats.limits);
    s->last_dt = natural_step(s, NULL);
    s->least_dt = 1e-4 * s->last_dt;
    s->allowance = 0; /* rows for the first real step */
    if (!strict_check(s, INFINITY, 0, e))
        return STATUS_OK;
failed:
    simulation_close(s);
    return e->status;
}

void simulation_close(struct simulation *s)
{
    if (s->backend)
        s->row->close(s->backend);
    s->backend = NULL;
}
