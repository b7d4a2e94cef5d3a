/* Numbers and words as reports say them. */
#include "study/products/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char text_none[] = "–";

void text_number(double value, char *out, size_t size)
{
    if (isnan(value))
        snprintf(out, size, "%s", text_none);
    else if (value == floor(value) && fabs(value) < 1e8)
        snprintf(out, size, "%.0f", value);
    else
        snprintf(out, size, "%.4g", value);
}

double text_scale(const char *unit)
{
    return strcmp(unit, "%") == 0 ? 100 : 1;
}

void text_error(double value, const char *unit, char *out, size_t size)
{
    if (isnan(value))
        snprintf(out, size, "%s", text_none);
    else
        snprintf(out, size, "%.3g%s%s", value * text_scale(unit), unit[0] ? " " : "", unit);
}

void text_found(const struct study_error *error, char *out, size_t size)
{
    double scale = text_scale(error->unit);
    size_t length;
    if (error->runs > 1)
        snprintf(out, size, "%.3g ± %.2g%s%s", error->value * scale, error->deviation * scale,
                 error->unit[0] ? " " : "", error->unit);
    else
        text_error(error->value, error->unit, out, size);
    length = strlen(out);
    if (error->runs < error->seeds)
        snprintf(out + length, size - length, " (%d of %d seeds)", error->runs, error->seeds);
}

void text_value(const char *value, char *out, size_t size)
{
    char *end;
    double number = strtod(value, &end);
    if (end == value || *end)
        snprintf(out, size, "%s", value);
    else
        snprintf(out, size, "%.4g", number);
}

void text_markdown(const char *text, FILE *out)
{
    for (; *text; text++) {
        if (strchr("\\`*_[]<>|#", *text))
            fputc('\\', out);
        fputc(*text == '\n' ? ' ' : *text, out);
    }
}
