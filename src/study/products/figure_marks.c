/* Labels beside marks and numbers along axes of a figure. */
#include "study/products/figure.h"
#include "study/products/text.h"

#include <math.h>
#include <string.h>

/* In parts of a figure's inside. */
#define LETTER_WIDTH  0.026
#define LETTER_HEIGHT 0.060
#define MARK_SIZE     0.030

struct box {
    double left, right, bottom, top;
};

static bool overlap(const struct box *a, const struct box *b)
{
    return a->left < b->right && b->left < a->right && a->bottom < b->top && b->bottom < a->top;
}

static struct box around(double x, double y, double width, double height)
{
    return (struct box){x - width / 2, x + width / 2, y - height / 2, y + height / 2};
}

static struct box mark_box(const struct figure_view *view, size_t k)
{
    return around(figure_part(&view->x, view->marks[k].x), figure_part(&view->y, view->marks[k].y),
                  MARK_SIZE, MARK_SIZE);
}

static struct box label_box(const struct figure_view *view, size_t k, enum label_side side)
{
    const struct study_point *point = view->marks[k].point;
    char text[32];
    text_value(point->ladder->labels[point->rung], text, sizeof text);
    double width = LETTER_WIDTH * (double)strlen(text);
    double x = figure_part(&view->x, view->marks[k].x), y = figure_part(&view->y, view->marks[k].y);
    double dx = (MARK_SIZE + width) / 2 + 0.008, dy = (MARK_SIZE + LETTER_HEIGHT) / 2;
    x += side == LABEL_RIGHT ? dx : side == LABEL_LEFT ? -dx : 0;
    y += side == LABEL_ABOVE ? dy : side == LABEL_BELOW ? -dy : 0;
    return around(x, y, width, LETTER_HEIGHT);
}

/* Whether a straight line between two marks goes through, to a part of its length. */
static bool line_crosses(const struct figure_view *view, size_t a, size_t b, const struct box *box)
{
    enum { PARTS = 40 };
    for (int part = 0; part <= PARTS; part++) {
        double t = (double)part / PARTS;
        double x = (1 - t) * figure_part(&view->x, view->marks[a].x) +
                   t * figure_part(&view->x, view->marks[b].x);
        double y = (1 - t) * figure_part(&view->y, view->marks[a].y) +
                   t * figure_part(&view->y, view->marks[b].y);
        if (x > box->left && x < box->right && y > box->bottom && y < box->top)
            return true;
    }
    return false;
}

/* The mark that the curve came from, or k itself. */
static size_t mark_before(const struct figure_view *view, size_t k)
{
    for (size_t before = k; before-- > 0;)
        if (view->marks[before].point->method == view->marks[k].point->method &&
            !view->marks[before].failed)
            return before;
    return k;
}

/* Whether the bar of the mark's seeds goes through. */
static bool bar_crosses(const struct figure_view *view, size_t k, const struct box *box)
{
    const struct figure_mark *mark = &view->marks[k];
    double y = figure_part(&view->y, mark->y);
    if (isnan(mark->high))
        return false;
    double low = mark->low > view->x.from ? figure_part(&view->x, mark->low) : 0;
    return y + MARK_SIZE / 2 > box->bottom && y - MARK_SIZE / 2 < box->top && low - MARK_SIZE / 2 < box->right &&
           figure_part(&view->x, mark->high) + MARK_SIZE / 2 > box->left;
}

static bool is_free(const struct figure_view *view, const enum label_side *sides, size_t k,
                    const struct box *box)
{
    if (box->left < 0 || box->right > 1 || box->bottom < 0 || box->top > 1)
        return false;
    for (size_t other = 0; other < view->count; other++) {
        struct box mark = mark_box(view, other), label = label_box(view, other, sides[other]);
        if ((other != k && overlap(box, &mark)) ||
            (other < k && sides[other] != LABEL_NONE && overlap(box, &label)) ||
            bar_crosses(view, other, box) ||
            (!view->marks[other].failed && line_crosses(view, mark_before(view, other), other, box)))
            return false;
    }
    return true;
}

void figure_labels(const struct figure_view *view, enum label_side *sides)
{
    for (size_t k = 0; k < view->count; k++) {
        sides[k] = LABEL_NONE;
        enum label_side first = view->marks[k].failed ? LABEL_RIGHT : LABEL_ABOVE;
        for (enum label_side side = first; side <= LABEL_LEFT && !sides[k]; side++) {
            struct box box = label_box(view, k, side);
            if (is_free(view, sides, k, &box))
                sides[k] = side;
        }
    }
}

/* "'0.01' 0.01" or "'10^{-7}' 1e-7". */
static void write_tic(double mantissa, int power, FILE *out)
{
    double value = mantissa * pow(10, power);
    if (power >= -3 && power < 5)
        fprintf(out, ", '%g' %.9g", value, value);
    else if (mantissa == 1)
        fprintf(out, ", '10^{%d}' %.9g", power, value);
    else
        fprintf(out, ", '%g·10^{%d}' %.9g", mantissa, power, value);
}

static bool among(double value, const double *values, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (values[k] == value)
            return true;
    return false;
}

static void log_tics(const struct figure_axis *axis, FILE *out)
{
    static const double few[] = {1, 2, 5}, many[] = {1, 1.5, 2, 3, 4, 5, 6, 8};
    double decades = log10(axis->to / axis->from);
    int first = (int)floor(log10(axis->from)), last = (int)ceil(log10(axis->to));
    int stride = (int)ceil(decades / 6);
    const double *mantissas = decades < 0.7 ? many : few;
    size_t count = decades < 0.7 ? sizeof many / sizeof *many : decades < 2.2 ? 3 : 1;
    double least = isnan(axis->zero) ? axis->from : axis->zero * 1.5;
    for (int power = first; power <= last; power++)
        for (size_t k = 0; k < count; k++) {
            double value = mantissas[k] * pow(10, power);
            if (value >= least && value <= axis->to && power % stride == 0)
                write_tic(mantissas[k], power, out);
        }
    for (int power = first; power <= last && decades < 6; power++)
        for (int k = 1; k < 10; k++)
            if (k * pow(10, power) >= least && k * pow(10, power) <= axis->to &&
                !among(k, mantissas, count))
                fprintf(out, ", '' %.9g 1", k * pow(10, power));
}

/* A ladder's own values are the numbers along it. */
static void value_tics(const struct figure *figure, const struct figure_axis *axis, FILE *out)
{
    for (size_t k = 0; k < figure->ladder->count; k++) {
        fputs(", '", out);
        char text[32];
        text_value(figure->ladder->labels[k], text, sizeof text);
        for (const char *c = text; *c; c++)
            fputs(*c == '\'' ? "''" : *c == '{' || *c == '}' || *c == '_' ? " " : (char[]){*c, 0}, out);
        if (axis->rungs)
            fprintf(out, "' %zu", k + 1);
        else
            fprintf(out, "' %s", figure->ladder->labels[k]);
    }
}

void figure_tics(const struct figure *figure, const struct figure_axis *axis, char letter, FILE *out)
{
    /* The first, outside, is there for the commas. */
    fprintf(out, "set %ctics (%s %.9g", letter, isnan(axis->zero) ? "''" : "'0'",
            isnan(axis->zero) ? axis->rungs ? -1 : axis->from / 1e9 : axis->zero);
    if (letter == 'x' && figure->kind == FIGURE_VALUE)
        value_tics(figure, axis, out);
    else
        log_tics(axis, out);
    fputs(")\n", out);
}
