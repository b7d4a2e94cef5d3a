/* Measures volume: that of the particles, sum m / rho, and that below the free surface. */
#include "base/memory.h"
#include "run/measure.h"

#include <math.h>

/* Upright columns over the domain, along the axis that is nearest to up. */
struct columns {
    int up, sign, across[2];
    size_t count[2];
    double size[2], floor; /* m */
};

static struct columns columns_of(const struct measured *m)
{
    struct columns c;
    const double *min = m->scene->domain.min, *max = m->scene->domain.max;
    c.up = measure_up_axis(m, &c.sign);
    c.floor = c.sign > 0 ? min[c.up] : max[c.up];
    for (int k = 0; k < 2; k++) {
        int a = c.across[k] = (c.up + 1 + k) % 3;
        c.count[k] = (size_t)fmax(1, rint((max[a] - min[a]) / (2 * m->choice->spacing)));
        c.size[k] = (max[a] - min[a]) / (double)c.count[k];
    }
    return c;
}

/* The fluid of a column reaches half a spacing above its highest particle. */
static void lift(const struct measured *m, const struct columns *c, double *top, const double x[3])
{
    size_t at[2];
    for (int k = 0; k < 2; k++) {
        int a = c->across[k];
        double place = floor((x[a] - m->scene->domain.min[a]) / c->size[k]);
        at[k] = (size_t)fmin(fmax(place, 0), (double)(c->count[k] - 1));
    }
    double *own = &top[at[0] + c->count[0] * at[1]];
    *own = fmax(*own, c->sign * (x[c->up] - c->floor) + m->choice->spacing / 2);
}

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    struct columns c = columns_of(m);
    struct error ignored;
    double *top = memory_create("measures", c.count[0] * c.count[1], sizeof *top, &ignored);
    out[0] = out[1] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        out[0] += s.mass / s.density;
        if (top)
            lift(m, &c, top, s.x);
    }
    for (size_t k = 0; top && k < c.count[0] * c.count[1]; k++)
        out[1] += top[k];
    out[1] = top ? out[1] * c.size[0] * c.size[1] : (double)NAN;
    memory_free(top);
}

static const struct measure_column columns[] = {
    {"particles", "m^3"}, {"surface", "m^3"}, {NULL, NULL}};

extern const struct measure_row measure_volume;
const struct measure_row measure_volume = {
    .variant = {.name = "volume",
                .doc = "of the particles, sum of m/rho; and below the free surface, by columns "
                       "of 2 spacings"},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_DENSITY),
    .columns = columns,
    .value = value,
};
