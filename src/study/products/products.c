/* The table of what a study leaves, and what its files share. */
#include "study/products/products.h"

#include <string.h>

extern const struct product_row product_csv, product_json, product_plots, product_report, product_page;

static const struct variant *const rows[] = {
    &product_csv.variant,
    &product_json.variant,
    &product_plots.variant,
    &product_report.variant, /* after the figures that they show */
    &product_page.variant,
};

const struct variant_table product_table = {"products", "what a study leaves in its directory", rows,
                                            sizeof rows / sizeof *rows};

const char *const outcome_names[] = {
    [OUTCOME_LEFT_OUT] = "left out", [OUTCOME_DONE] = "done", [OUTCOME_STOPPED] = "stopped",
    [OUTCOME_LATE] = "late", [OUTCOME_CRASHED] = "crashed"};

enum status study_write(const struct study_results *results, struct error *e)
{
    for (size_t k = 0; k < product_table.count; k++)
        if (((const struct product_row *)rows[k])->write(results, e))
            return e->status;
    return STATUS_OK;
}

size_t study_plots(const struct study_results *results, const char **names, size_t most)
{
    const struct study *study = results->study;
    const struct study_errors *errors = study_most_errors(results->points, NULL);
    size_t count = 0;
    for (size_t k = 0; k < study->plot_count && count < most; k++)
        if (study_error_known(results->points, study->plots[k]))
            names[count++] = study->plots[k];
    if (!study->plot_count && errors && most > 0)
        names[count++] = errors->items[0].name;
    return count;
}

void study_point_name(const struct study_point *point, char *out, size_t size)
{
    if (!point->ladder)
        snprintf(out, size, "reference");
    else
        snprintf(out, size, "%s%s%s%s%s", point->method->name, point->ladder->key[0] ? ", " : "",
                 point->ladder->key, point->ladder->key[0] ? " " : "",
                 point->ladder->labels[point->rung]);
}

void study_point_command(const struct study_point *point, FILE *out)
{
    fprintf(out, "sph-render %s/scene.json -o rows.csv --report report.json --threads %d --isa %s --backend %s",
            point->folder, point->threads, point->isa, point->backend);
}
