/* How far a ladder's values are from their limit, told from three rungs without knowing it. */
#include "study/richardson.h"

#include <math.h>

const char *const richardson_words[] = {
    [RICHARDSON_KNOWN] = "",
    [RICHARDSON_FEW] = "fewer than three rungs",
    [RICHARDSON_NORM] = "the norm has no sign",
    [RICHARDSON_SAME] = "the rungs do not differ",
    [RICHARDSON_OSCILLATES] = "the rungs oscillate",
    [RICHARDSON_DIVERGES] = "the differences of the rungs do not shrink",
    [RICHARDSON_NOISE] = "the rungs differ by less than their seeds",
};

#define ORDER_MOST 20.0

/* (v0 - v1) / (v1 - v2) of values v = limit + C d^p; rises with p. */
static double ratio_of_order(double p, double coarse, double fine)
{
    return pow(fine, p) * (pow(coarse, p) - 1) / (pow(fine, p) - 1);
}

/* Celik et al. 2008, J. Fluids Eng. 130, 078001, equation 5, solved by halving. */
static double find_order(double ratio, double coarse, double fine)
{
    double low = 1e-3, high = ORDER_MOST;
    for (int k = 0; k < 60; k++) {
        double middle = (low + high) / 2;
        *(ratio_of_order(middle, coarse, fine) < ratio ? &low : &high) = middle;
    }
    return (low + high) / 2;
}

struct richardson richardson_of(const double d[3], const double values[3])
{
    struct richardson r = {RICHARDSON_SAME, (double)NAN, (double)NAN, (double)NAN, (double)NAN};
    double coarse = d[0] / d[1], fine = d[1] / d[2];
    double before = values[0] - values[1], last = values[1] - values[2];
    if (before == 0 || last == 0)
        return r;
    r.kind = before / last < 0                                              ? RICHARDSON_OSCILLATES
             : before / last <= ratio_of_order(1e-3, coarse, fine)           ? RICHARDSON_DIVERGES
                                                                             : RICHARDSON_KNOWN;
    if (r.kind != RICHARDSON_KNOWN)
        return r;
    r.order = find_order(before / last, coarse, fine);
    double rest = last / (pow(fine, r.order) - 1); /* of the finest value */
    r.extrapolated = values[2] - rest;
    r.factor = r.order >= 0.5 && r.order <= 3 ? 1.25 : 3;
    r.gci = r.factor * fabs(rest);
    return r;
}

/* The method's finest point that is done and coarser than `than`, or NULL. */
static const struct study_point *finer(const struct study_points *points, const struct study_ladder *ladder,
                                       const struct study_method *method, const char *error, double than)
{
    const struct study_point *best = NULL;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        if (p->ladder == ladder && p->method == method && p->outcome == OUTCOME_DONE &&
            study_error(p, error) && p->scene->particles.spacing > than * 1.0001 &&
            (!best || p->scene->particles.spacing < best->scene->particles.spacing))
            best = p;
    }
    return best;
}

/* The variance of a mean over seeds. */
static double variance(const struct study_error *error)
{
    return error->runs > 1 ? error->deviation * error->deviation / error->runs : 0;
}

struct richardson richardson_ladder(const struct study_points *points, const struct study_ladder *ladder,
                                    const struct study_method *method, const struct study_asked *asked)
{
    struct richardson r = {RICHARDSON_FEW, (double)NAN, (double)NAN, (double)NAN, (double)NAN};
    double d[3], values[3], noise[3], than = 0;
    for (int k = 2; k >= 0; k--) {
        const struct study_point *p = finer(points, ladder, method, asked->name, than);
        if (!p)
            return r;
        d[k] = than = p->scene->particles.spacing;
        values[k] = study_error(p, asked->name)->value;
        noise[k] = variance(study_error(p, asked->name));
    }
    if (!asked->norm->has_sign) {
        r.kind = RICHARDSON_NORM;
        return r;
    }
    r = richardson_of(d, values);
    if (fabs(values[1] - values[2]) < sqrt(noise[1] + noise[2])) /* no sign of it is sure */
        r.kind = RICHARDSON_NOISE;
    return r;
}

bool richardson_applies(const struct study_points *points, const struct study_ladder *ladder,
                        const struct study_asked *asked)
{
    double first = 0;
    bool differ = false;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        if (p->ladder != ladder)
            continue;
        first = first > 0 ? first : p->scene->particles.spacing;
        differ = differ || p->scene->particles.spacing != first;
    }
    return differ && asked->kind == REFERENCE_RUN;
}
