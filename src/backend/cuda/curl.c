/* Vorticity of the present state, for a frame: a sorted copy of the particles with neighbour rows
 * of its own, so that the order and the rows of the steps, hence their bits, stay as they are. */
#include "backend/cuda/cuda.h"

static const enum field copied[] = {FIELD_POSITION, FIELD_MOTION, FIELD_ID};
enum { COPIED = sizeof copied / sizeof *copied };

static enum status create_copy(struct backend *b, struct error *e)
{
    struct particles *p = &b->curl;
    if (p->now[FIELD_VORTICITY])
        return STATUS_OK;
    p->count = b->particles.count;
    for (int k = 0; k < COPIED; k++) {
        const struct field_row *row = &field_table[copied[k]];
        p->now[copied[k]] = cuda_array(b, row->name, p->count, row->size, e);
        if (!p->now[copied[k]])
            return e->status;
    }
    p->now[FIELD_VORTICITY] = cuda_array(b, "vorticity", p->count, sizeof(float), e);
    if (!p->now[FIELD_VORTICITY])
        return e->status;
    return cuda_rows_create(b, &b->curl_rows, p->count, false, e);
}

enum status cuda_curl(struct backend *b, double radius, struct error *e)
{
    struct particles *p = &b->curl;
    bool moved;
    if (create_copy(b, e) || p->count == 0)
        return e->status;
    for (int k = 0; k < COPIED; k++)
        b->row->copy(b->device, p->now[copied[k]], b->particles.now[copied[k]],
                     p->count * field_table[copied[k]].size);
    if (cuda_sort(b, p, &b->curl_cells, radius, e) ||
        cuda_rows_build(b, &b->curl_rows, p, p, &b->curl_cells, true, radius, &moved, e))
        return e->status;
    struct work work = {.count = p->count,
                        .constants = b->choice.pair,
                        .choice = b->there,
                        .scalars = b->scalars,
                        .position = p->now[FIELD_POSITION],
                        .motion = p->now[FIELD_MOTION],
                        .rows = b->curl_rows.block,
                        .row_count = b->curl_rows.count,
                        .vorticity = p->now[FIELD_VORTICITY]};
    work.constants.inverse_h =
        1 / b->choice.each.h; /* some solvers keep a factor of theirs in it */
    cuda_launch(b, KERNEL_pair_curl, p->count, &work);
    struct order_work back = {.to = b->particles.now[FIELD_VORTICITY],
                              .from = p->now[FIELD_VORTICITY],
                              .order = b->sorting.order};
    cuda_launch(b, KERNEL_order_hand_back, p->count, &back);
    return b->row->wait(b->device, e);
}
