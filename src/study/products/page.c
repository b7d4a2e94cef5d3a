/* Product "index.html": the report as one page that holds its figures and pictures. */
#include "base/html.h"
#include "base/output.h"
#include "study/products/plot_script.h"
#include "study/products/sheet.h"

#include <unistd.h>

/* Pictures: about how wide, pixels; and with more points only each method's last. */
enum { FRAME_WIDTH = 240, FRAMES_MOST = 36 };

static const char opening[] =
    "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n<style>"
    "body{font:15px/1.45 sans-serif;color:#222;margin:2em auto;max-width:1180px;padding:0 1em}"
    "h1{font-size:1.6em}h2{font-size:1.25em;margin-top:2em;border-bottom:1px solid #ccc}"
    "figure{display:inline-block;margin:.4em 1em .8em 0;vertical-align:top}"
    "figcaption{font-size:.85em;color:#555;max-width:30em}"
    ".plot img{width:480px;max-width:100%}.frame img{width:240px;border:1px solid #ddd}"
    ".frame figcaption{max-width:240px}"
    ".wide{overflow-x:auto;margin:.6em 0}"
    "table{border-collapse:collapse;font-size:.82em}"
    "th{vertical-align:bottom;border-bottom:2px solid #888;font-weight:600;max-width:8em}"
    "td,th{padding:.2em .6em;text-align:right;font-variant-numeric:tabular-nums}"
    "td:first-child,th:first-child{text-align:left;min-width:11em}"
    "td{border-bottom:1px solid #e4e4e4}td b{color:#b00020}"
    ".warning{background:#fff3cd;border-left:4px solid #e0a800;padding:.5em .8em}"
    "code{font-size:.9em;background:#f4f4f4;padding:0 .2em;overflow-wrap:anywhere}"
    "@media print{body{max-width:none;margin:0}.wide{overflow:visible}table{font-size:.55em}"
    "td,th{padding:.1em .25em}tr,figure{break-inside:avoid}h2,h3{break-after:avoid}}"
    "</style>\n";

static void heading(struct sheet *sheet, int level, const char *text)
{
    fprintf(sheet->out, "<h%d>", level);
    html_text(sheet->out, text);
    fprintf(sheet->out, "</h%d>\n", level);
}

static void paragraph(struct sheet *sheet, const char *text, bool warning)
{
    fputs(warning ? "<p class=\"warning\">" : "<p>", sheet->out);
    html_text(sheet->out, text);
    fputs("</p>\n", sheet->out);
}

static void item(struct sheet *sheet, const char *text)
{
    fputs("<li>", sheet->out);
    html_text(sheet->out, text);
    fputs("</li>\n", sheet->out);
}

static void list(struct sheet *sheet, bool open)
{
    fputs(open ? "<ul>\n" : "</ul>\n", sheet->out);
}

static void head(struct sheet *sheet, const char *text)
{
    fputs("<th>", sheet->out);
    html_text(sheet->out, text);
    fputs("</th>", sheet->out);
}

static void cell(struct sheet *sheet, const char *text, enum cell_style style)
{
    fputs(style == CELL_BOLD ? "<td><b>" : "<td>", sheet->out);
    html_text(sheet->out, text);
    fputs(style == CELL_BOLD ? "</b></td>" : "</td>", sheet->out);
}

static void table(struct sheet *sheet, bool open)
{
    fputs(open ? "<div class=\"wide\"><table>\n" : "</table></div>\n", sheet->out);
}

static void row(struct sheet *sheet, bool open)
{
    fputs(open ? "<tr>" : "</tr>\n", sheet->out);
}

static void head_end(struct sheet *sheet, size_t columns)
{
    (void)sheet;
    (void)columns;
}

static void command(struct sheet *sheet, const char *name, const char *text)
{
    fputs("<li>", sheet->out);
    html_text(sheet->out, name);
    fputs(": <code>", sheet->out);
    html_text(sheet->out, text);
    fputs("</code></li>\n", sheet->out);
}

static enum status figure(struct sheet *sheet, const struct figure *figure, struct error *e)
{
    char path[4096], caption[512];
    plot_path(sheet->results, figure, "svg", path, sizeof path);
    if (access(path, R_OK) != 0)
        return STATUS_OK;
    figure_caption(figure, caption, sizeof caption);
    fputs("<figure class=\"plot\">", sheet->out);
    enum status status = html_svg(sheet->out, path, e);
    fputs("<figcaption>", sheet->out);
    html_text(sheet->out, caption);
    fputs("</figcaption></figure>\n", sheet->out);
    return status;
}

static enum status frame(struct sheet *sheet, const struct study_point *point, struct error *e)
{
    char path[4096], name[256];
    struct image image = {0};
    snprintf(path, sizeof path, "%s/%s/frame-0000.png", sheet->results->directory, point->folder);
    if (access(path, R_OK) != 0)
        return STATUS_OK;
    enum status status = image_read_png(&image, path, e);
    fputs("<figure class=\"frame\">", sheet->out);
    if (!status)
        status = html_image(sheet->out, &image, FRAME_WIDTH, path, e);
    study_point_name(point, name, sizeof name);
    fputs("<figcaption>", sheet->out);
    html_text(sheet->out, name);
    fputs("</figcaption></figure>\n", sheet->out);
    image_free(&image);
    return status;
}

static enum status frames(struct sheet *sheet, const struct study_ladder *ladder, struct error *e)
{
    const struct study *study = sheet->results->study;
    const struct study_points *points = sheet->results->points;
    bool all = ladder->count * study->method_count <= FRAMES_MOST;
    fprintf(sheet->out, "<details open><summary>Last states%s</summary>\n",
            all ? "" : ", of the finest rungs");
    for (size_t m = 0; m < study->method_count; m++)
        for (size_t k = 0; k < points->count; k++) {
            const struct study_point *p = &points->items[k];
            if (p->ladder == ladder && p->method == &study->methods[m] &&
                (all || p->rung + 1 == ladder->count) && frame(sheet, p, e))
                return e->status;
        }
    fputs("</details>\n", sheet->out);
    return STATUS_OK;
}

static const struct sheet_format html = {
    .heading = heading, .paragraph = paragraph, .item = item, .list = list, .head = head,
    .cell = cell, .table = table, .row = row, .head_end = head_end, .command = command,
    .figure = figure, .frames = frames};

static enum status write_page(const struct study_results *results, struct error *e)
{
    char path[4096];
    struct output_file file;
    snprintf(path, sizeof path, "%s/index.html", results->directory);
    if (output_open(&file, path, e))
        return e->status;
    struct sheet sheet = {&html, file.stream, results};
    fputs(opening, file.stream);
    fputs("<title>", file.stream);
    html_text(file.stream, results->study->title);
    fputs("</title>\n", file.stream);
    enum status status = sheet_write(&sheet, e);
    fputs("</html>\n", file.stream);
    enum status closed = output_close(&file, !status, e);
    return status ? status : closed;
}

const struct product_row product_page = {
    {"index.html", "the report as one page with figures and pictures in it", NULL, 0, NULL}, write_page};
