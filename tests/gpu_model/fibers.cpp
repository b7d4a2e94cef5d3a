/* The model of a GPU: threads of a block as fibers that meet (see cuda_runtime.h). */
#include "model.h"
#include "races.h"

#include <memory>
#include <setjmp.h>
#include <ucontext.h>
#include <vector>

dim3 threadIdx, blockIdx, blockDim, gridDim;
struct gpu_model_counts model_counts;
bool model_in_graph;

static enum gpu_model_order order_wanted = GPU_MODEL_FORWARD;

extern "C" void gpu_model_order(enum gpu_model_order order)
{
    order_wanted = order;
}

[[noreturn]] static void model_fail(const char *what)
{
    fprintf(stderr, "# model of a GPU: block %u, thread %u: %s\n", blockIdx.x, threadIdx.x, what);
    abort();
}

enum { STACK = 128 << 10, LANES = 32 };
enum fiber_state { READY, AT_WARP, AT_BLOCK, ENDED };

/* Made once, and used for thread after thread; jumps need no call of the kernel, as ucontext's switches do. */
struct fiber {
    ucontext_t context; /* of its first time */
    std::unique_ptr<char[]> stack;
    jmp_buf place;      /* where it left */
    void *races;        /* ThreadSanitizer's */
    fiber_state state;
    unsigned meetings;  /* of its warp */
    uint64_t value[2];  /* that it brought to the last two */
};

static fiber fibers[1024];
static size_t fiber_count;
static jmp_buf scheduler;
static const std::function<void()> *body;

static void fiber_leave(fiber_state state)
{
    const dim3 own = threadIdx;
    fibers[own.x].state = state;
    if (_setjmp(fibers[own.x].place) == 0) {
        races_switch_back();
        _longjmp(scheduler, 1);
    }
    threadIdx = own;
}

static void fiber_main()
{
    for (;;) {
        races_thread_begin();
        (*body)();
        races_thread_end();
        fiber_leave(ENDED);
    }
}

static void fiber_enter(fiber *f)
{
    if (_setjmp(scheduler) != 0)
        return;
    if (f->stack) {
        races_switch(f->races);
        _longjmp(f->place, 1);
    }
    f->stack.reset(new char[STACK]);
    f->races = races_fiber();
    getcontext(&f->context);
    f->context.uc_stack.ss_sp = f->stack.get();
    f->context.uc_stack.ss_size = STACK;
    f->context.uc_link = NULL;
    makecontext(&f->context, fiber_main, 0);
    races_switch(f->races);
    setcontext(&f->context);
}

void model_block_meet()
{
    model_counts.blocks++;
    races_come();
    fiber_leave(AT_BLOCK);
    races_go();
}

void model_warp_exchange(unsigned mask, const void *own, size_t bytes, uint64_t all[LANES])
{
    const size_t first = threadIdx.x / LANES * LANES;
    fiber *f = &fibers[threadIdx.x];
    const unsigned turn = f->meetings++ % 2;
    if (mask != ~0u || first + LANES > fiber_count)
        model_fail("a warp meets, but not all of its lanes are asked");
    model_counts.warps++;
    f->value[turn] = 0;
    memcpy(&f->value[turn], own, bytes);
    fiber_leave(AT_WARP);
    for (size_t lane = 0; lane < LANES; lane++)
        all[lane] = fibers[first + lane].value[turn];
}

/* Lets go the fibers first .. end - 1 when all that are not ended have come to the same meeting. */
static bool release(size_t first, size_t end, fiber_state meeting)
{
    size_t there = 0, ended = 0;
    for (size_t k = first; k < end; k++) {
        there += fibers[k].state == meeting;
        ended += fibers[k].state == ENDED;
    }
    if (there == 0 || there + ended < end - first)
        return false;
    if (ended)
        model_fail("threads meet that others of the same warp or block have missed");
    for (size_t k = first; k < end; k++)
        fibers[k].state = READY;
    return true;
}

/* Numbers 0 .. count - 1 in the order that is wanted. */
static std::vector<unsigned> order_of(unsigned count)
{
    static uint64_t random = 1;
    std::vector<unsigned> order(count);
    for (unsigned k = 0; k < count; k++)
        order[k] = order_wanted == GPU_MODEL_BACKWARD ? count - 1 - k : k;
    for (unsigned k = count; order_wanted == GPU_MODEL_SHUFFLED && k > 1; k--) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        std::swap(order[k - 1], order[(random >> 33) % k]);
    }
    return order;
}

/* Runs the threads first .. end - 1 of a warp until each has ended or waits for the block. */
static bool warp_run(size_t first, size_t end)
{
    const std::vector<unsigned> order = order_of((unsigned)(end - first));
    bool any = false, going = true;
    while (going) {
        going = false;
        for (unsigned k : order)
            if (fibers[first + k].state == READY) {
                going = any = true;
                threadIdx = dim3((unsigned)first + k, 0, 0);
                fiber_enter(&fibers[first + k]);
            }
        going = release(first, end, AT_WARP) || going;
    }
    return any;
}

/* One warp after the other, each as far as it gets: nothing but what the code asks for keeps them together. */
static void block_run(unsigned threads)
{
    const std::vector<unsigned> order = order_of((threads + LANES - 1) / LANES);
    bool going = true;
    races_block_begin();
    for (size_t k = 0; k < threads; k++) {
        fibers[k].state = READY;
        fibers[k].meetings = 0;
    }
    while (going) {
        going = false;
        for (unsigned warp : order) {
            const size_t first = (size_t)warp * LANES;
            going = warp_run(first, first + LANES < threads ? first + LANES : threads) || going;
        }
        going = release(0, threads, AT_BLOCK) || going;
    }
    for (size_t k = 0; k < threads; k++)
        if (fibers[k].state != ENDED)
            model_fail("threads wait for each other for ever");
}

void model_launch(dim3 grid, dim3 block, const std::function<void()> &thread)
{
    MODEL_LOCK;
    model_counts.kernels++;
    model_lose();
    if (model_lost)
        return;
    model_counts.in_graphs += model_in_graph;
    fiber_count = block.x;
    body = &thread;
    gridDim = grid;
    blockDim = block;
    races_kernel_begin();
    for (unsigned b : order_of(grid.x)) {
        blockIdx = dim3(b, 0, 0);
        block_run(block.x);
    }
    races_kernel_end();
}
