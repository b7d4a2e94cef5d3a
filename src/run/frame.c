/* Copies what is drawn of the present state into a snapshot. */
#include "run/frame.h"

#include "run/step.h"

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

/* Order of floats as integers; what is not a number is 0. */
static uint32_t rank_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return value != value ? 0 : bits >> 31 ? ~bits : bits | 0x80000000u;
}

static float value_of(uint32_t rank)
{
    uint32_t bits = rank >> 31 ? rank & 0x7fffffffu : ~rank;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The value that `percent` of all do not exceed, found bit by bit from the top. */
static double percentile(const float *values, size_t count, double percent)
{
    size_t wanted = (size_t)ceil(percent / 100 * (double)count);
    uint32_t rank = 0;
    wanted = wanted < 1 ? 1 : wanted;
    for (int shift = 24; shift >= 0; shift -= 8) {
        size_t histogram[256] = {0};
        uint32_t part = 0;
        for (size_t i = 0; i < count; i++) {
            uint32_t own = rank_of(values[i]);
            if (shift == 24 || own >> (shift + 8) == rank >> (shift + 8))
                histogram[own >> shift & 255]++;
        }
        while (part < 255 && wanted > histogram[part])
            wanted -= histogram[part++];
        rank |= part << shift;
    }
    return (double)value_of(rank);
}

/* The ends of the map for one frame; a log scale stays above 0, a symmetric one about it. A frame of one
 * value keeps the film's range. */
static void range_by_frame(const struct plan *plan, const float *values, size_t count,
                           struct color_scale *scale)
{
    const double *percent = plan->scene->color.percentiles;
    double low, high;
    if (count == 0)
        return;
    low = percentile(values, count, percent[0]);
    high = percentile(values, count, percent[1]);
    if (plan->symmetric) {
        high = fmax(fabs(low), fabs(high));
        low = -high;
    }
    if (scale->log)
        low = fmax(low, DECADES_MIN * high);
    if (high > low && isfinite(high - low)) {
        scale->range[0] = low;
        scale->range[1] = high;
    }
}

enum status frame_fill(struct simulation *s, struct film_snapshot *snapshot, struct error *e)
{
    const struct plan *plan = s->plan;
    struct step step = {.list_radius = plan->choice.support};
    if (plan->frame_pass && step_pass(s, plan->frame_pass->id, &step, e))
        return e->status;
    const struct particles *walls = s->row->walls(s->backend);
    const struct particles *p = s->row->state(s->backend, plan->seen, e);
    if (!p)
        return e->status;
    const struct color_row *color = plan->color;
    const struct color_source source = {p, &plan->bodies, plan->choice.each.rest_density};
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        size_t id = particles_id(p)[i];
        place(s, &particles_position(p)[i], snapshot->position + 3 * id);
        if (color->solid)
            paint(&plan->scene->fluids[particles_fluid(p, i)], snapshot->color + 4 * id);
        else
            snapshot->value[id] = color->value(&source, i);
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
            snapshot->value[id] = (float)plan->scale.range[0];
        if (!is_shown(plan->scene, -1, snapshot->position + 3 * id, NAN))
            hide(snapshot->position + 3 * id);
    }
    if (snapshot->value && !isnan(plan->scene->color.percentiles[0]))
        range_by_frame(plan, snapshot->value, p->count, &snapshot->scale);
    return STATUS_OK;
}
