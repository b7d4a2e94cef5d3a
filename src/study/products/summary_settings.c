/* Part of the summary of several studies: what each setting changes of time and error. */
#include "study/products/summary.h"

#include "study/products/text.h"

#include <math.h>
#include <string.h>

enum { SETTINGS_MAX = 64 };

/* A method on the first ladder, or a rung of another ladder of the first method. */
struct setting {
    char name[2 * STUDY_NAME_SIZE];
};

static const struct study_method *default_of(const struct study_results *results)
{
    return &results->study->methods[0];
}

/* "support 2" or "time.cfl 0.3"; "" for a point that is no setting. */
static void name_setting(const struct study_results *results, const struct study_point *p, char *out,
                         size_t size)
{
    bool first = p->ladder == results->study->ladders, own = p->method == default_of(results);
    out[0] = 0;
    if (p->ladder && first && !own)
        snprintf(out, size, "%s", p->method->name);
    else if (p->ladder && !first && own)
        snprintf(out, size, "`%s` %s", p->ladder->key, p->ladder->labels[p->rung]);
}

/* The first method's point of the first ladder with as many particles, or NULL. */
static const struct study_point *base_of(const struct study_results *results,
                                         const struct study_point *point)
{
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *p = &results->points->items[k];
        if (p->ladder == results->study->ladders && p->method == default_of(results) &&
            p->guess == point->guess)
            return p;
    }
    return NULL;
}

/* The finest point of that name; NULL: the study has none. */
static const struct study_point *find_setting(const struct study_results *results, const char *name)
{
    const struct study_point *found = NULL;
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *p = &results->points->items[k];
        char text[2 * STUDY_NAME_SIZE];
        name_setting(results, p, text, sizeof text);
        if (strcmp(text, name) == 0 && (!found || p->guess > found->guess))
            found = p;
    }
    return found;
}

/* "0.75, 1.2": time and error over those of the default at the same resolution. */
static void write_cell(const struct study_results *results, const char *name, FILE *out)
{
    const char *error;
    const struct study_point *p = find_setting(results, name), *base = p ? base_of(results, p) : NULL;
    size_t plots = study_plots(results, &error, 1);
    double time = base ? study_cpu(p) / study_cpu(base) : (double)NAN;
    double part = base && plots ? study_error_size(p, error) / study_error_size(base, error) : (double)NAN;
    if (p && p->outcome != OUTCOME_DONE && p->outcome != OUTCOME_LEFT_OUT)
        fprintf(out, " %s |", outcome_names[p->outcome]);
    else if (isnan(time) || isnan(part))
        fprintf(out, " %s |", text_none);
    else
        fprintf(out, " %.2f, %.3g |", time, part);
}

static size_t add_settings(const struct study_results *results, struct setting *settings, size_t count)
{
    for (size_t k = 0; k < results->points->count; k++) {
        struct setting one;
        size_t i = 0;
        name_setting(results, &results->points->items[k], one.name, sizeof one.name);
        while (i < count && strcmp(settings[i].name, one.name) != 0)
            i++;
        if (one.name[0] && i == count && count < SETTINGS_MAX)
            settings[count++] = one;
    }
    return count;
}

bool summary_has_settings(const struct study_results *results)
{
    const struct study *study = results->study;
    bool settings = study->ladder_count > 1 && summary_has_errors(results);
    for (size_t k = 0; k < study->ladder_count; k++)
        settings = settings && strcmp(study->ladders[k].key, "threads") != 0 &&
                   strcmp(study->ladders[k].key, "isa") != 0;
    return settings;
}

static void write_heads(const struct study_results *all, size_t count, FILE *out)
{
    size_t columns = 0;
    fputs("Processor time, and the first error of each case, as parts of the default's at the same resolution:\n\n"
          "| setting |", out);
    for (size_t k = 0; k < count; k++)
        if (summary_has_settings(&all[k])) {
            const char *title = all[k].study->title;
            fprintf(out, " %.*s |", (int)strcspn(title, ":"), title);
            columns++;
        }
    fputs("\n|---|", out);
    while (columns-- > 0)
        fputs("---|", out);
    fputc('\n', out);
}

void summary_settings(const struct study_results *all, size_t count, FILE *out)
{
    static struct setting settings[SETTINGS_MAX];
    size_t found = 0;
    for (size_t k = 0; k < count; k++)
        if (summary_has_settings(&all[k]))
            found = add_settings(&all[k], settings, found);
    if (!found)
        return;
    write_heads(all, count, out);
    for (size_t s = 0; s < found; s++) {
        fprintf(out, "| %s |", settings[s].name);
        for (size_t k = 0; k < count; k++)
            if (summary_has_settings(&all[k]))
                write_cell(&all[k], settings[s].name, out);
        fputc('\n', out);
    }
    fputc('\n', out);
}
