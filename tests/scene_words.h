/* A small vocabulary for tests of scenes. */
#ifndef TESTS_SCENE_WORDS_H
#define TESTS_SCENE_WORDS_H

#include "scene_file.h"

#include <math.h>
#include <string.h>

#define OPTION(path, type, flags, fallback, min, max, choices) \
    {path, type, flags, fallback, min, max, "", choices, "an option", KEY_OPTION}

static const struct key alpha_keys[] = {
    OPTION("solver.delta", KEY_REAL, 0, "0.1", 0, 1, NULL),
    OPTION("solver.sound_speed", KEY_REAL, KEY_AUTO, "\"auto\"", 0, INFINITY, NULL),
    OPTION("solver.eos", KEY_CHOICE, 0, "\"tait\"", 0, 0, "tait|linear"),
};
static const struct key beta_keys[] = {
    OPTION("solver.sound_speed", KEY_REAL, 0, "20", 0, INFINITY, NULL),
    OPTION("solver.clamp", KEY_BOOL, 0, "true", 0, 0, NULL),
};
static const struct key drag_keys[] = {
    OPTION("drag.strength", KEY_REAL, 0, "0", 0, INFINITY, NULL),
    OPTION("drag.wind", KEY_VEC3, 0, "[0, 0, 1]", 0, 0, NULL),
    OPTION("drag.steps", KEY_INT, 0, "4", 1, 9, NULL),
};
static const struct variant alpha = {"isph", "first", alpha_keys, 3, NULL};
static const struct variant beta = {"muller", "second", beta_keys, 2, NULL};
static const struct variant gamma_row = {"quantum", "third", NULL, 0, "make QUANTUM=1"};
static const struct variant drag = {"drag", "a force", drag_keys, 3, NULL};
static const struct variant *const solver_rows[] = {&alpha, &beta, &gamma_row};
static const struct variant *const force_rows[] = {&drag};
static const struct variant_table solver_table = {"solvers", "solvers", solver_rows, 3};
static const struct variant_table force_table = {"forces", "forces", force_rows, 1};
static const struct variant no_flow = {"none", "no flow", NULL, 0, NULL};
static const struct variant *const flow_rows[] = {&no_flow};
static const struct variant_table flow_words = {"flows", "flows", flow_rows, 1};
static const struct variant_table *const word_tables[] = {&solver_table, &force_table, &flow_words};
static const struct vocabulary words = {word_tables, 3};

/* A scene with a hole for more members: "" or ", \"time\": ..." must complete it. */
#define SCENE_HEAD \
    "{\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 1]}, \"particles\": {\"spacing\": 0.1},\n"
#define SCENE_FLUID " \"fluids\": [{\"name\": \"water\"}],\n"
#define SCENE_END " \"time\": {\"end\": 1}}\n"
#define SCENE_PLAIN SCENE_HEAD SCENE_FLUID SCENE_END

/* Loads a scene of these words from text. */
static inline enum status load_text(struct scene **scene, const char *text, size_t length,
                                    const struct scene_overrides *set, struct error *e)
{
    return scene_from_text(scene, text, length, set, &words, e);
}

#endif
