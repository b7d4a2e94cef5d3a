/* Quotes text as a JSON string, and words for a shell. */
#include "base/quote.h"

#include <stdio.h>
#include <string.h>

bool json_quote(const char *text, char *out, size_t size)
{
    size_t n = 0;
    bool whole = size > 2;
    if (size)
        out[0] = '\0';
    if (!whole)
        return false;
    out[n++] = '"';
    for (; *text && whole; text++) {
        char one[8];
        unsigned char byte = (unsigned char)*text;
        if (byte == '"' || byte == '\\')
            snprintf(one, sizeof one, "\\%c", byte);
        else if (byte < 32)
            snprintf(one, sizeof one, "\\u%04x", byte);
        else
            snprintf(one, sizeof one, "%c", byte);
        whole = n + strlen(one) + 2 <= size;
        if (whole) {
            memcpy(out + n, one, strlen(one));
            n += strlen(one);
        }
    }
    if (n + 2 > size)
        n = size - 2;
    out[n++] = '"';
    out[n] = '\0';
    return whole;
}

void shell_quote(const char *word, FILE *out)
{
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=:,./%@";
    if (*word && word[strspn(word, plain)] == 0) {
        fputs(word, out);
        return;
    }
    fputc('\'', out);
    for (; *word; word++)
        if (*word == '\'')
            fputs("'\\''", out);
        else
            fputc(*word, out);
    fputc('\'', out);
}
