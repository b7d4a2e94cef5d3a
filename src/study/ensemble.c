/* Chaotic cases: a point as the mean of runs from several seeds of disorder. */
#include "study/ensemble.h"

#include "study/set.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool is_random(const struct scene *scene, size_t body)
{
    return scene->bodies[body].jitter > 0 || scene->bodies[body].fill == FILL_RANDOM;
}

enum status ensemble_seed(struct study_set *set, const struct scene *scene, size_t member,
                          struct error *e)
{
    bool any = false;
    for (size_t k = 0; k < scene->body_count; k++) {
        char key[64], value[32];
        if (!is_random(scene, k))
            continue;
        any = true;
        snprintf(key, sizeof key, "bodies.%zu.seed", k);
        snprintf(value, sizeof value, "%llu", (unsigned long long)(scene->bodies[k].seed + member));
        if (member > 0 && set_say(set, key, value, "\"seeds\"", e))
            return e->status;
    }
    return any ? STATUS_OK
               : error_set(e, STATUS_USAGE, "\"seeds\": no body has \"jitter\" or \"fill\": \"random\", and all runs "
                           "would be alike; set for example \"bodies.0.jitter\": 0.05");
}

/* What became of all: what failed is not hidden by what did not. */
static void join_outcomes(struct study_point *point)
{
    point->outcome = OUTCOME_LEFT_OUT;
    for (size_t k = 0; k < point->member_count; k++) {
        const struct study_point *member = &point->members[k];
        bool failed = member->outcome != OUTCOME_LEFT_OUT && member->outcome != OUTCOME_DONE;
        if (point->outcome != OUTCOME_LEFT_OUT && !(point->outcome == OUTCOME_DONE && failed))
            continue;
        point->outcome = member->outcome;
        point->cause[0] = 0;
        if (failed)
            snprintf(point->cause, sizeof point->cause, "seed %zu of %zu: %.330s", k + 1,
                     point->member_count, member->cause);
        else if (member->outcome == OUTCOME_LEFT_OUT)
            snprintf(point->cause, sizeof point->cause, "%s", member->cause);
    }
}

static void join_errors(struct study_point *point, const struct study_error *of)
{
    struct study_error *joint = &point->errors.items[point->errors.count++];
    double sum = 0, sizes = 0, squares = 0;
    *joint = *of;
    joint->runs = 0;
    joint->seeds = (int)point->member_count;
    joint->least = INFINITY;
    joint->most = 0;
    for (size_t k = 0; k < point->member_count; k++) {
        const struct study_error *one = study_error(&point->members[k], of->name);
        if (point->members[k].outcome != OUTCOME_DONE || !one)
            continue;
        joint->runs++;
        sum += one->value;
        sizes += fabs(one->value);
        squares += one->value * one->value;
        joint->least = fmin(joint->least, fabs(one->value));
        joint->most = fmax(joint->most, fabs(one->value));
    }
    double count = joint->runs;
    joint->value = sum / count;
    joint->size = sizes / count;
    joint->deviation = count > 1 ? sqrt(fmax(squares - sum * sum / count, 0) / (count - 1)) : (double)NAN;
}

void ensemble_join(struct study_point *point)
{
    const struct study_point *example = NULL;
    if (!point->member_count)
        return;
    join_outcomes(point);
    for (size_t k = 0; k < point->member_count; k++) {
        const struct study_point *member = &point->members[k];
        if (member->outcome == OUTCOME_DONE &&
            (!example || member->errors.count > example->errors.count))
            example = member;
    }
    point->errors.count = 0;
    for (size_t k = 0; example && k < example->errors.count; k++)
        join_errors(point, &example->errors.items[k]);
    const struct study_point *first = &point->members[0];
    point->repeats = first->repeats;
    point->particles = first->particles;
    point->steps = first->steps;
    point->rejected = first->rejected;
    point->dt = first->dt;
    point->pairs = first->pairs;
    point->iterations = first->iterations;
    point->bytes = first->bytes;
    point->energy_drift = first->energy_drift;
    point->momentum_drift = first->momentum_drift;
    point->leak = first->leak;
    memcpy(point->wall, first->wall, sizeof point->wall);
    memcpy(point->cpu, first->cpu, sizeof point->cpu);
    memcpy(point->hash, first->hash, sizeof point->hash);
}
