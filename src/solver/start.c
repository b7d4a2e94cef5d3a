/* Makes the solver's state from the pressure that particles start with. */
#include "solver/solver.h"

#define DENSEST 2 /* times rest density: beyond it the start is no fluid at rest */

enum status solver_start(const struct solver_choice *choice, struct particles *particles,
                         struct error *e)
{
    const struct explicit_constants *c = &choice->each;
    for (size_t i = 0; i < particles->count; i++) {
        float *pressure = &particles_motion(particles)[i].pressure;
        int fluid = particles_fluid(particles, i);
        if (c->clamp && *pressure < 0)
            *pressure = 0;
        if (!choice->continuity || *pressure == 0)
            continue;
        float density = explicit_density(c, fluid, *pressure);
        if (!(density < DENSEST * c->rest_density[fluid]))
            return error_set(e, STATUS_USAGE, "the start pressure of particle %zu, %.4g Pa, would "
                             "compress its fluid to %.3g times its density; raise "
                             "solver.sound_speed (now %.4g m/s) or use bodies[].start \"rest\"",
                             i, (double)*pressure, (double)density / c->rest_density[fluid],
                             choice->sound_speed);
        particles_density(particles)[i] = density;
    }
    return STATUS_OK;
}
