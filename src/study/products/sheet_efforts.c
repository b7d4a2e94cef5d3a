/* Part of the report: what each method needs for an error, and errs after a time. */
#include "study/crossing.h"
#include "study/products/sheet.h"
#include "study/products/text.h"

#include <math.h>
#include <string.h>

/* Of a part of the reference; and seconds of wall time. */
#define ERROR_SOUGHT 0.01
#define TIME_GIVEN   10.0

static void write_method(struct sheet *sheet, const struct curve *curve,
                         const struct study_error *of, const double *sought, size_t count)
{
    char text[128];
    sheet->format->row(sheet, true);
    sheet->format->cell(sheet, curve->method->name, CELL_PLAIN);
    for (size_t k = 0; k < count; k++) {
        struct crossing time = crossing_time(curve, sought[k]);
        crossing_time_text(&time, of->unit, text, sizeof text);
        sheet->format->cell(sheet, text, CELL_PLAIN);
    }
    struct crossing error = crossing_error(curve, TIME_GIVEN);
    crossing_error_text(&error, of->unit, text, sizeof text);
    sheet->format->cell(sheet, text, CELL_PLAIN);
    sheet->format->row(sheet, false);
}

static void write_error(struct sheet *sheet, const struct study_ladder *ladder,
                        const struct study_error *of)
{
    const struct study_results *results = sheet->results;
    double sought[2];
    size_t count = 0;
    char texts[4][128];
    const char *heads[4] = {"method"};
    if (strcmp(of->unit, "%") == 0)
        sought[count++] = ERROR_SOUGHT;
    if (of->asked > 0 && !(count && of->asked == ERROR_SOUGHT))
        sought[count++] = of->asked;
    for (size_t k = 0; k < count; k++) {
        char number[64];
        text_error(sought[k], of->unit, number, sizeof number);
        snprintf(texts[k], sizeof texts[k], "time to %s error%s", number,
                 sought[k] == of->asked ? ", as asked" : "");
        heads[k + 1] = texts[k];
    }
    snprintf(texts[count], sizeof texts[count], "error at %g s", TIME_GIVEN);
    heads[count + 1] = texts[count];
    sheet_paragraph(sheet, false, "%s, between rungs on straight lines of logarithms; < and > where it is "
                    "outside of what was measured:", of->name);
    sheet->format->table(sheet, true);
    sheet_heads(sheet, heads, count + 2);
    for (size_t m = 0; m < results->study->method_count; m++) {
        struct curve curve = {results->points, ladder, &results->study->methods[m], of->name};
        write_method(sheet, &curve, of, sought, count);
    }
    sheet->format->table(sheet, false);
}

void sheet_efforts(struct sheet *sheet, const struct study_ladder *ladder)
{
    const char *names[ERRORS_MAX];
    size_t count = study_plots(sheet->results, names, ERRORS_MAX);
    for (size_t k = 0; k < count; k++) {
        const struct study_error *of = figure_error(sheet->results->points, ladder, names[k]);
        if (of)
            write_error(sheet, ladder, of);
    }
}
