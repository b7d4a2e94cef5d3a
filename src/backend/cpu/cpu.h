/* State of the cpu back end, shared by its files. */
#ifndef BACKEND_CPU_CPU_H
#define BACKEND_CPU_CPU_H

#include "backend/backend.h"
#include "backend/cpu/isa.h"
#include "backend/cpu/rows.h"
#include "backend/stages.h"

struct backend {
    struct solver_choice choice;
    struct space space;
    const struct search_row *search;
    const struct isa_row *isa;
    int threads;
    struct particles particles, wall;
    struct cells cells, wall_cells;
    struct rows rows, wall_rows;
    uint32_t *order, *scratch;       /* particle indices */
    uint32_t *axis[3], *wall_axis[3];/* coordinates by axis, for the row build */
    void *spare;                     /* one field's worth of particles, for permuting */
    struct work_arrays arrays;
    struct scalars scalars;
    struct backend_counts counts;
    char text[128];
};

/* Sorts particles for rows of radius `radius` (m), and makes their coordinates by axis. */
enum status cpu_sort(struct backend *b, struct particles *p, struct cells *cells,
                     uint32_t *const axis[3], double radius, struct error *e);

/* What a build of the particles' rows reads; `radius` in m. */
struct row_build cpu_row_build(const struct backend *b, double radius);

/* Vorticity of the present state, from neighbours within `radius` (m); leaves the rest as it is. */
enum status cpu_curl(struct backend *b, double radius, struct error *e);

/* What a pass works on. */
struct work cpu_work(struct backend *b, enum pass_id pass, enum solve solve);

/* Runs a pair body over all blocks. */
void cpu_pair(struct backend *b, const struct work *work, enum pair_pass pass);

/* Runs a stage over the particles. */
void cpu_stage(const struct work *work, enum stage_id stage);

#endif
