/* Product "report.md": the report as Markdown. */
#include "base/output.h"
#include "study/products/plot_script.h"
#include "study/products/sheet.h"
#include "study/products/text.h"

#include <unistd.h>

static void heading(struct sheet *sheet, int level, const char *text)
{
    fprintf(sheet->out, "%s%.*s ", level > 1 ? "\n" : "", level, "####");
    text_markdown(text, sheet->out);
    fputs("\n\n", sheet->out);
}

static void paragraph(struct sheet *sheet, const char *text, bool warning)
{
    fputs(warning ? "**Warning:** " : "", sheet->out);
    text_markdown(text, sheet->out);
    fputs("\n\n", sheet->out);
}

static void item(struct sheet *sheet, const char *text)
{
    fputs("- ", sheet->out);
    text_markdown(text, sheet->out);
    fputs("\n", sheet->out);
}

static void list(struct sheet *sheet, bool open)
{
    fputs(open ? "" : "\n", sheet->out);
}

static void head(struct sheet *sheet, const char *text)
{
    fputs(" ", sheet->out);
    text_markdown(text, sheet->out);
    fputs(" |", sheet->out);
}

static void cell(struct sheet *sheet, const char *text, enum cell_style style)
{
    const char *mark = style == CELL_BOLD ? "**" : "";
    fprintf(sheet->out, " %s", mark);
    text_markdown(text, sheet->out);
    fprintf(sheet->out, "%s |", mark);
}

static void table(struct sheet *sheet, bool open)
{
    fputs(open ? "" : "\n", sheet->out);
}

static void row(struct sheet *sheet, bool open)
{
    fputs(open ? "|" : "\n", sheet->out);
}

static void head_end(struct sheet *sheet, size_t columns)
{
    fputs("|", sheet->out);
    for (size_t k = 0; k < columns; k++)
        fputs(k ? "---:|" : "---|", sheet->out);
    fputs("\n", sheet->out);
}

static void command(struct sheet *sheet, const char *name, const char *text)
{
    fputs("- ", sheet->out);
    text_markdown(name, sheet->out);
    fprintf(sheet->out, ": `%s`\n", text);
}

static enum status figure(struct sheet *sheet, const struct figure *figure, struct error *e)
{
    char path[4096], caption[512];
    (void)e;
    plot_path(sheet->results, figure, "png", path, sizeof path);
    if (access(path, R_OK) != 0)
        return STATUS_OK;
    figure_caption(figure, caption, sizeof caption);
    fputs("![", sheet->out);
    text_markdown(caption, sheet->out);
    fprintf(sheet->out, "](plots/%s.png)\n\n", figure->stem);
    return STATUS_OK;
}

/* Pictures are the page's. */
static enum status frames(struct sheet *sheet, const struct study_ladder *ladder, struct error *e)
{
    (void)sheet;
    (void)ladder;
    (void)e;
    return STATUS_OK;
}

static const struct sheet_format markdown = {
    .heading = heading, .paragraph = paragraph, .item = item, .list = list, .head = head,
    .cell = cell, .table = table, .row = row, .head_end = head_end, .command = command,
    .figure = figure, .frames = frames};

static enum status write_report(const struct study_results *results, struct error *e)
{
    char path[4096];
    struct output_file file;
    snprintf(path, sizeof path, "%s/report.md", results->directory);
    if (output_open(&file, path, e))
        return e->status;
    struct sheet sheet = {&markdown, file.stream, results};
    enum status status = sheet_write(&sheet, e);
    enum status closed = output_close(&file, !status, e);
    return status ? status : closed;
}

const struct product_row product_report = {
    {"report.md", "tables, verdicts and commands for readers", NULL, 0, NULL}, write_report};
