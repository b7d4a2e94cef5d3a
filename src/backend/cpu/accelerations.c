/* Optional accelerations on the cpu: surface tension, central force, buoyancy, dissipation. */
#include "backend/cpu/cpu.h"

struct tension_work cpu_tension_work(const struct backend *b, float *pressure)
{
    return (struct tension_work){
        .each = &b->choice.each,
        .constants = &b->choice.tension,
        .fluid = b->fluid,
        .normal = b->particles.now[FIELD_NORMAL],
        .pressure = pressure,
    };
}

void cpu_tension(struct backend *b, enum pair_pass pass, float *pressure)
{
    const struct particles *p = &b->particles;
    struct tension_work tension = cpu_tension_work(b, pressure);
    struct pair_work work = cpu_pair_work(b);
    work.tension = &tension;
    for (size_t i = 0; pass == PAIR_PASS_NORMALS && b->fluid && i < p->count; i++)
        b->fluid[i] = (float)particles_fluid(p, i); /* in the present order */
    cpu_pair_blocks(b, &work, b->isa->find(pass, b->choice.flags, b->wall.count > 0));
}

void cpu_external(struct backend *b, const struct step *step)
{
    const struct particles *p = &b->particles;
    const struct position *position = cpu_position(b);
    const float *gravity = b->choice.pair.gravity;
    float dt = b->choice.is_implicit && !b->choice.projects ? step->dt : 0;
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
