/* State of the cuda back end, shared by its files. */
#ifndef BACKEND_CUDA_CUDA_H
#define BACKEND_CUDA_CUDA_H

#include "backend/backend.h"
#include "backend/cuda/kernels.h"

/* Neighbour rows on the device. */
struct device_rows {
    struct row_block *block;
    uint32_t *count, *length;
    uint32_t *index;
    float *weight;
    size_t room; /* entries of index, in blocks of 16 */
    bool weighted;
    struct row_facts *facts;
    double entries;  /* sum of count */
    bool coincident; /* two particles share a place */
};

/* Arrays that sorts and row builds need, for so many particles. */
struct device_sorting {
    uint64_t *keys, *sorted_keys;
    uint32_t *values, *order;
    void *spare; /* one field's worth */
    uint32_t *hits;
    uint32_t hit_words; /* struct order_work */
};

/* A pass that waits to be run, and where it stands. */
struct queued {
    enum pass_id pass; /* PASS_COUNT: the step's numbers go to the device */
    enum solve solve;
    bool looping;
};

enum { QUEUE_MAX = 512, GRAPHS_MAX = 64 };

struct recording {
    uint64_t key;
    struct device_graph *graph;
};

struct backend {
    const struct device_row *row;
    const struct kernel *kernels;
    struct device *device;
    struct solver_choice choice;
    struct solver_choice *there; /* the same on the device */
    struct space space;
    bool all, timed;
    unsigned block;          /* struct backend_place */
    struct particles particles, wall; /* on the device */
    struct particles seen;            /* copies in host memory */
    struct particles curl;            /* sorted copy for vorticity, on the device */
    struct cells cells, wall_cells, curl_cells;
    struct device_sorting sorting;
    struct device_rows rows, wall_rows, curl_rows;
    struct work_arrays arrays;
    struct scalars *scalars; /* on the device */
    struct scalars *in;      /* pinned: of the step, and of each solve */
    struct scalars *out;     /* pinned */
    float *fixed;            /* on the device: values of pictures that never change; or NULL */
    uint64_t *hash, *hash_read; /* on the device, and pinned */
    struct queued queue[QUEUE_MAX];
    size_t queued;
    struct recording recordings[GRAPHS_MAX];
    size_t recorded;
    bool sweeps[PASS_COUNT]; /* passes of the present solve's sweeps */
    int swept;               /* sweeps of the present solve that are counted */
    struct backend_counts counts;
    char text[DEVICE_NAME + 64];
};

static inline void cuda_launch(struct backend *b, enum kernel_id kernel, size_t threads,
                               const void *work)
{
    b->row->launch(b->device, &b->kernels[kernel], threads, work);
}

/* Device memory of `count` records of `size` bytes, padded to blocks of lanes. */
void *cuda_array(struct backend *b, const char *label, size_t count, size_t size, struct error *e);

/* Copies from any host memory, and waits for it. */
enum status cuda_upload(struct backend *b, void *to, const void *from, size_t bytes, struct error *e);

/* Sorts particles for rows of radius `radius` (m). */
enum status cuda_sort(struct backend *b, struct particles *p, struct cells *cells, double radius,
                      struct error *e);

/* Words that note which candidates of a particle are its neighbours, on the lattice and some more. */
uint32_t cuda_hit_words(const struct solver_choice *choice);

enum status cuda_rows_create(struct backend *b, struct device_rows *rows, size_t points,
                             bool weighted, struct error *e);
void cuda_rows_free(struct backend *b, struct device_rows *rows);

/* Builds the rows of `points` among `candidates`, which are in `cells`; `same` when they are the
 * points. Sets *moved when rows are elsewhere in memory than before. */
enum status cuda_rows_build(struct backend *b, struct device_rows *rows,
                            const struct particles *points, const struct particles *candidates,
                            const struct cells *cells, bool same, double radius, bool *moved,
                            struct error *e);

/* Rows of particles and walls; moves particles apart that share a place. */
enum status cuda_neighbours(struct backend *b, double radius, struct error *e);

/* Volumes of the wall particles. */
enum status cuda_weigh_walls(struct backend *b, struct error *e);

/* Vorticity of the present state, from neighbours within `radius` (m). */
enum status cuda_curl(struct backend *b, double radius, struct error *e);

/* What a pass works on, as particles lie now. */
struct work cuda_work(struct backend *b, enum pass_id pass, enum solve solve, bool looping);

/* Queues a pass, runs what is queued, and waits for it. */
enum status cuda_queue(struct backend *b, enum pass_id pass, const struct step *step,
                       struct error *e);
void cuda_flush(struct backend *b);
enum status cuda_settle(struct backend *b, struct step *step, struct error *e);

/* Forgets recorded graphs: arrays are elsewhere. */
void cuda_forget(struct backend *b);

/* The back end on a device of a launch layer. */
enum status cuda_open_on(const struct device_row *row, const struct kernel *kernels,
                         struct backend **out, const struct backend_setup *setup,
                         struct particles *particles, struct particles *walls, struct error *e);

/* What rows of back ends hold (struct backend_row). */
enum status cuda_run(struct backend *b, enum pass_id pass, struct step *step, struct error *e);
void cuda_swap(struct backend *b);
const struct particles *cuda_state(struct backend *b, unsigned fields, struct error *e);
enum status cuda_show(struct backend *b, const struct shown *how, struct device_event *filled,
                      struct error *e);
enum status cuda_hash(struct backend *b, uint64_t *hash, struct error *e);
const struct backend_counts *cuda_counts(struct backend *b);
const char *cuda_describe(struct backend *b);
double cuda_peak(struct backend *b);
double cuda_bandwidth(struct backend *b);
void cuda_close(struct backend *b);

#define CUDA_FUNCTIONS                                                                             \
    .run = cuda_run, .begin = cuda_swap, .reject = cuda_swap, .settle = cuda_settle,               \
    .state = cuda_state, .show = cuda_show, .hash = cuda_hash, .counts = cuda_counts,              \
    .describe = cuda_describe, .peak = cuda_peak, .bandwidth = cuda_bandwidth, .close = cuda_close

#endif
