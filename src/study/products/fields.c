/* Writes fields of csv lines and members of JSON objects. */
#include "study/products/fields.h"

#include "base/quote.h"

#include <math.h>

void csv_text(const char *text, FILE *out)
{
    fputc('"', out);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', out);
        fputc(*text, out);
    }
    fputc('"', out);
}

void csv_number(double number, FILE *out)
{
    if (isfinite(number))
        fprintf(out, "%.9g", number);
}

void json_text(const char *key, const char *text, FILE *out)
{
    char quoted[2048];
    json_quote(text, quoted, sizeof quoted);
    fprintf(out, "\"%s\": %s, ", key, quoted);
}

void json_number(const char *key, double number, FILE *out)
{
    if (isfinite(number))
        fprintf(out, "\"%s\": %.9g, ", key, number);
    else
        fprintf(out, "\"%s\": null, ", key);
}
