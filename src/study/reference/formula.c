/* Evaluates formulas of time. */
#include "study/reference/formula.h"

#if HAVE_MUPARSER
#include <muParserDLL.h>

static void leave_to_caller(muParserHandle_t parser)
{
    (void)parser; /* or muParser prints the error itself */
}

enum status formula_values(const char *formula, const double *times, size_t count, double *values,
                           struct error *e)
{
    double t = 0;
    enum { REAL_NUMBERS = 0 };
    enum status status = STATUS_OK;
    muParserHandle_t parser = mupCreate(REAL_NUMBERS);
    if (!parser)
        return error_set(e, STATUS_RUN, "memory is short");
    mupSetErrorHandler(parser, leave_to_caller);
    mupDefineConst(parser, "pi", 3.14159265358979323846);
    mupDefineConst(parser, "e", 2.71828182845904523536);
    mupDefineVar(parser, "t", &t);
    mupSetExpr(parser, formula);
    for (size_t k = 0; k < count && !mupError(parser); k++) {
        t = times[k];
        values[k] = mupEval(parser);
    }
    if (mupError(parser))
        status = error_set(e, STATUS_USAGE, "formula \"%.200s\": %.200s; it may have t (s), pi, e, + - * / "
                           "^, and functions such as exp, sin, sqrt", formula,
                           mupGetErrorMsg(parser));
    mupRelease(parser);
    return status;
}
#else
enum status formula_values(const char *formula, const double *times, size_t count, double *values,
                           struct error *e)
{
    (void)times, (void)count, (void)values;
    return error_set(e, STATUS_BACKEND, "formula \"%.200s\": this build has no muParser; install "
                     "libmuparser-dev and build again", formula);
}
#endif
