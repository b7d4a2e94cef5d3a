/* The table of validation cases. */
#include "study/case.h"

#include <math.h>
#include <stdarg.h>

extern const struct case_row case_free_fall;

static const struct variant *const rows[] = {
    &case_free_fall.variant,
};

const struct variant_table case_table = {
    "cases", "validation cases: what studies measure and compare", rows,
    sizeof rows / sizeof *rows};

void study_error_add(struct study_errors *errors, double value, const char *unit, double asked,
                     const char *format, ...)
{
    va_list args;
    if (errors->count == ERRORS_MAX)
        return;
    struct study_error *error = &errors->items[errors->count++];
    *error = (struct study_error){.value = value, .unit = unit, .asked = asked,
                                   .spread = (double)NAN};
    va_start(args, format);
    vsnprintf(error->name, sizeof error->name, format, args);
    va_end(args);
}

void study_error_spread(struct study_errors *errors, double spread)
{
    if (errors->count)
        errors->items[errors->count - 1].spread = spread;
}
