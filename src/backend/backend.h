/* Back ends: where particles live and passes run. The loop sees this interface only. */
#ifndef BACKEND_BACKEND_H
#define BACKEND_BACKEND_H

#include "backend/scalars.h"
#include "base/error.h"
#include "base/variant.h"
#include "device/device.h"
#include "grid/search.h"
#include "particles/shown.h"
#include "particles/space.h"
#include "solver/solver.h"

struct backend_setup {
    const struct solver_choice *choice;
    const struct space *space;
    const struct search_row *search;
    const char *isa;  /* row of "isas", or "auto" */
    int threads;      /* 0: all processors */
    int device;       /* of cuda */
    unsigned block;   /* struct backend_place */
    bool timed;       /* each pass is timed by itself, though it would be queued */
};

/* Lists may reach this much further than the support; beyond it the loop sorts anew. */
#define SKIN_MAX 0.25

/* Numbers of one step, in and out (struct scalars). */
struct step {
    float dt;          /* s, for predict and correct */
    float before;      /* s: of the step before; 0 at the first, and where no solver needs it */
    double list_radius;/* m, for sort and neighbours */
    struct extremes extremes; /* of the last predict, correct or move pass */
    enum solve solve;         /* which solve the pass belongs to, or comes before */
    bool looping;             /* the pass is of its loop */
    struct loop loop;         /* of the solve, in at its begin and out after each sweep */
    float resume;             /* part of the last step's shift that the next starts from */
    double residual;          /* left by the last sweep, as solve_limits count it */
};

/* What the time loop sets, and what it reads back. */
static inline void scalars_set(struct scalars *s, const struct step *step)
{
    s->dt = step->dt;
    s->before = step->before;
    s->resume = step->resume;
    s->loop = step->loop;
}
static inline void scalars_get(const struct scalars *s, struct step *step)
{
    step->extremes = s->extremes;
    step->residual = s->residual;
    step->loop = s->loop;
}

/* Work done so far. */
struct backend_counts {
    double pairs;      /* evaluated, with list entries beyond the support */
    double row_entries;/* of the present rows */
    double seconds[PASS_COUNT];
    long runs[PASS_COUNT];
};

struct backend; /* each back end's own state */

struct backend_row {
    struct variant variant;
    bool has_devices; /* NAME:N is its device N */
    const struct device_row *device; /* whose memory particles are in; NULL: the host's */
    /* Whether it can run here, else why not; NULL: everywhere. */
    bool (*available)(const char **why);
    /* STATUS_BACKEND when there is no such device, which is not touched; NULL: as of memory. */
    enum status (*exists)(int device, struct error *e);
    /* Free memory of a device, bytes, and its name; NULL: particles are in the host's. */
    double (*memory)(int device, char name[64], struct error *e);
    /* Takes over `particles` (positions, velocities, densities, ids, fluids set) and the wall
     * particles, which may be empty. */
    enum status (*open)(struct backend **backend, const struct backend_setup *setup,
                        struct particles *particles, struct particles *walls, struct error *e);
    enum status (*run)(struct backend *backend, enum pass_id pass, struct step *step,
                       struct error *e);
    /* Keeps the present state as the one before; predict then makes the new present one. */
    void (*begin)(struct backend *backend);
    /* Undoes begin and all passes since: the state before is the present one again. */
    void (*reject)(struct backend *backend);
    /* Waits for what run has queued and fills in *step what it left; NULL: run does not queue. */
    enum status (*settle)(struct backend *backend, struct step *step, struct error *e);
    /* `fields` of the present particles in host memory, in any order; valid until the next call. NULL
     * when they cannot be had. */
    const struct particles *(*state)(struct backend *backend, unsigned fields, struct error *e);
    /* Hands on what pictures show of the present state: how->to is in the memory where particles are, the
     * state in *how is left to the back end. May return before it is done: `filled` is signalled then, NULL on
     * the host. */
    enum status (*show)(struct backend *backend, const struct shown *how, struct device_event *filled,
                        struct error *e);
    /* particles_hash of the present state. */
    enum status (*hash)(struct backend *backend, uint64_t *hash, struct error *e);
    const struct backend_counts *(*counts)(struct backend *backend);
    /* "cpu (avx512, 2 threads)" */
    const char *(*describe)(struct backend *backend);
    /* Measured multiply-add peak in FLOP/s on the same threads and lanes. */
    double (*peak)(struct backend *backend);
    /* Measured bytes per second that a copy reads and writes; NULL: not measured. */
    double (*bandwidth)(struct backend *backend);
    void (*close)(struct backend *backend);
};

extern const struct variant_table backend_table; /* "backends" */
extern const struct backend_row backend_cpu;
extern const struct backend_row backend_cuda;
extern const struct backend_row backend_cuda_host; /* of tests: not in the table */

enum { BLOCK_MAX = 512 };

/* What --backend NAME, NAME:N or NAME:N:B says. */
struct backend_place {
    const struct backend_row *row; /* NULL: "auto" */
    int device;     /* N */
    unsigned block; /* B: threads of a block of sums over neighbours, warps of 32; 0: as the kernels like */
};

/* STATUS_USAGE when there is no such back end, STATUS_BACKEND when it is not in this build. */
enum status backend_find(const char *name, struct backend_place *place, struct error *e);

/* The first that can run here. */
const struct backend_row *backend_first(void);

#endif
