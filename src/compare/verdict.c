/* Judges a frame: the first accepted version within the limits, or the nearest one. */
#include "compare/verdict.h"

#include <math.h>
#include <stdlib.h>

enum { MAP_GAIN = 16 }; /* one level of difference shows as 16 */

const char *verdict_word(enum verdict_state state)
{
    static const char *const words[VERDICT_STATES] = {
        [VERDICT_EQUAL] = "equal",          [VERDICT_SAME] = "same",
        [VERDICT_DIFFERENT] = "different",  [VERDICT_SIZE] = "size differs",
        [VERDICT_MISSING] = "missing",      [VERDICT_EXTRA] = "extra",
    };
    return words[state];
}

/* How far a value is over its limit, as a part of it. */
static double excess_of(const struct score *score, double value, double limit)
{
    double over = score->is_likeness ? limit - value : value - limit;
    if (isnan(limit) || over <= 0)
        return 0;
    return limit > 0 ? over / limit : (double)INFINITY;
}

static enum status judge(struct verdict *verdict, const struct limits *limits,
                         const struct image *frame, const struct image *accepted, struct error *e)
{
    bool equal = true, same = true;
    verdict->frame = frame;
    verdict->accepted = accepted;
    verdict->excess = INFINITY;
    verdict->state = VERDICT_SIZE;
    if (frame->width != accepted->width || frame->height != accepted->height)
        return STATUS_OK;
    if (metric_measure(frame, accepted, &limits->settings, verdict->values, e))
        return e->status;
    verdict->excess = 0;
    for (size_t i = 0; i < metric_score_count(); i++) {
        const struct score *score = metric_score(i);
        double value = verdict->values[i];
        equal = equal && value == score->equal;
        same = same && metric_keeps(score, value, limits->value[i]);
        verdict->excess = fmax(verdict->excess, excess_of(score, value, limits->value[i]));
    }
    verdict->state = !same ? VERDICT_DIFFERENT : equal ? VERDICT_EQUAL : VERDICT_SAME;
    return STATUS_OK;
}

/* Of two that do not pass, the one of the same size, and then the nearer one. */
static bool nearer(const struct verdict *a, const struct verdict *b)
{
    if (!b->accepted || a->state != b->state)
        return a->state < b->state || !b->accepted;
    return a->excess < b->excess;
}

enum status verdict_make(struct verdict *verdict, const char *name, const struct limits *limits,
                         const struct image *frame, const struct image *const *accepted,
                         size_t count, struct error *e)
{
    struct verdict best = {.name = name, .state = VERDICT_EXTRA, .frame = frame};
    for (size_t i = 0; i < SCORES_MAX; i++)
        best.values[i] = NAN;
    const struct verdict blank = best;
    for (size_t b = 0; b < count && !(best.accepted && verdict_passes(best.state)); b++) {
        struct verdict next = blank;
        next.baseline = b;
        if (!accepted[b])
            continue;
        if (!frame) {
            next.state = VERDICT_MISSING;
            next.accepted = accepted[b];
        } else if (judge(&next, limits, frame, accepted[b], e)) {
            return e->status;
        }
        if (nearer(&next, &best))
            best = next;
    }
    *verdict = best;
    return STATUS_OK;
}

enum status verdict_map(const struct verdict *verdict, struct image *map, struct error *e)
{
    const struct image *a = verdict->frame, *b = verdict->accepted;
    if (image_create(map, a->width, a->height, e))
        return e->status;
    for (size_t i = 0; i < 4 * metric_pixels(a); i++) {
        int level = abs(a->rgba[i] - b->rgba[i]) * MAP_GAIN;
        map->rgba[i] = (uint8_t)(i % 4 == 3 ? 255 : level < 255 ? level : 255);
    }
    return STATUS_OK;
}
