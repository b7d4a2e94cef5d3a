/* Optional accelerations on the cpu: surface tension, central force, buoyancy, dissipation. */
#include "backend/cpu/cpu.h"

static void run_tension(struct backend *b, enum pair_pass pass)
{
    struct tension_work tension = {
        .each = &b->choice.each,
        .constants = &b->choice.tension,
        .fluid = b->fluid,
        .normal = b->particles.now[FIELD_NORMAL],
    };
    struct pair_work work = cpu_pair_work(b);
    work.tension = &tension;
    cpu_pair_blocks(b, &work, b->isa->find(pass, b->choice.flags, b->wall.count > 0));
}

void cpu_normals(struct backend *b)
{
    for (size_t i = 0; b->fluid && i < b->particles.count; i++) /* in their present order */
        b->fluid[i] = (float)particles_fluid(&b->particles, i);
    run_tension(b, PAIR_PASS_NORMALS);
}

void cpu_tension(struct backend *b)
{
    run_tension(b, PAIR_PASS_TENSION);
}

void cpu_external(struct backend *b, const struct step *step)
{
    const struct particles *p = &b->particles;
    const struct position *position = cpu_position(b);
    const float *gravity = b->choice.pair.gravity;
    float dt = b->choice.is_implicit ? step->dt : 0;
    bool starts = b->choice.starts_rate;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct rate *rate = &particles_rate(p)[i];
        if (starts)
            *rate = (struct rate){{gravity[0], gravity[1], gravity[2]}, 0};
        if (b->choice.external.any)
            external_rate(&b->choice.external, particles_fluid(p, i), dt, &position[i],
                          &particles_motion(p)[i], rate);
    }
}
