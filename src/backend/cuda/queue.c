/* Passes are queued, and run as graphs: what repeats from step to step is recorded once. */
#include "backend/cuda/cuda.h"

#include "base/fnv.h"
#include "base/log.h"

#include <stddef.h>
#include <string.h>

struct work cuda_work(struct backend *b, enum pass_id pass, enum solve solve, bool looping)
{
    struct work_rows rows = {b->rows.block, b->wall_rows.block, b->rows.count, b->wall_rows.count};
    struct work work = work_make(pass, solve, looping, &b->choice, b->there, b->scalars, &b->particles,
                                 b->wall.count ? b->wall.now[FIELD_POSITION] : NULL, &b->arrays, &rows);
    work.block = b->block;
    return work;
}

/* Numbers of the step, or of a solve, from pinned memory. */
static void upload_numbers(struct backend *b, const struct queued *q)
{
    if (q->pass == PASS_COUNT)
        b->row->upload(b->device, b->scalars, &b->in[0], offsetof(struct scalars, loop));
    else
        b->row->upload(b->device, &b->scalars->loop, &b->in[1 + q->solve].loop,
                       sizeof(struct loop));
}

static bool begins_loop(enum pass_id pass)
{
    return pass == PASS_SOLVE_VELOCITY || pass == PASS_SOLVE_SHIFT || pass == PASS_SOLVE_VISCOSITY;
}

/* Launches the stages of a pass; without particles, only what works on scalars. */
static void launch_pass(struct backend *b, const struct queued *q)
{
    size_t count;
    if (q->pass == PASS_COUNT || begins_loop(q->pass))
        upload_numbers(b, q);
    if (q->pass == PASS_COUNT)
        return;
    const struct stage *stage = stages_of(q->pass, &count);
    struct work work = cuda_work(b, q->pass, q->solve, q->looping);
    for (size_t k = 0; k < count; k++) {
        if (!stage_wanted(&stage[k], &b->choice, &work))
            continue;
        enum kernel_id kernel =
            stage[k].is_pair
                ? KERNEL_pair_density_wendland + pair_find(stage[k].pair, &work, b->choice.flags)
                : (enum kernel_id)stage[k].id;
        size_t threads = stage_is_scalar(&stage[k]) ? 1 : work.count;
        if (threads > 0)
            cuda_launch(b, kernel, threads, &work);
    }
}

static double pair_stages(enum pass_id pass)
{
    size_t count;
    double pairs = 0;
    const struct stage *stage = stages_of(pass, &count);
    for (size_t k = 0; k < count; k++)
        pairs += stage[k].is_pair;
    return pairs;
}

static void count_pass(struct backend *b, enum pass_id pass, double times)
{
    b->counts.runs[pass] += (long)times;
    b->counts.pairs += times * pair_stages(pass) * b->counts.row_entries;
}

/* Passes that are run as one: up to a loop, or one sweep of it. */
static size_t unit_length(const struct backend *b, size_t first)
{
    size_t k = first + 1;
    bool looping = b->queue[first].looping;
    if (looping && b->queue[first].pass == PASS_SOLVED)
        return 1;
    while (k < b->queued && b->queue[k].looping == looping) {
        k++;
        if (looping && b->queue[k - 1].pass == PASS_SOLVED)
            break;
    }
    return k - first;
}

/* The same passes on the same arrays. */
static uint64_t unit_key(const struct backend *b, size_t first, size_t length)
{
    const void *parity = b->particles.now[FIELD_POSITION];
    uint64_t key = fnv_bytes(FNV_START, &parity, sizeof parity);
    for (size_t k = first; k < first + length; k++) {
        const struct queued *q = &b->queue[k];
        int word[3] = {(int)q->pass, (int)q->solve, q->looping};
        key = fnv_bytes(key, word, sizeof word);
    }
    return key;
}

static void launch_unit(struct backend *b, size_t first, size_t length)
{
    for (size_t k = first; k < first + length; k++)
        launch_pass(b, &b->queue[k]);
}

static void run_unit(struct backend *b, size_t first, size_t length)
{
    uint64_t key = unit_key(b, first, length);
    size_t k = 0;
    while (k < b->recorded && b->recordings[k].key != key)
        k++;
    if (k == b->recorded && (b->timed || k == GRAPHS_MAX || !b->row->record(b->device))) {
        launch_unit(b, first, length);
        return;
    }
    if (k == b->recorded) {
        launch_unit(b, first, length);
        struct device_graph *graph = b->row->recorded(b->device);
        if (!graph) { /* it could not be recorded: run it as it is */
            launch_unit(b, first, length);
            return;
        }
        b->recordings[b->recorded++] = (struct recording){key, graph};
    }
    b->row->replay(b->device, b->recordings[k].graph);
}

void cuda_forget(struct backend *b)
{
    for (size_t k = 0; k < b->recorded; k++)
        b->row->forget(b->device, b->recordings[k].graph);
    b->recorded = 0;
}

void cuda_flush(struct backend *b)
{
    for (size_t first = 0, length; first < b->queued; first += length) {
        length = unit_length(b, first);
        run_unit(b, first, length);
    }
    b->queued = 0;
}

static void push(struct backend *b, struct queued q)
{
    if (b->queued == QUEUE_MAX)
        cuda_flush(b);
    b->queue[b->queued++] = q;
    if (q.pass < PASS_COUNT && (!q.looping || b->timed)) /* timed, a sweep is known to go on */
        count_pass(b, q.pass, 1);
}

/* With `timed` each pass is waited for, so that its seconds are its own. */
static enum status run_timed(struct backend *b, enum pass_id pass, struct error *e)
{
    double start = clock_seconds();
    cuda_flush(b);
    if (b->row->wait(b->device, e))
        return e->status;
    b->counts.seconds[pass] += clock_seconds() - start;
    return STATUS_OK;
}

enum status cuda_queue(struct backend *b, enum pass_id pass, const struct step *step,
                       struct error *e)
{
    struct scalars *in = &b->in[0];
    const float now[3] = {step->dt, step->before, step->resume};
    if (memcmp(&in->dt, now, sizeof now) != 0) { /* dt, before, resume lie side by side */
        memcpy(&in->dt, now, sizeof now);
        push(b, (struct queued){.pass = PASS_COUNT});
    }
    if (begins_loop(pass)) {
        b->in[1 + step->solve].loop = step->loop;
        b->swept = 0;
        memset(b->sweeps, 0, sizeof b->sweeps);
    }
    b->sweeps[pass] = step->looping;
    push(b, (struct queued){pass, step->solve, step->looping});
    return b->timed ? run_timed(b, pass, e) : STATUS_OK;
}

/* Sweeps that were queued, but found the solve ended, count for nothing. */
static void count_sweeps(struct backend *b, const struct loop *loop)
{
    int done = loop->again ? loop->sweeps - 1 : loop->sweeps;
    for (int pass = 0; pass < PASS_COUNT; pass++)
        if (b->sweeps[pass])
            count_pass(b, (enum pass_id)pass, done - b->swept);
    b->swept = done;
}

enum status cuda_settle(struct backend *b, struct step *step, struct error *e)
{
    cuda_flush(b);
    if (b->row->read(b->device, b->out, b->scalars, sizeof *b->out, e))
        return e->status;
    scalars_get(b->out, step);
    if (step->looping && !b->timed)
        count_sweeps(b, &b->out->loop);
    return STATUS_OK;
}
