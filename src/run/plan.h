/* The plan: everything a run does, decided once from the scene and the outputs. */
#ifndef RUN_PLAN_H
#define RUN_PLAN_H

#include "backend/backend.h"
#include "particles/fill.h"
#include "render/color.h"
#include "render/maps.h"
#include "render/scale.h"
#include "run/measure.h"
#include "run/run.h"

struct plan {
    const struct scene *scene;
    const struct solver_row *solver;
    const struct search_row *search;
    const struct backend_row *backend; /* NULL: the first that can run, when it does */
    const struct color_row *color; /* NULL when no output wants pixels */
    bool draws;
    struct color_scale scale;      /* of the colour's values */
    bool symmetric;                /* about zero */
    uint8_t palette[MAP_SIZE][3];
    float *fixed;                  /* by id: the colour's values, where they never change; else NULL */
    const struct pass_row *frame_pass; /* that the colour needs before each frame; NULL: none */
    struct space space;
    struct solver_choice choice;
    struct fill bodies, walls;     /* start points */
    struct measures measures;      /* empty when no output wants rows */
    const struct pass_row *passes[STEP_PASSES_MAX]; /* of one step, in order */
    size_t pass_count;
    unsigned fields;               /* allocated */
    int device;                    /* of the cuda back end */
    unsigned block;                /* struct backend_place */
    size_t bytes_per_particle;     /* of the fields, without neighbour rows */
    const char *omitted[32];       /* "what: why" */
    size_t omitted_count;
};

/* Notes what is left out, and why. */
void plan_omit(struct plan *plan, const char *what_and_why);

/* Whether the scene can be planned on this machine, without making a particle. */
enum status plan_check(const struct scene *scene, const struct run_options *options,
                       struct error *e);

/* STATUS_USAGE when the scene asks for what cannot be, STATUS_RUN when memory is short. */
enum status plan_make(struct plan *plan, const struct scene *scene,
                      const struct run_options *options, struct error *e);
void plan_free(struct plan *plan);

/* The plan in words; the same text on every machine. */
void plan_write(const struct plan *plan, FILE *out);

#endif
