/* Formats error messages. */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

enum status error_set(struct error *e, enum status status, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    e->status = status;
    vsnprintf(e->text, sizeof e->text, format, args);
    va_end(args);
    return status;
}

enum status error_context(struct error *e, const char *format, ...)
{
    char context[512], text[sizeof e->text];
    va_list args;
    va_start(args, format);
    vsnprintf(context, sizeof context, format, args);
    va_end(args);
    snprintf(text, sizeof text, "%s: %.1400s", context, e->text);
    return error_set(e, e->status, "%s", text);
}
