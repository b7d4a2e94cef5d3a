/* Writes single values as JSON, and says in words what a key takes. */
#include "base/quote.h"
#include "scene/value.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

size_t value_size(enum key_type type)
{
    switch (type) {
    case KEY_BOOL: return sizeof(bool);
    case KEY_INT: return sizeof(int64_t);
    case KEY_REAL: return sizeof(double);
    case KEY_VEC3: return 3 * sizeof(double);
    case KEY_PAIR: return 2 * sizeof(double);
    case KEY_SIZE: return 2 * sizeof(int);
    case KEY_ENUM: return sizeof(int);
    default: return KEY_TEXT_SIZE;
    }
}

void value_number(double number, char out[32])
{
    if (!isfinite(number)) {
        snprintf(out, 32, "null");
        return;
    }
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(out, 32, "%.*g", digits, number);
        if (strtod(out, NULL) == number)
            break;
    }
}

static void write_numbers(const double *numbers, int count, FILE *out)
{
    for (int i = 0; i < count; i++) {
        char text[32];
        value_number(numbers[i], text);
        fprintf(out, "%s%s", i ? ", " : count > 1 ? "[" : "", text);
    }
    if (count > 1)
        fputc(']', out);
}

static void write_text(const char *text, FILE *out)
{
    char quoted[6 * KEY_TEXT_SIZE + 3];
    json_quote(text, quoted, sizeof quoted);
    fputs(quoted, out);
}

void value_write(const struct key *key, const void *memory, FILE *out)
{
    const double *real = memory;
    const int *integer = memory;
    char word[KEY_TEXT_SIZE];
    bool numbers = key->type == KEY_REAL || key->type == KEY_VEC3 || key->type == KEY_PAIR;
    if (numbers && isnan(real[0])) {
        fputs("\"auto\"", out);
        return;
    }
    switch (key->type) {
    case KEY_BOOL: fputs(*(const bool *)memory ? "true" : "false", out); break;
    case KEY_INT: fprintf(out, "%" PRId64, *(const int64_t *)memory); break;
    case KEY_REAL: write_numbers(real, 1, out); break;
    case KEY_VEC3: write_numbers(real, 3, out); break;
    case KEY_PAIR: write_numbers(real, 2, out); break;
    case KEY_SIZE: fprintf(out, "[%d, %d]", integer[0], integer[1]); break;
    case KEY_TEXT:
    case KEY_CHOICE: write_text(memory, out); break;
    case KEY_ENUM:
        key_word_at(key->choices, *integer, word);
        write_text(word, out);
        break;
    }
}

static void range_words(const struct key *key, char *out, size_t size)
{
    char low[32], high[32];
    if (key->min == key->max)
        return;
    value_number(key->min, low);
    value_number(key->max, high);
    bool above = key->flags & KEY_ABOVE_MIN, bounded = isfinite(key->max);
    if (isfinite(key->min) && bounded)
        snprintf(out, size, above ? " above %s and up to %s" : " from %s to %s", low, high);
    else if (isfinite(key->min))
        snprintf(out, size, above ? " above %s" : " of at least %s", low);
    else if (bounded)
        snprintf(out, size, " up to %s", high);
}

void value_expected(const struct key *key, char *out, size_t size)
{
    static const char *const names[] = {
        [KEY_BOOL] = "true or false", [KEY_INT] = "a whole number", [KEY_REAL] = "a number",
        [KEY_TEXT] = "a string", [KEY_CHOICE] = "a string", [KEY_ENUM] = "a string",
        [KEY_VEC3] = "an array of 3 numbers", [KEY_PAIR] = "an array of 2 numbers",
        [KEY_SIZE] = "an array of 2 whole numbers"};
    char range[80] = "";
    range_words(key, range, sizeof range);
    if (key->choices && strchr(key->choices, '|'))
        snprintf(out, size, "one of %s", key->choices);
    else
        snprintf(out, size, "%s%s", names[key->type], range);
}
