/* Part of the report: bounds met or not, whether the default is on the front, what failed. */
#include "study/products/sheet.h"
#include "study/products/text.h"

#include <math.h>
#include <string.h>

/* The method's finest point of the ladder that is done, or NULL. */
static const struct study_point *finest(const struct study_points *points,
                                        const struct study_ladder *ladder,
                                        const struct study_method *method)
{
    const struct study_point *best = NULL;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        if (p->ladder == ladder && p->method == method && p->outcome == OUTCOME_DONE &&
            (!best || p->rung > best->rung))
            best = p;
    }
    return best;
}

static void write_bound(struct sheet *sheet, const struct study_ladder *ladder,
                        const struct study_error *of)
{
    const struct study_results *results = sheet->results;
    char met[1500] = "", missed[1500] = "", unknown[600] = "", asked[64];
    for (size_t m = 0; m < results->study->method_count; m++) {
        const struct study_method *method = &results->study->methods[m];
        const struct study_point *p = finest(results->points, ladder, method);
        double size = p ? study_error_size(p, of->name) : (double)NAN;
        char text[300], number[64], rung[80] = "";
        text_error(size, of->unit, number, sizeof number);
        if (p && p->rung + 1 < ladder->count)
            snprintf(rung, sizeof rung, " at %s, the finest that is done", ladder->labels[p->rung]);
        char *list = isnan(size) ? unknown : size <= of->asked ? met : missed;
        size_t room = list == unknown ? sizeof unknown : sizeof met;
        snprintf(text, sizeof text, "%s%s%s%s%s%s", *list ? "; " : "", method->name,
                 isnan(size) ? "" : " (", isnan(size) ? "" : number, isnan(size) ? "" : rung,
                 isnan(size) ? "" : ")");
        strncat(list, text, room - strlen(list) - 1);
    }
    text_error(of->asked, of->unit, asked, sizeof asked);
    sheet_item(sheet, "%s, asked at most %s, ladder %s, finest rung: %s%s%s%s%s%s%s", of->name, asked,
               ladder->name, *met ? "met by " : "met by none", met, *missed ? ". Not met by " : "",
               missed, *unknown ? ". Not known of " : "", unknown, ".");
}

static void write_bounds(struct sheet *sheet)
{
    const struct study_results *results = sheet->results;
    for (size_t l = 0; l < results->study->ladder_count; l++) {
        const struct study_ladder *ladder = &results->study->ladders[l];
        bool skip = results->study->ladder_count > 1 && figure_is_time(results, ladder);
        const struct study_errors *errors = study_most_errors(results->points, ladder);
        for (size_t k = 0; errors && k < errors->count && !skip; k++)
            if (!isnan(errors->items[k].asked))
                write_bound(sheet, ladder, &errors->items[k]);
    }
}

static void write_default(struct sheet *sheet, const struct study_ladder *ladder,
                          const char *error, const struct study_method *method, bool own)
{
    const struct study_points *points = sheet->results->points;
    const struct study_error *of = figure_error(points, ladder, error);
    size_t front = 0, done = 0;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        if (p->ladder != ladder || p->method != method || isnan(study_error_size(p, error)))
            continue;
        done++;
        front += study_is_front(points, p, error, study_wall);
    }
    if (of)
        sheet_item(sheet, "Default on the front? %s (%s): %s, %zu of its %zu points are (ladder %s, %s).",
                   method->name, own ? "the scene's own settings" : "named first", front ? "yes" : "no",
                   front, done, ladder->name, of->name);
}

static enum status write_defaults(struct sheet *sheet, struct error *e)
{
    const struct study_results *results = sheet->results;
    const char *plots[ERRORS_MAX];
    size_t count = study_plots(results, plots, ERRORS_MAX);
    const struct study_method *method;
    bool own;
    if (study_default(results->study, &method, &own, e))
        return e->status;
    for (size_t l = 0; l < results->study->ladder_count; l++)
        for (size_t k = 0; k < count; k++)
            if (!figure_is_time(results, &results->study->ladders[l]))
                write_default(sheet, &results->study->ladders[l], plots[k], method, own);
    return STATUS_OK;
}

/* Points of those outcomes, with causes. */
static void write_list(struct sheet *sheet, const char *title, bool left_out)
{
    const struct study_points *points = sheet->results->points;
    bool any = false;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        char name[256];
        if (p->outcome == OUTCOME_DONE || (p->outcome == OUTCOME_LEFT_OUT) != left_out)
            continue;
        if (!any) {
            sheet->format->heading(sheet, 3, title);
            sheet->format->list(sheet, true);
        }
        any = true;
        study_point_name(p, name, sizeof name);
        sheet_item(sheet, "%s (ladder %s): %s%s%s", name, p->ladder ? p->ladder->name : "none",
                   left_out ? "" : outcome_names[p->outcome], left_out ? "" : ", ", p->cause);
    }
    if (any)
        sheet->format->list(sheet, false);
}

enum status sheet_verdicts(struct sheet *sheet, struct error *e)
{
    sheet->format->list(sheet, true);
    write_bounds(sheet);
    enum status status = write_defaults(sheet, e);
    sheet->format->list(sheet, false);
    write_list(sheet, "Failed", false);
    write_list(sheet, "Left out", true);
    return status;
}
