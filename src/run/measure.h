/* Measured quantities: rows of numbers from the particle state, at chosen times, for csv outputs.
 *
 * A quantity reads the state that the back end hands out, between steps. Sums are taken in double
 * in order of particle id, and quantiles from whole coordinates, so that a row has the same bits
 * for any number of threads, instruction set and order of particles in memory. */
#ifndef RUN_MEASURE_H
#define RUN_MEASURE_H

#include "base/variant.h"
#include "particles/particles.h"
#include "particles/space.h"
#include "scene/scene.h"
#include "solver/solver.h"

/* What a quantity sees. */
struct measured {
    const struct scene *scene;
    const struct space *space;
    const struct solver_choice *choice;
    const struct particles *particles; /* as the back end has them, in any order */
    const uint32_t *place;             /* by id: where the particle is in memory */
    size_t count;
    double time;                       /* s */
    double up[3];                      /* against gravity, or y */
};

/* One particle, SI units. */
struct sample {
    double x[3], v[3];
    double pressure, density, rest_density, mass;
};

struct measure_column {
    const char *name; /* after the measure's own name and a dot; "" for the only one */
    const char *unit;
};

struct measure_row {
    struct variant variant;  /* keys "measure[]. ..." have their places in struct scene_measure */
    unsigned reads;          /* FIELD_BIT mask */
    const struct measure_column *columns; /* ended by a NULL name */
    bool per_point;          /* the columns once for each of `points` */
    void (*value)(const struct measured *m, const struct scene_measure *asked, double *out);
};

extern const struct variant_table measure_table; /* "measures" */

/* What is measured when a scene has no list. */
extern const struct scene_measure measure_usual[];
extern const size_t measure_usual_count;

/* Places of keys in an element, and the usual rows of points and radii. */
#define MEASURE_IN(member) offsetof(struct scene_measure, member)
#define MEASURE_AT(doc) \
    {"measure[].at", KEY_VEC3, KEY_INSIDE, NULL, 0, 0, "m", NULL, doc, MEASURE_IN(at)}
#define MEASURE_RADIUS \
    {"measure[].radius", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", 0, INFINITY, "m", NULL, \
     "of the kernel that weighs particles; auto: the solver's support", MEASURE_IN(radius)}
#define MEASURE_KEYS(keys) .keys = keys, .key_count = sizeof keys / sizeof *keys

/* The particle of that id. */
struct sample measure_sample(const struct measured *m, size_t id);

/* From `at` to x, m; on periodic axes to the nearest image. */
void measure_offset(const struct measured *m, const double at[3], const double x[3],
                    double out[3]);

/* Weight of a particle at `distance` in a Shepard mean: its volume times the solver's kernel, here
 * with support `radius`. */
double measure_weight(const struct measured *m, const struct sample *s, double distance,
                      double radius);
double measure_radius(const struct measured *m, const struct scene_measure *asked);

/* The coordinate along the axis that `part` of all particles do not pass, m: going towards `side`
 * (+1, -1) that of the particle of rank ceil(part * count). NAN without particles. */
double measure_quantile(const struct measured *m, int axis, int side, double part);

/* The axis nearest to up; *sign is +1 when up is along it. */
int measure_up_axis(const struct measured *m, int *sign);

/* One quantity of a run. */
struct measure {
    const struct measure_row *row;
    const struct scene_measure *asked;
    size_t first, columns; /* its place in a row of numbers */
};

/* All that a run measures. Empty when no output wants rows. */
struct measures {
    struct measure *items;
    size_t count;
    double interval;        /* s */
    const char **columns;   /* "time (s)", "energy.kinetic (J)" ... */
    size_t column_count;
    unsigned reads;
    char *text;             /* of the columns */
    double *numbers;        /* the present row */
    uint32_t *place;
};

/* Makes room for everything; STATUS_RUN. `particles` is their number. */
enum status measures_create(struct measures *measures, const struct scene *scene, size_t particles,
                            struct error *e);
void measures_free(struct measures *measures);

/* Measures the state at `time`; the numbers are kept until the next call. */
const double *measures_take(struct measures *measures, const struct scene *scene,
                            const struct space *space, const struct solver_choice *choice,
                            const struct particles *particles, double time);

#endif
