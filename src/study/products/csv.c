/* Product "results.csv": a line for each point. */
#include "base/output.h"
#include "study/products/fields.h"
#include "study/products/products.h"

#include <math.h>
#include <string.h>

static void write_number(double number, FILE *out)
{
    fputc(',', out);
    csv_number(number, out);
}

static void write_names(const struct study_errors *errors, bool seeds, FILE *out)
{
    fputs("ladder,method,key,value,outcome,cause,particles,spacing (m),threads,isa,backend,repeats,"
          "wall (s),wall median (s),processor (s),ns a particle and step,pairs,steps,rejected,mean step (s),iterations a step,"
          "bytes,energy drift,momentum drift,leak (m),state,folder", out);
    for (size_t i = 0; errors && i < errors->count; i++) {
        fputc(',', out);
        csv_text(errors->items[i].name, out);
        if (seeds) { /* with the mean comes the spread */
            char name[sizeof errors->items[i].name + 32];
            snprintf(name, sizeof name, "%s: deviation", errors->items[i].name);
            fputc(',', out);
            csv_text(name, out);
        }
    }
    fputc('\n', out);
}

static void write_point(const struct study_point *p, const struct study_errors *errors, bool seeds, FILE *out)
{
    const char *const texts[] = {p->ladder ? p->ladder->name : "reference",
                                 p->method ? p->method->name : "reference",
                                 p->ladder ? p->ladder->key : "",
                                 p->ladder ? p->ladder->labels[p->rung] : "",
                                 outcome_names[p->outcome], p->cause};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        if (k)
            fputc(',', out);
        csv_text(texts[k], out);
    }
    bool ran = p->repeats > 0;
    write_number(ran ? p->particles : p->guess, out);
    write_number(p->scene->particles.spacing, out);
    fprintf(out, ",%d,%s,%s,%d", p->threads, p->isa, p->backend, p->repeats);
    const double numbers[] = {study_wall(p), study_wall_median(p), study_cpu(p),
                              study_wall(p) * 1e9 / p->steps / p->particles, p->pairs,
                              p->steps, p->rejected, p->dt, p->iterations, p->bytes,
                              p->energy_drift, p->momentum_drift, p->leak};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        write_number(ran ? numbers[k] : (double)NAN, out);
    fprintf(out, ",%s,%s", p->hash, p->folder);
    for (size_t i = 0; errors && i < errors->count; i++) {
        const struct study_error *error = study_error(p, errors->items[i].name);
        write_number(error ? error->value : (double)NAN, out);
        if (seeds)
            write_number(error ? error->deviation : (double)NAN, out);
    }
    fputc('\n', out);
}

static enum status write_csv(const struct study_results *results, struct error *e)
{
    char path[4096];
    struct output_file file;
    snprintf(path, sizeof path, "%s/results.csv", results->directory);
    if (output_open(&file, path, e))
        return e->status;
    const struct study_errors *errors = study_most_errors(results->points, NULL);
    bool seeds = results->study->seeds > 1;
    write_names(errors, seeds, file.stream);
    for (size_t k = 0; k < results->points->count; k++)
        write_point(&results->points->items[k], errors, seeds, file.stream);
    return output_close(&file, true, e);
}

const struct product_row product_csv = {
    {"results.csv", "a line for each point: settings, errors, times, counts", NULL, 0, NULL},
    write_csv};
