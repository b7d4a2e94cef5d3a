/* Product "results.json": all that the study knows, for programs. */
#include "base/output.h"
#include "base/quote.h"
#include "run/report.h"
#include "study/products/fields.h"
#include "study/products/products.h"

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
        if (isfinite(error->value))
            fprintf(out, "\"value\": %.9g}", error->value);
        else
            fputs("\"value\": null}", out);
    }
    fputs("]", out);
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
    fprintf(out, "\"threads\": %d, ", p->threads);
    json_number("spacing", p->scene->particles.spacing, out);
    if (p->repeats > 0) {
        json_number("particles", p->particles, out);
        write_times("wall", p->wall, p->repeats, out);
        write_times("processor", p->cpu, p->repeats, out);
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
    write_errors(&p->errors, out);
    fputs("}", out);
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
    fputs("]}\n", out);
    return output_close(&file, true, e);
}

const struct product_row product_json = {
    {"results.json", "the same and each repeat, for programs", NULL, 0, NULL}, write_json};
