/* Hands what is drawn of the present state to a snapshot. */
#include "run/frame.h"

#include "render/cuda/draw_kernels.h"
#include "run/step.h"

#include <math.h>
#include <string.h>

_Static_assert((int)SHOWN_FLUIDS == (int)FLUIDS_MAX, "pictures show every fluid");

static bool draws_walls(const struct plan *plan)
{
    return plan->draws && plan->scene->render.boundary;
}

size_t frame_count(const struct plan *plan)
{
    return plan->bodies.count + (draws_walls(plan) ? plan->walls.count : 0);
}

struct render_setup frame_setup(const struct plan *plan, const struct run_options *options)
{
    const struct scene *scene = plan->scene;
    struct render_setup setup = {
        .scene = scene,
        .renderer = options->renderer ? options->renderer : "auto",
        .device = plan->device,
        .on_device = plan->backend && plan->backend->device,
        .threads = options->threads,
        .raw = film_wants_raw(options->outputs, options->output_count),
        .vectors = film_wants_vectors(options->outputs, options->output_count),
        .isa = options->isa,
        .radius = scene->render.radius * scene->particles.spacing,
    };
    if (!plan->draws)
        return setup;
    setup.scale = plan->scale;
    memcpy(setup.palette, plan->palette, sizeof setup.palette);
    setup.label = plan->color->label;
    setup.unit = plan->color->unit;
    setup.name = plan->color->name;
    setup.solid = plan->color->solid;
    setup.symmetric = plan->symmetric;
    return setup;
}

/* How pictures are made on a device without the host. */
static const struct kernel *draw_kernels(const struct device_row *row)
{
#if HAVE_CUDA
    if (row == &device_cuda)
        return draw_kernels_cuda;
#endif
    (void)row;
    return NULL;
}

struct render_source frame_source(const struct plan *plan, const struct backend_row *row)
{
    struct render_source source = {.row = row->device, .kernels = draw_kernels(row->device), .device = plan->device,
                                   .count = frame_count(plan)};
    for (int a = 0; a < 3; a++) {
        source.low[a] = plan->space.origin[a] - plan->scene->domain.min[a];
        source.high[a] = source.low[a] + plan->space.length[a];
    }
    return source;
}

static uint32_t paint(const struct scene_fluid *fluid)
{
    uint32_t rgba = 0xff000000;
    for (int c = 0; c < 3; c++)
        rgba |= (uint32_t)lround(255 * fmin(1, fmax(0, fluid->color[c]))) << 8 * c;
    return rgba;
}

/* What the plan's pictures show, but for the state. */
static struct shown shown_of(const struct plan *plan, struct shown_to to)
{
    const struct scene *scene = plan->scene;
    struct shown s = {.walls = draws_walls(plan), .value = plan->fixed ? VALUE_fixed : plan->color->value,
                      .solid = plan->color->solid, .fixed = plan->fixed, .wall_color = 0xa0a0a0a0,
                      .wall_value = (float)plan->scale.range[0], .to = to};
    for (size_t f = 0; f < scene->fluid_count; f++) {
        s.rest_density[f] = plan->choice.each.rest_density[f];
        s.color[f] = paint(&scene->fluids[f]);
        s.visible[f] = scene->fluids[f].visible;
    }
    memcpy(s.origin, plan->space.origin, sizeof s.origin);
    memcpy(s.unit, plan->space.unit, sizeof s.unit);
    memcpy(s.min, scene->domain.min, sizeof s.min);
    memcpy(s.clip_min, scene->render.clip_min, sizeof s.clip_min);
    memcpy(s.clip_max, scene->render.clip_max, sizeof s.clip_max);
    memcpy(s.range, scene->render.show_range, sizeof s.range);
    return s;
}

enum status frame_fill(struct simulation *s, struct film_snapshot *snapshot, struct error *e)
{
    const struct plan *plan = s->plan;
    const struct render_slot *slot = snapshot->slot;
    struct step step = {.list_radius = plan->choice.support};
    struct shown_to to = {snapshot->position, plan->color->solid ? (void *)snapshot->color
                                                                 : (void *)snapshot->value};
    if (plan->frame_pass && step_pass(s, plan->frame_pass->id, &step, e))
        return e->status;
    snapshot->bodies = plan->bodies.count;
    const struct shown shown = shown_of(plan, slot ? slot->to : to);
    return s->row->show(s->backend, &shown, slot ? slot->filled : NULL, e);
}
