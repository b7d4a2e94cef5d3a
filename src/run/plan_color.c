/* Plans what frames show: colour, its scale and map, and the pass that computes it. */
#include "run/plan_color.h"

#include "base/memory.h"
#include "render/palette.h"
#include "run/film.h"

#include <math.h>
#include <string.h>

enum { STEPS_MAX = 256 };

static struct color_expectation expect(const struct plan *plan)
{
    const struct scene *scene = plan->scene;
    const double *g = scene->gravity;
    struct color_expectation x = {.fastest = plan->choice.fastest, .depth = plan->choice.depth,
                                  .gravity = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]),
                                  .scene = scene, .start = &plan->bodies};
    for (size_t f = 0; f < scene->fluid_count; f++)
        x.density = fmax(x.density, scene->fluids[f].density);
    return x;
}

/* A colour for each count, unless the scene says otherwise. */
static void count_steps(struct plan *plan)
{
    struct color_scale *scale = &plan->scale;
    double count = scale->range[1] - scale->range[0];
    bool plain = isnan(plan->scene->color.range[0]) && plan->scene->color.steps == 0 &&
                 isnan(plan->scene->color.percentiles[0]) && !scale->log && !plan->symmetric;
    scale->counts = plan->color->counts && plain && count <= STEPS_MAX;
    if (scale->counts)
        scale->steps = (int)lround(count);
}

/* Makes each step of an estimated range a round number, outwards, so that its ticks are. */
static void round_steps(struct color_scale *scale)
{
    static const double factors[] = {1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
    double low = scale->range[0], step = (scale->range[1] - low) / scale->steps;
    double power = pow(10, floor(log10(step)));
    size_t k = 0;
    while (power * factors[k] < step * (1 - 1e-9))
        k++;
    step = power * factors[k];
    if (low < 0) /* about zero */
        scale->range[0] = -step * scale->steps / 2;
    scale->range[1] = scale->range[0] + step * scale->steps;
}

static void make_scale(struct plan *plan)
{
    const struct scene *scene = plan->scene;
    struct color_scale *scale = &plan->scale;
    struct color_expectation expected = expect(plan);
    enum color_spread spread = scene->color.scale;
    double *range = scale->range;
    memcpy(range, scene->color.range, sizeof scale->range);
    if (isnan(range[0]))
        plan->color->range(&expected, range);
    plan->symmetric = spread == SPREAD_SYMMETRIC || (spread == SPREAD_AUTO && plan->color->has_sign);
    scale->log = spread == SPREAD_LOG;
    scale->steps = (int)scene->color.steps;
    if (scale->log && range[0] <= 0)
        range[0] = DECADES_MIN * range[1];
    if (plan->symmetric) {
        range[1] = fmax(fabs(range[0]), fabs(range[1]));
        range[0] = -range[1];
    }
    count_steps(plan);
    bool about_zero = range[0] == 0 || range[0] == -range[1];
    if (scale->steps > 1 && !scale->counts && !scale->log && about_zero &&
        isnan(scene->color.range[0]))
        round_steps(scale);
}

static const struct pass_row *frame_pass(const struct color_row *color)
{
    const struct pass_row *row = &pass_table[PASS_CURL];
    return color->reads & row->writes ? row : NULL;
}

enum status plan_color_values(struct plan *plan, struct error *e)
{
    const struct fill *start = &plan->bodies;
    if (!plan->draws || !plan->color->fixed)
        return STATUS_OK;
    plan->fixed = memory_create("colours", start->count, sizeof *plan->fixed, e);
    for (size_t id = 0; plan->fixed && id < start->count; id++)
        plan->fixed[id] = plan->color->fixed(start, id);
    return plan->fixed ? STATUS_OK : e->status;
}

enum status plan_color(struct plan *plan, const struct run_options *options, struct error *e)
{
    plan->draws = film_wants_pixels(options->outputs, options->output_count);
    if (!plan->draws) {
        plan_omit(plan, "drawing: no output wants pixels; no GL context is opened");
        return STATUS_OK;
    }
    plan->color = (const struct color_row *)variant_find(&color_table, plan->scene->color.by);
    if (plan->color->solid)
        return STATUS_OK;
    make_scale(plan);
    plan->frame_pass = frame_pass(plan->color);
    return palette_make(plan->scene, plan->symmetric, plan->palette, e);
}

/* Says only what is not usual. */
static void scale_write(const struct plan *plan, FILE *out)
{
    const struct scene *scene = plan->scene;
    if (plan->scale.log)
        fputs(", logarithmic", out);
    if (plan->scale.steps)
        fprintf(out, ", %d colours", plan->scale.steps);
    if (!isnan(scene->color.percentiles[0]))
        fprintf(out, "; in each frame from its percentile %g to %g", scene->color.percentiles[0],
                scene->color.percentiles[1]);
}

void plan_color_write(const struct plan *plan, FILE *out)
{
    const double *range = plan->scale.range;
    if (plan->color->solid) {
        fprintf(out, "colour         the fluids' own\n");
        return;
    }
    fprintf(out, "colour         %s, %.4g to %.4g %s%s(%s", plan->color->label, range[0], range[1],
            plan->color->unit, plan->color->unit[0] ? " " : "",
            isnan(plan->scene->color.range[0]) ? plan->color->estimate : "as the scene says");
    fputs(")", out);
    scale_write(plan, out);
    fputs("\n", out);
}
