/* One trial of a scene with settings: its plan, and the time of a fixed number of steps. */
#ifndef STUDY_TRIAL_H
#define STUDY_TRIAL_H

#include "study/set.h"

#include "run/plan.h"

struct scene_trial {
    struct scene *scene;
    struct plan plan;
    bool planned;         /* plan is there */
    char reason[400];     /* why it cannot run; "" */
    uint64_t hash;        /* of the state after the steps */
    double ns;            /* of processor time per particle and step, the least of all runs; INFINITY before the first */
    double step;          /* mean, s */
    double bytes;         /* per particle, of all labelled memory of the run, neighbours and walls too */
};

/* Loads and plans the scene without outputs; that it cannot be is `reason`. STATUS_RUN when memory is
 * short. Free with trial_close, also after failure. */
enum status trial_open(struct scene_trial *trial, const char *scene, const struct study_set *set,
                       struct error *e);

/* Runs so many steps from the start. A run that stops is a reason, too. Two that end in other states are
 * STATUS_RUN. */
enum status trial_run(struct scene_trial *trial, long steps, int threads, struct error *e);
void trial_close(struct scene_trial *trial);

#endif
