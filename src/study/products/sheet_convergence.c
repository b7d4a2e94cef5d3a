/* Part of the report: what ladders against a finer run say of their limit. */
#include "study/products/sheet.h"
#include "study/products/text.h"
#include "study/richardson.h"

#include <math.h>

static void write_method(struct sheet *sheet, const struct study_ladder *ladder, const struct study_method *method,
                         const struct study_asked *asked)
{
    struct richardson r = richardson_ladder(sheet->results->points, ladder, method, asked);
    char text[160];
    bool known = r.kind == RICHARDSON_KNOWN;
    sheet->format->row(sheet, true);
    sheet->format->cell(sheet, method->name, CELL_PLAIN);
    snprintf(text, sizeof text, "%.2f", r.order);
    sheet->format->cell(sheet, known ? text : text_none, CELL_PLAIN);
    text_error(known ? r.extrapolated : (double)NAN, "%", text, sizeof text);
    sheet->format->cell(sheet, text, CELL_PLAIN);
    text_error(known ? r.gci : (double)NAN, "%", text, sizeof text);
    sheet->format->cell(sheet, text, CELL_PLAIN);
    snprintf(text, sizeof text, "factor %g", r.factor);
    if (!known)
        snprintf(text, sizeof text, "not meaningful: %s", richardson_words[r.kind]);
    sheet->format->cell(sheet, text, CELL_PLAIN);
    sheet->format->row(sheet, false);
}

void sheet_convergence(struct sheet *sheet, const struct study_ladder *ladder)
{
    static const char *const heads[] = {"method", "observed order", "limit, against the reference", "GCI of the finest", ""};
    const struct study *study = sheet->results->study;
    bool any = false;
    for (size_t k = 0; k < study->asked_count; k++) {
        const struct study_asked *asked = &study->asked[k];
        if (!richardson_applies(sheet->results->points, ladder, asked))
            continue;
        if (!any)
            sheet_paragraph(sheet, false, "The reference of the following is a finer run, of spacing %g m, which errs, "
                            "too: an error of a rung not four times as coarse counts for little. From the three finest rungs, "
                            "without the reference: the order observed, Richardson's limit, and the grid convergence index "
                            "(Roache 1994).", sheet->results->points->items[0].scene->particles.spacing);
        any = true;
        sheet_paragraph(sheet, false, "%s:", asked->name);
        sheet->format->table(sheet, true);
        sheet_heads(sheet, heads, sizeof heads / sizeof *heads);
        for (size_t m = 0; m < study->method_count; m++)
            write_method(sheet, ladder, &study->methods[m], asked);
        sheet->format->table(sheet, false);
    }
}
