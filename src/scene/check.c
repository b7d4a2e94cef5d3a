/* Checks what single keys cannot know: faces, fluids, times, amounts. */
#include "base/suggest.h"
#include "scene/load.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double particle_limit = 4294967294.0, frame_limit = 1e7, lattice_limit = 1 << 20;

static enum status check_domain(struct load *load)
{
    const struct scene *s = load->scene;
    for (int a = 0; a < 3; a++) {
        double edge = s->domain.max[a] - s->domain.min[a];
        if (!(edge > 0) || !isfinite(edge))
            return load_fail(load, load_place(load, "domain.max"), "domain.max is not above "
                             "domain.min along %c: %g and %g", "xyz"[a], s->domain.max[a],
                             s->domain.min[a]);
        if (edge < s->particles.spacing)
            return load_fail(load, load_place(load, "particles.spacing"), "particles.spacing %g m "
                             "is more than the domain's %g m along %c; make it smaller",
                             s->particles.spacing, edge, "xyz"[a]);
        if (edge / s->particles.spacing > lattice_limit)
            return load_fail(load, load_place(load, "particles.spacing"), "particles.spacing %g m "
                             "is less than a millionth of the domain's %g m along %c; make it %g "
                             "or more", s->particles.spacing, edge, "xyz"[a], edge / lattice_limit);
    }
    return STATUS_OK;
}

static enum status check_walls(struct load *load)
{
    const enum wall_kind *walls = load->scene->domain.walls;
    for (int f = 0; f < FACE_COUNT; f++) {
        char path[KEY_TEXT_SIZE];
        if (walls[f] != WALL_PERIODIC || walls[f ^ 1] == WALL_PERIODIC)
            continue;
        snprintf(path, sizeof path, "domain.walls.%s", scene_face_names[f]);
        return load_fail(load, load_place(load, path), "%s is periodic but its opposite %s is not; "
                         "periodic faces come in pairs", path, scene_face_names[f ^ 1]);
    }
    return STATUS_OK;
}

/* Only closed planes with no_slip drag, and only along themselves. */
static enum status check_wall_velocity(struct load *load)
{
    const struct scene *s = load->scene;
    for (int f = 0; f < FACE_COUNT; f++) {
        const double *v = s->domain.wall_velocity[f];
        char path[KEY_TEXT_SIZE];
        snprintf(path, sizeof path, "domain.wall_velocity.%s", scene_face_names[f]);
        if (v[0] == 0 && v[1] == 0 && v[2] == 0)
            continue;
        if (s->domain.walls[f] != WALL_CLOSED || !s->domain.no_slip)
            return load_fail(load, load_place(load, path), "%s: only a closed wall with "
                             "domain.no_slip drags the fluid along; make domain.walls.%s closed and "
                             "domain.no_slip true, or remove the key", path, scene_face_names[f]);
        if (v[f / 2] != 0)
            return load_fail(load, load_place(load, path), "%s: the wall can move along itself "
                             "only, so its %c must be 0, not %g m/s", path, "xyz"[f / 2], v[f / 2]);
    }
    return STATUS_OK;
}

static enum status check_fluids(struct load *load)
{
    const struct scene *s = load->scene;
    if (s->fluid_count == 0)
        return load_fail(load, load->arrays[ARRAY_FLUIDS].place, "\"fluids\" is %s; give at least "
                         "one: \"fluids\": [{\"name\": \"water\", \"density\": 1000, "
                         "\"viscosity\": 1e-3}]",
                         load->arrays[ARRAY_FLUIDS].place.doc ? "empty" : "missing");
    for (size_t i = 0; i < s->fluid_count; i++) {
        struct place place = load_element_place(load, ARRAY_FLUIDS, i, "fluids[].name");
        if (s->fluids[i].name[0] == '\0')
            return load_fail(load, place, "fluids.%zu.name is empty; name the fluid", i);
        for (size_t j = 0; j < i; j++)
            if (strcmp(s->fluids[i].name, s->fluids[j].name) == 0)
                return load_fail(load, place, "fluids.%zu.name: fluids.%zu is \"%s\" already; give "
                                 "each fluid its own name", i, j, s->fluids[i].name);
    }
    return STATUS_OK;
}

/* Finds each body's fluid by name. */
static enum status resolve_fluids(struct load *load)
{
    struct scene *s = load->scene;
    for (size_t i = 0; i < s->body_count; i++) {
        struct scene_body *body = &s->bodies[i];
        struct suggest near;
        suggest_start(&near, body->fluid_name);
        body->fluid = body->fluid_name[0] ? -1 : 0;
        for (size_t f = 0; f < s->fluid_count; f++) {
            suggest_offer(&near, s->fluids[f].name);
            if (strcmp(s->fluids[f].name, body->fluid_name) == 0)
                body->fluid = (int)f;
        }
        const char *best = suggest_best(&near);
        if (body->fluid < 0)
            return load_fail(load, load_element_place(load, ARRAY_BODIES, i, "bodies[].fluid"),
                             "bodies.%zu.fluid: no fluid is named \"%s\"; %s \"%s\"", i,
                             body->fluid_name, best ? "did you mean" : "the first is",
                             best ? best : s->fluids[0].name);
        memcpy(body->fluid_name, s->fluids[body->fluid].name, KEY_TEXT_SIZE);
    }
    return STATUS_OK;
}

static enum status check_times(struct load *load)
{
    const struct scene *s = load->scene;
    if (s->movie.start > s->time.end)
        return load_fail(load, load_place(load, "movie.start"), "movie.start %g s is after "
                         "time.end %g s; the film would be empty", s->movie.start, s->time.end);
    double frames = (s->time.end - s->movie.start) / s->movie.speed * s->movie.fps;
    if (frames > frame_limit)
        return load_fail(load, load_place(load, "time.end"), "the film would have %.3g frames; "
                         "lower time.end or movie.fps, or raise movie.speed", frames);
    return STATUS_OK;
}

static enum status check_map(struct load *load)
{
    const struct scene *s = load->scene;
    if (s->color.steps == 1)
        return load_fail(load, load_place(load, "color.steps"), "color.steps: one colour shows "
                         "nothing; give 2 to 256, or 0 for a continuous scale");
    if (s->color.map_file[0] && strcmp(s->color.map, "auto") != 0)
        return load_fail(load, load_place(load, "color.map_file"), "color.map_file and color.map "
                         "are both given; remove one");
    return STATUS_OK;
}

static enum status check_color(struct load *load)
{
    const struct scene *s = load->scene;
    const double *range = s->color.range, *percentiles = s->color.percentiles;
    if (!isnan(range[0]) && range[0] >= range[1])
        return load_fail(load, load_place(load, "color.range"), "color.range: the second value "
                         "must be above the first");
    if (s->color.scale == SPREAD_LOG && range[0] <= 0)
        return load_fail(load, load_place(load, "color.range"), "color.range: a log scale begins "
                         "above 0, not at %g; raise the first value, or make color.scale linear",
                         range[0]);
    if (percentiles[0] >= percentiles[1])
        return load_fail(load, load_place(load, "color.percentiles"), "color.percentiles: the "
                         "second value must be above the first");
    if (!isnan(percentiles[0]) && !isnan(range[0]))
        return load_fail(load, load_place(load, "color.percentiles"), "color.percentiles and "
                         "color.range are both given; remove one");
    return check_map(load);
}

static enum status check_amount(struct load *load)
{
    const struct scene *s = load->scene;
    double volume = 0, d = s->particles.spacing;
    for (size_t i = 0; i < s->body_count; i++)
        volume += shape_volume(&s->bodies[i].shape);
    if (volume / (d * d * d) > particle_limit)
        return load_fail(load, load_place(load, "particles.spacing"), "particles.spacing %g m "
                         "would make %.3g particles; at most %.0f can be numbered, so spacing %.3g or "
                         "more, and %.3g would make a million", d, volume / (d * d * d),
                         particle_limit, cbrt(volume / particle_limit), cbrt(volume / 1e6));
    return STATUS_OK;
}

enum status check_scene(struct load *load)
{
    static enum status (*const checks[])(struct load *) = {
        check_domain, check_walls, check_wall_velocity, check_fluids, resolve_fluids, check_times,
        check_camera, check_color, check_amount, check_bodies, check_obstacles, check_measures};
    enum status status = STATUS_OK;
    for (size_t i = 0; i < sizeof checks / sizeof *checks && !status; i++)
        status = checks[i](load);
    return status;
}
