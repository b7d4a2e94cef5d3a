/* Part of the summary of several studies: what ladders against a finer run say of their limits. */
#include "study/products/summary.h"
#include "study/products/text.h"
#include "study/richardson.h"

#include <math.h>

/* "isph order 2.1, limit -0.3 %, GCI 1.2 %" */
static void write_method(const struct study_results *results, const struct study_ladder *ladder,
                         const struct study_method *method, const struct study_asked *asked, FILE *out)
{
    struct richardson r = richardson_ladder(results->points, ladder, method, asked);
    char limit[64], gci[64];
    text_error(r.extrapolated, "%", limit, sizeof limit);
    text_error(r.gci, "%", gci, sizeof gci);
    if (r.kind == RICHARDSON_KNOWN)
        fprintf(out, "%s: order %.2f, limit %s, GCI %s", method->name, r.order, limit, gci);
    else
        fprintf(out, "%s: %s", method->name, richardson_words[r.kind]);
}

void summary_limits(const struct study_results *all, size_t count, FILE *out)
{
    bool any = false;
    for (size_t k = 0; k < count; k++)
        for (size_t i = 0; i < all[k].study->asked_count; i++) {
            const struct study *study = all[k].study;
            const struct study_asked *asked = &study->asked[i];
            if (!asked->norm->has_sign || !richardson_applies(all[k].points, study->ladders, asked))
                continue;
            fputs(any ? "- " : "Against a finer run, by the three finest rungs without it (Richardson; limits are against that run):\n\n- ",
                  out);
            any = true;
            text_markdown(study->title, out);
            fputs(", ", out);
            text_markdown(asked->name, out);
            for (size_t m = 0; m < study->method_count; m++) {
                fputs(m ? "; " : ". ", out);
                write_method(&all[k], study->ladders, &study->methods[m], asked, out);
            }
            fputs(".\n", out);
        }
    fputs(any ? "\n" : "", out);
}
