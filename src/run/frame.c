/* Copies what is drawn of the present state into a snapshot. */
#include "run/frame.h"

#include <math.h>
#include <string.h>

static bool draws_walls(const struct plan *plan)
{
    return plan->draws && plan->scene->render.boundary;
}

size_t frame_count(const struct plan *plan)
{
    return plan->bodies.count + (draws_walls(plan) ? plan->walls.count : 0);
}

static void place(const struct simulation *s, const struct position *x, float out[3])
{
    for (int a = 0; a < 3; a++)
        out[a] = (float)(space_metres(&s->plan->space, a, x->count[a]) -
                         s->plan->scene->domain.min[a]);
}

static void paint(const struct scene_fluid *fluid, uint8_t out[4])
{
    for (int c = 0; c < 3; c++)
        out[c] = (uint8_t)lround(255 * fmin(1, fmax(0, fluid->color[c])));
    out[3] = 255;
}

/* Whether the scene wants a particle drawn: of this fluid (-1: a wall's), there, with that value. */
static bool is_shown(const struct scene *scene, int fluid, const float position[3], float value)
{
    const double *range = scene->render.show_range;
    if (fluid >= 0 && !scene->fluids[fluid].visible)
        return false;
    for (int a = 0; a < 3; a++) {
        double x = scene->domain.min[a] + (double)position[a];
        if (x < scene->render.clip_min[a] || x > scene->render.clip_max[a]) /* NAN: neither */
            return false;
    }
    return !((double)value < range[0] || (double)value > range[1]);
}

/* Out of everybody's sight. */
static void hide(float position[3])
{
    position[0] = position[1] = position[2] = NAN;
}

void frame_fill(struct simulation *s, struct film_snapshot *snapshot)
{
    const struct plan *plan = s->plan;
    const struct particles *p = s->row->state(s->backend), *walls = s->row->walls(s->backend);
    const struct color_row *color = plan->color;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        size_t id = particles_id(p)[i];
        place(s, &particles_position(p)[i], snapshot->position + 3 * id);
        if (color->solid)
            paint(&plan->scene->fluids[particles_fluid(p, i)], snapshot->color + 4 * id);
        else
            snapshot->value[id] = color->value(p, i);
        if (!is_shown(plan->scene, particles_fluid(p, i), snapshot->position + 3 * id,
                      color->solid ? NAN : snapshot->value[id]))
            hide(snapshot->position + 3 * id);
    }
    for (size_t i = 0; draws_walls(plan) && i < walls->count; i++) {
        size_t id = p->count + particles_id(walls)[i];
        place(s, &particles_position(walls)[i], snapshot->position + 3 * id);
        if (color->solid)
            memset(snapshot->color + 4 * id, 160, 4);
        else
            snapshot->value[id] = (float)plan->color_range[0];
        if (!is_shown(plan->scene, -1, snapshot->position + 3 * id, NAN))
            hide(snapshot->position + 3 * id);
    }
}
