/* A simulation from the text of a scene, without film or files, for tests of the physics. */
#ifndef TESTS_WORLD_H
#define TESTS_WORLD_H

#include "base/log.h"
#include "run/simulation.h"
#include "scene_file.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

struct world {
    struct scene *scene;
    struct plan plan;
    struct simulation simulation;
    struct run_options options;
    struct error error;
};

/* Opens a scene on one thread, which is fastest for few particles. */
#define world_open(w, ...) world_open_on(w, "auto", 1, __VA_ARGS__)

/* Opens a scene given as printf arguments on `isa` and `threads`; fails the test when it cannot. */
__attribute__((format(printf, 4, 5))) static inline void
world_open_on(struct world *w, const char *isa, int threads, const char *format, ...)
{
    static char text[16384];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    assert_in_range(length, 1, sizeof text - 1);
    memset(w, 0, sizeof *w);
    w->options = (struct run_options){.threads = threads, .isa = isa};
    struct error *e = &w->error;
    if (scene_from_text(&w->scene, text, (size_t)length, NULL, &run_vocabulary, e) ||
        plan_make(&w->plan, w->scene, &w->options, e) ||
        simulation_open(&w->simulation, &w->plan, &w->options, e))
        fail_msg("%s", e->text);
}
static inline void world_advance(struct world *w, double time)
{
    if (simulation_advance(&w->simulation, time, &w->error))
        fail_msg("%s", w->error.text);
}

static inline void world_close(struct world *w)
{
    simulation_close(&w->simulation);
    plan_free(&w->plan);
    scene_free(w->scene);
}

static inline const struct particles *world_state(struct world *w)
{
    struct error e = {0};
    return w->simulation.row->state(w->simulation.backend, UINT32_MAX, &e);
}

/* Coordinate of the particle at place i in memory, m. */
static inline double world_metres(struct world *w, size_t i, int axis)
{
    uint32_t count = particles_position(world_state(w))[i].count[axis];
    return space_metres(&w->plan.space, axis, count);
}

/* Mass of the particle at place i in memory, kg. */
static inline double world_mass(struct world *w, size_t i)
{
    double d = w->plan.choice.spacing;
    return (double)w->plan.choice.each.mass[particles_fluid(world_state(w), i)] * d * d * d;
}

#endif
