/* Estimates particles and memory of a plan. */
#include "run/budget.h"

#include "base/machine.h"
#include "particles/fill_obstacles.h"
#include "render/render.h"
#include "run/film.h"

#include <math.h>

#define PARTICLES_MAX 4294967294.0 /* 2^32 - 2: ids are 32 bits, and the last one means none */
#define WORK_BYTES 52              /* a particle: sort 24, coordinates 12, rows 8, cells up to 8 */
#define CURL_BYTES 80              /* a particle in the copy: two of position and motion, id, rows */
#define START_BYTES (sizeof(double[3]) + sizeof(int))
#define SNAPSHOT_BYTES 16          /* a particle in a frame that waits: position, value or colour */
#define DRAWN_BYTES 24             /* a particle that a device draws: its sphere, or sprite */

/* Bytes that each particle, or wall particle, takes at the least. */
static double fluid_bytes(const struct plan *plan)
{
    const struct solver_choice *c = &plan->choice;
    double bytes = (double)plan->bytes_per_particle + START_BYTES + WORK_BYTES +
                   solver_row_bytes(c) * kernel_lattice_neighbours(c->support / c->spacing);
    if (plan->frame_pass) /* a sorted copy with rows of its own (backend/cpu/curl.c) */
        bytes += CURL_BYTES + 4 * kernel_lattice_neighbours(c->support / c->spacing);
    if (plan->draws)
        bytes += FILM_SNAPSHOTS * SNAPSHOT_BYTES + (plan->color->fixed ? sizeof(float) : 0);
    return bytes;
}

static double wall_bytes(void)
{
    return START_BYTES + WORK_BYTES + sizeof(struct position) + sizeof(uint32_t);
}

/* Bytes that each particle takes of a device: what the host would need for passes and frames. */
static double device_bytes(const struct plan *plan)
{
    const struct solver_choice *c = &plan->choice;
    return (double)plan->bytes_per_particle + WORK_BYTES +
           solver_row_bytes(c) * kernel_lattice_neighbours(c->support / c->spacing) +
           (plan->draws ? FILM_SNAPSHOTS * SNAPSHOT_BYTES + DRAWN_BYTES : 0);
}

/* The same for a device that was asked for; `fluid` and `wall` are numbers of particles. If it is not to be touched, it
 * only has to be there. */
static enum status device_check(const struct plan *plan, double fluid, double wall, bool touch, struct error *e)
{
    char name[64] = "";
    if (!plan->backend || !plan->backend->memory)
        return STATUS_OK;
    if (!touch)
        return plan->backend->exists(plan->device, e);
    double have = plan->backend->memory(plan->device, name, e);
    double drawn = plan->draws && plan->scene->render.boundary ? FILM_SNAPSHOTS * SNAPSHOT_BYTES + DRAWN_BYTES : 0;
    double bytes = fluid * device_bytes(plan) + wall * (wall_bytes() + drawn);
    double d = plan->scene->particles.spacing;
    if (e->status || bytes <= have)
        return e->status;
    return error_set(e, STATUS_RUN, "%s: particles.spacing %g m makes about %.4g particles, which take "
                     "%.4g GB (%.0f bytes each) of %s, but %.4g GB are free there: use a spacing of "
                     "%.3g m or more, another device, or --backend cpu",
                     plan->scene->source, d, fluid, 1e-9 * bytes, device_bytes(plan), name, 1e-9 * have,
                     d * cbrt(bytes / fmax(have, 1)) * 1.01);
}

enum status budget_check(const struct plan *plan, bool touch, struct error *e)
{
    const struct scene *scene = plan->scene;
    double fluid = fill_bodies_estimate(scene), d = scene->particles.spacing;
    double wall = fill_walls_estimate(scene, plan->choice.support) +
                  fill_obstacles_estimate(scene, plan->choice.support);
    double bytes = fluid * fluid_bytes(plan) + wall * wall_bytes();
    const char *what;
    double have = machine_memory(&what), most = fmax(fluid, wall);
    if (most > PARTICLES_MAX)
        return error_set(e, STATUS_USAGE, "%s: particles.spacing %g m would make %.4g particles%s; "
                         "at most %.0f can be numbered: use a spacing of %.3g m or more",
                         scene->source, d, most, wall > fluid ? " in the walls" : "",
                         PARTICLES_MAX, d * cbrt(most / PARTICLES_MAX) * 1.01);
    if (have == 0 || bytes <= have)
        return device_check(plan, fluid, wall, touch, e);
    return error_set(e, STATUS_RUN, "%s: particles.spacing %g m makes about %.4g particles (and "
                     "%.4g in walls), which take %.4g GB (%.0f bytes each), but there are %.4g GB "
                     "(%s): use a spacing of %.3g m or more, or smaller bodies",
                     scene->source, d, fluid, wall, 1e-9 * bytes, fluid_bytes(plan), 1e-9 * have,
                     what, d * cbrt(bytes / have) * 1.01);
}
