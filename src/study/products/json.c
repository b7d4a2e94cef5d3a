/* Product "results.json": all that the study knows, for programs. */
#include "base/output.h"
#include "base/quote.h"
#include "run/report.h"
#include "study/products/fields.h"
#include "study/products/products.h"
#include "study/richardson.h"

#include <math.h>

static void write_times(const char *key, const double *values, int count, FILE *out)
{
    fprintf(out, "\"%s\": [", key);
    for (int k = 0; k < count; k++)
        fprintf(out, "%s%.6f", k ? ", " : "", values[k]);
    fputs("], ", out);
}

static void write_errors(const struct study_errors *errors, FILE *out)
{
    fputs("\"errors\": [", out);
    for (size_t k = 0; k < errors->count; k++) {
        const struct study_error *error = &errors->items[k];
        fputs(k ? ", {" : "{", out);
        json_text("name", error->name, out);
        json_text("unit", error->unit, out);
        json_number("asked", error->asked, out);
        json_number("spread", error->spread, out);
        if (error->runs > 0) {
            json_number("runs", error->runs, out);
            json_number("deviation", error->deviation, out);
            json_number("mean_size", error->size, out);
            json_number("least_size", error->least, out);
            json_number("most_size", error->most, out);
        }
        if (isfinite(error->value))
            fprintf(out, "\"value\": %.9g}", error->value);
        else
            fputs("\"value\": null}", out);
    }
    fputs("]", out);
}

/* An ensemble's runs, each by its seed. */
static void write_members(const struct study_point *p, FILE *out)
{
    fputs("\"seeds\": [", out);
    for (size_t k = 0; k < p->member_count; k++) {
        const struct study_point *member = &p->members[k];
        fputs(k ? ", {" : "{", out);
        json_text("outcome", outcome_names[member->outcome], out);
        json_text("cause", member->cause, out);
        json_text("folder", member->folder, out);
        json_text("state", member->hash, out);
        write_times("wall", member->wall, member->repeats, out);
        write_errors(&member->errors, out);
        fputs("}", out);
    }
    fputs("], ", out);
}

/* `plot` is the error of the first figure: order and front are of it. */
static void write_point(const struct study_points *points, const struct study_point *p, const char *plot,
                        FILE *out)
{
    fputs("{", out);
    json_text("ladder", p->ladder ? p->ladder->name : "reference", out);
    json_text("method", p->method ? p->method->name : "reference", out);
    json_text("key", p->ladder ? p->ladder->key : "", out);
    json_text("value", p->ladder ? p->ladder->labels[p->rung] : "", out);
    json_text("outcome", outcome_names[p->outcome], out);
    json_text("cause", p->cause, out);
    json_text("folder", p->folder, out);
    json_text("state", p->hash, out);
    json_text("isa", p->isa, out);
    fprintf(out, "\"threads\": %d, \"backend\": \"%s\", ", p->threads, p->backend);
    json_number("spacing", p->scene->particles.spacing, out);
    if (p->repeats > 0) {
        json_number("particles", p->particles, out);
        write_times("wall", p->wall, p->repeats, out);
        write_times("processor", p->cpu, p->repeats, out);
        fprintf(out, "\"disturbed\": %d, ", p->repeats - study_calm(p));
        json_number("pairs", p->pairs, out);
        json_number("steps", p->steps, out);
        json_number("rejected", p->rejected, out);
        json_number("mean_step", p->dt, out);
        json_number("iterations_a_step", p->iterations, out);
        json_number("bytes", p->bytes, out);
        json_number("energy_drift", p->energy_drift, out);
        json_number("momentum_drift", p->momentum_drift, out);
        json_number("leak", p->leak, out);
    }
    json_number("order", study_order(points, p, plot), out);
    fprintf(out, "\"front\": %s, ", study_is_front(points, p, plot, study_wall) ? "true" : "false");
    if (p->member_count)
        write_members(p, out);
    write_errors(&p->errors, out);
    fputs("}", out);
}

/* What ladders against a finer run say of their limit. */
static void write_convergence(const struct study_results *results, FILE *out)
{
    const struct study *study = results->study;
    char name[2 * STUDY_NAME_SIZE + 3];
    bool any = false;
    fputs("\"convergence\": [", out);
    for (size_t l = 0; l < study->ladder_count; l++)
        for (size_t k = 0; k < study->asked_count; k++)
            for (size_t m = 0; m < study->method_count; m++) {
                const struct study_asked *asked = &study->asked[k];
                if (!richardson_applies(results->points, &study->ladders[l], asked))
                    continue;
                struct richardson r = richardson_ladder(results->points, &study->ladders[l], &study->methods[m], asked);
                fputs(any ? ",\n  {" : "\n  {", out);
                any = true;
                json_text("ladder", study->ladders[l].name, out);
                json_text("error", asked->name, out);
                json_text("not_meaningful", richardson_words[r.kind], out);
                json_number("order", r.order, out);
                json_number("extrapolated", r.extrapolated, out);
                json_number("gci", r.gci, out);
                json_number("safety_factor", r.factor, out);
                json_quote(study->methods[m].name, name, sizeof name);
                fprintf(out, "\"method\": %s}", name);
            }
    fputs("]", out);
}

static enum status write_json(const struct study_results *results, struct error *e)
{
    char path[4096];
    const char *plot = NULL;
    struct output_file file;
    snprintf(path, sizeof path, "%s/results.json", results->directory);
    if (output_open(&file, path, e))
        return e->status;
    FILE *out = file.stream;
    study_plots(results, &plot, 1);
    fputs("{", out);
    json_text("title", results->study->title, out);
    json_text("study", results->study->path, out);
    json_text("program", "sph-render " SPH_VERSION, out);
    json_text("processor", report_processor(), out);
    json_text("command", results->about->command, out);
    json_text("date", results->about->date, out);
    json_number("speed_before", results->about->speed[0], out);
    json_number("speed_after", results->about->speed[1], out);
    fputs("\"points\": [", out);
    for (size_t k = 0; k < results->points->count; k++) {
        fputs(k ? ",\n  " : "\n  ", out);
        write_point(results->points, &results->points->items[k], plot, out);
    }
    fputs("],\n", out);
    write_convergence(results, out);
    fputs("}\n", out);
    return output_close(&file, true, e);
}

const struct product_row product_json = {
    {"results.json", "the same and each repeat, for programs", NULL, 0, NULL}, write_json};
