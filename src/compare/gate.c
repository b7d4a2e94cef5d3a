/* The table of gates. */
#include "compare/gate.h"

#include "base/suggest.h"

#include <math.h>
#include <string.h>

struct gate {
    struct variant variant;
    struct {
        const char *score;
        double value;
    } limits[4]; /* ended by a NULL score or the end of the array */
};

static const struct gate same_stack = {
    .variant = {.name = "same-stack", .doc = "at most 0.1 % of the pixels differ by more than 2 levels "
                                             "(--max-channel): the same renderer and driver"},
    .limits = {{"over", 0.001}},
};

static const struct gate exact = {
    .variant = {.name = "exact", .doc = "every bit is equal: the same program and renderer"},
    .limits = {{"changed", 0}},
};

static const struct gate cross_driver = {
    .variant = {.name = "cross-driver", .doc = "FLIP at most 0.005 on average, 0.05 on 99 and 0.15 "
                                               "on 99.9 % of the pixels, SSIM of the worst tile at "
                                               "least 0.98: another driver"},
    /* The last of FLIP is for single particles that are missing in a dense fluid. */
    .limits = {{"flip", 0.005}, {"flip-p99", 0.05}, {"flip-p999", 0.15}, {"ssim-tile", 0.98}},
};

static const struct variant *const variants[] = {
    &same_stack.variant, &exact.variant, &cross_driver.variant};

const struct variant_table gate_table = {
    "gates", "limits for pictures that count as the same, for `compare' and --reference; the first "
             "is the default", variants, sizeof variants / sizeof *variants};

static size_t score_index(const char *name)
{
    size_t i = 0;
    while (strcmp(metric_score(i)->name, name) != 0)
        i++;
    return i;
}

enum status gate_limits(struct limits *limits, const char *name, struct error *e)
{
    const struct gate *gate = (const struct gate *)variant_find(&gate_table, name);
    struct suggest near;
    if (!gate) {
        suggest_start(&near, name);
        for (size_t i = 0; i < gate_table.count; i++)
            suggest_offer(&near, gate_table.rows[i]->name);
        const char *best = suggest_best(&near);
        return error_set(e, STATUS_USAGE, "--gate %s: there is no such gate%s%s%s; `sph-render list "
                         "gates' shows all", name, best ? "; did you mean " : "", best ? best : "",
                         best ? "?" : "");
    }
    limits->settings.levels = 2;
    for (size_t i = 0; i < SCORES_MAX; i++)
        limits->value[i] = NAN;
    for (size_t i = 0; i < sizeof gate->limits / sizeof *gate->limits && gate->limits[i].score; i++)
        limits->value[score_index(gate->limits[i].score)] = gate->limits[i].value;
    return STATUS_OK;
}
