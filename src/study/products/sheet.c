/* The report: how it was measured, and the order of its parts. */
#include "study/products/sheet.h"

#include "run/report.h"
#include "study/products/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

/* Machine speeds before and after that differ by more make times doubtful. */
#define SPEED_DRIFT 0.05

void sheet_paragraph(struct sheet *sheet, bool warning, const char *format, ...)
{
    char text[4096];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    sheet->format->paragraph(sheet, text, warning);
}

void sheet_item(struct sheet *sheet, const char *format, ...)
{
    char text[4096];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    sheet->format->item(sheet, text);
}

void sheet_heads(struct sheet *sheet, const char *const *texts, size_t count)
{
    sheet->format->row(sheet, true);
    for (size_t k = 0; k < count; k++)
        sheet->format->head(sheet, texts[k]);
    sheet->format->row(sheet, false);
    sheet->format->head_end(sheet, count);
}

static void write_about(struct sheet *sheet)
{
    const struct study *study = sheet->results->study;
    const struct study_about *about = sheet->results->about;
    double before = about->speed[0], after = about->speed[1], drift = after / before - 1;
    sheet_paragraph(sheet, false, "Measured %s on %s by sph-render %s, scene %s%s%s. Each point ran up to "
                    "%d times%s, in turns with the others, once where a run takes more than %g s; times are of "
                    "solving, the least counts; errors are of the first run. A fixed loop "
                    "made %.3g multiply-adds a second before and %.3g after (%+.1f %%).",
                    about->date, report_processor(), SPH_VERSION, study->scene,
                    study->known ? ", case " : "", study->known ? study->known->variant.name : "",
                    study->repeats, study->seeds > 1 ? " from each of its seeds" : "", REPEAT_LONGEST, before, after, 100 * drift);
    if (fabs(drift) > SPEED_DRIFT)
        sheet_paragraph(sheet, true, "The machine's speed changed by %.0f %%: do not trust differences of "
                        "time that are smaller; run again on a quiet machine.", 100 * fabs(drift));
    sheet->format->list(sheet, true);
    sheet->format->command(sheet, "This study", about->command);
    sheet->format->list(sheet, false);
}

static void write_commands(struct sheet *sheet)
{
    const struct study_points *points = sheet->results->points;
    sheet->format->heading(sheet, 2, "Commands");
    sheet_paragraph(sheet, false, "Each makes one point's run again, from this directory:");
    sheet->format->list(sheet, true);
    for (size_t k = 0; k < points->count; k++) {
        char name[256], *command = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&command, &size);
        if (!out)
            continue;
        study_point_command(&points->items[k], out);
        study_point_name(&points->items[k], name, sizeof name);
        if (fclose(out) == 0)
            sheet->format->command(sheet, name, command);
        free(command);
    }
    sheet->format->list(sheet, false);
}

enum status sheet_write(struct sheet *sheet, struct error *e)
{
    sheet->format->heading(sheet, 1, sheet->results->study->title);
    write_about(sheet);
    sheet->format->heading(sheet, 2, "Verdicts");
    if (sheet_verdicts(sheet, e) || sheet_ladders(sheet, e))
        return e->status;
    write_commands(sheet);
    return STATUS_OK;
}
