/* The table of validation cases. */
#include "study/cases/case.h"

#include <math.h>
#include <stdarg.h>

extern const struct case_row case_free_fall, case_poiseuille, case_couette, case_taylor_green,
    case_beltrami, case_elliptic_drop, case_oscillating_drop, case_capillary_drop,
    case_square_patch, case_standing_wave, case_martin_moyce, case_hydrostatic,
    case_hydrostatic_tilted, case_deep_column;

static const struct variant *const rows[] = {
    &case_free_fall.variant,
    &case_poiseuille.variant,
    &case_couette.variant,
    &case_taylor_green.variant,
    &case_beltrami.variant,
    &case_elliptic_drop.variant,
    &case_oscillating_drop.variant,
    &case_capillary_drop.variant,
    &case_square_patch.variant,
    &case_standing_wave.variant,
    &case_martin_moyce.variant,
    &case_hydrostatic.variant,
    &case_hydrostatic_tilted.variant,
    &case_deep_column.variant,
};

const struct variant_table case_table = {
    "cases", "validation cases: what studies measure and compare", rows,
    sizeof rows / sizeof *rows};

enum status case_check(const struct case_row *row, const struct scene *scene, struct error *e)
{
    const char *lack = scene->body_count ? row->lacks(scene) : "a body";
    if (!lack)
        return STATUS_OK;
    return error_set(e, STATUS_USAGE, "%s: the case \"%s\" needs %s", scene->source,
                     row->variant.name, lack);
}

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

double study_error_amount(const struct study_error *error)
{
    return error->runs > 0 ? error->size : fabs(error->value);
}

void study_error_spread(struct study_errors *errors, double spread)
{
    if (errors->count)
        errors->items[errors->count - 1].spread = spread;
}
