/* Formulas of time in study files, "exp(-2*t)", by muParser. */
#ifndef STUDY_FORMULA_H
#define STUDY_FORMULA_H

#include "base/error.h"

#include <stddef.h>

/* values[k] = formula at t = times[k], s; pi and e are known. STATUS_USAGE with what is not understood
 * and where in the formula, STATUS_BACKEND when the program was built without muParser. */
enum status formula_values(const char *formula, const double *times, size_t count, double *values,
                           struct error *e);

#endif
