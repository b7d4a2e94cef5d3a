/* Runs a scene: plan, particles, steps, frames, outputs, report. */
#ifndef RUN_RUN_H
#define RUN_RUN_H

#include "base/error.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>

struct encode_reference;

/* How to run; none of it changes the bits of the state. */
struct run_options {
    const char *const *outputs; /* -o, in order */
    size_t output_count;
    const double *times;        /* --at, s, ascending: frames of exactly these states, no film */
    size_t time_count;          /* 0: a film, or with a sheet times equally far apart */
    int sheet[2];               /* columns and rows of pictures in one frame; 0: none */
    int threads;                /* 0: all processors */
    bool timed;                 /* each pass by itself, for bench */
    bool elsewhere;             /* another process will run it: devices are not touched, since one may serve one process */
    bool strict;                /* a step shorter than time.step is an error */
    const char *backend;        /* row of the table "backends", or "auto" */
    const char *renderer;       /* row of the table "renderers", or "auto" */
    const char *isa;            /* row of the table "isas", or "auto" */
    const char *report;         /* JSON file, or NULL */
    const char *write_scene;    /* file for the effective scene, or NULL */
    const struct encode_reference *reference; /* of the output "reference", or NULL */
};

/* All variant tables, for list, --help and scene_load. */
extern const struct vocabulary run_vocabulary;

/* Whether the scene could run here: numbers of fluids and particles, memory. */
enum status run_check(const struct scene *scene, const struct run_options *options,
                      struct error *e);

/* Says so when there are more threads than processors. */
void run_warn_threads(int threads);

/* Prints the plan and stops. */
enum status run_plan(const struct scene *scene, const struct run_options *options, FILE *out,
                     struct error *e);
enum status run_scene(const struct scene *scene, const struct run_options *options,
                      struct error *e);

#endif
