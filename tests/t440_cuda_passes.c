/* Tests the cuda back end with the host as its device: its passes, graphs, sorting and rows end in the same
 * bits as the cpu's, work is counted alike, and memory that is short or a device that is lost is an error. */
#include "backend/cuda/cuda.h"
#include "base/memory.h"
#include "late_device.h"
#include "run/budget.h"
#include "run/simulation.h"
#include "run/step.h"
#include "scene/load.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SETS_MAX = 6, HASHES_MAX = 64, EVERY = 4 };

struct test_case {
    const char *name, *path;
    long steps;
    const char *sets[SETS_MAX];
};

static const struct test_case cases[] = {
    {"wcsph", "tests/scenes/dam.json", 120, {0}},
    {"diffusion by gradients", "tests/scenes/dam.json", 40, {"solver.diffusion_form=antuono"}},
    {"two fluids", "tests/scenes/two-fluids.json", 40, {0}},
    {"pressure midway", "tests/scenes/two-fluids.json", 40, {"solver.pressure_form=average"}},
    {"wall particles", "tests/scenes/wall-particles.json", 40, {0}},
    {"shifting between wall particles", "tests/scenes/wall-particles.json", 40,
     {"solver.shifting=on"}},
    {"periodic", "tests/scenes/periodic.json", 40, {0}},
    {"shifting", "tests/scenes/taylor-green.json", 30, {0}},
    {"muller", "scenes/muller-splash.json", 60, {"particles.spacing=0.08"}},
    {"dfsph", "scenes/dambreak.json", 40, {"solver={\"method\": \"dfsph\"}", "particles.spacing=0.07"}},
    {"dfsph, enclosed", "tests/scenes/projection-vortices.json", 20,
     {"solver={\"method\": \"dfsph\"}"}},
    {"dfsph, thick", "tests/scenes/honey.json", 20, {0}},
    {"dfsph, thick, Laplacian", "tests/scenes/honey.json", 20, {"solver.viscosity_form=morris"}},
    {"isph", "scenes/dambreak.json", 60, {"particles.spacing=0.06"}},
    {"isph, enclosed", "tests/scenes/projection-vortices.json", 30, {0}},
    {"isph, two fluids", "tests/scenes/projection-two-fluids.json", 30, {0}},
    {"isph, wall particles", "tests/scenes/projection-wall-particles.json", 20, {0}},
    {"isph, thick", "tests/scenes/honey.json", 20, {"solver={\"method\": \"isph\"}"}},
    {"isph, surface tension between fluids", "tests/scenes/drop-in-fluid.json", 10, {0}},
    {"isph, obstacles", "tests/scenes/obstacles.json", 40, {"particles.spacing=0.035"}},
    {"wcsph, obstacles", "tests/scenes/obstacles.json", 40,
     {"solver={\"method\": \"wcsph\"}", "particles.spacing=0.035"}},
    {"dfsph, obstacles", "tests/scenes/obstacles.json", 20,
     {"solver={\"method\": \"dfsph\"}", "particles.spacing=0.035"}},
    {"muller, obstacles", "tests/scenes/obstacles.json", 40,
     {"solver={\"method\": \"muller\"}", "particles.spacing=0.035"}},
    {"all pairs", "tests/scenes/dam.json", 20, {"neighbours=all-pairs"}},
};
enum { CASES = sizeof cases / sizeof *cases };

struct outcome {
    uint64_t hash[HASHES_MAX];
    size_t hashes;
    long steps, rejected, sorts, sweeps[SOLVE_COUNT], runs[PASS_COUNT];
    double pairs, row_entries, time;
};

struct attempt {
    struct scene *scene;
    struct plan plan;
    struct simulation simulation;
    struct error error;
};

static enum status attempt_open(struct attempt *t, const struct test_case *c,
                              const struct backend_row *row)
{
    struct run_options options = {.backend = "cpu", .isa = "auto", .threads = 1};
    struct scene_overrides set = {.items = c->sets};
    memset(t, 0, sizeof *t);
    while (set.count < SETS_MAX && c->sets[set.count])
        set.count++;
    if (scene_load(&t->scene, c->path, &set, &run_vocabulary, &t->error) ||
        plan_make(&t->plan, t->scene, &options, &t->error))
        fail_msg("%s: %s", c->name, t->error.text);
    t->plan.backend = row;
    return simulation_open(&t->simulation, &t->plan, &options, &t->error);
}

static void attempt_close(struct attempt *t)
{
    simulation_close(&t->simulation);
    plan_free(&t->plan);
    scene_free(t->scene);
}

static enum status advance(struct attempt *t, long steps, struct outcome *out)
{
    struct simulation *s = &t->simulation;
    for (long k = 0; k < steps; k++) {
        if (simulation_step(s, INFINITY, &t->error))
            return t->error.status;
        const struct particles *p = s->row->state(s->backend, PARTICLES_HASHED, &t->error);
        if (!p)
            return t->error.status;
        if (k % EVERY == EVERY - 1)
            out->hash[out->hashes++] = particles_hash(p);
    }
    return STATUS_OK;
}

static struct outcome run(const struct test_case *c, const struct backend_row *row)
{
    struct attempt t;
    struct outcome out;
    memset(&out, 0, sizeof out);
    if (attempt_open(&t, c, row) || advance(&t, c->steps, &out))
        fail_msg("%s on %s: %s", c->name, row->variant.name, t.error.text);
    const struct simulation *s = &t.simulation;
    const struct backend_counts *counts = row->counts(s->backend);
    out.steps = s->stats.steps;
    out.rejected = s->stats.rejected;
    out.sorts = s->stats.sorts;
    for (int k = 0; k < SOLVE_COUNT; k++)
        out.sweeps[k] = s->stats.solves[k].sweeps;
    memcpy(out.runs, counts->runs, sizeof out.runs);
    out.pairs = counts->pairs;
    out.row_entries = counts->row_entries;
    out.time = s->time;
    attempt_close(&t);
    return out;
}

static void same_bits(void **state)
{
    (void)state;
    for (size_t k = 0; k < CASES; k++) {
        const struct test_case *c = &cases[k];
        struct outcome cpu = run(c, &backend_cpu), device = run(c, &backend_cuda_host);
        assert_true(cpu.hashes >= 2 && cpu.hash[0] != cpu.hash[cpu.hashes - 1]);
        for (size_t n = 0; n < cpu.hashes; n++)
            if (cpu.hash[n] != device.hash[n])
                fail_msg("%s: states differ after %zu steps", c->name, (n + 1) * EVERY);
        if (memcmp(&cpu, &device, sizeof cpu) != 0)
            fail_msg("%s: work is counted otherwise: %ld and %ld steps, %ld and %ld rejected, %g "
                     "and %g pairs", c->name, cpu.steps, device.steps, cpu.rejected, device.rejected,
                     cpu.pairs, device.pairs);
    }
}

/* A device that puts everything off ends in the same bits. */
static struct device_row late;

static enum status open_late(struct backend **out, const struct backend_setup *setup,
                             struct particles *particles, struct particles *walls, struct error *e)
{
    return cuda_open_on(&late, kernels_host, out, setup, particles, walls, e);
}

static void late_same_bits(void **state)
{
    struct backend_row row = backend_cuda_host;
    (void)state;
    late = late_device();
    late_deepest = 0;
    row.open = open_late;
    for (size_t k = 0; k < CASES; k += k == 0 ? 4 : 3) {
        struct outcome host = run(&cases[k], &backend_cuda_host), outcome = run(&cases[k], &row);
        if (memcmp(&host, &outcome, sizeof host) != 0)
            fail_msg("%s: a device that works late ends otherwise", cases[k].name);
    }
    assert_true(late_deepest > 10);
}

/* A device like the host, but for what fails. */
static struct device_row faulty;
static struct backend_row faulty_row;
static int creates_left, reads_left;

static enum status faulty_open(struct backend **out, const struct backend_setup *setup,
                               struct particles *particles, struct particles *walls, struct error *e)
{
    return cuda_open_on(&faulty, kernels_host, out, setup, particles, walls, e);
}

static void faulty_make(void)
{
    faulty = device_host;
    faulty_row = backend_cuda_host;
    faulty_row.open = faulty_open;
    creates_left = reads_left = 1000000;
}

static enum status little_memory(int index, struct device_info *info, struct error *e)
{
    (void)e;
    (void)index;
    *info = (struct device_info){.name = "a small GPU", .memory = 1 << 20, .free = 1 << 18};
    return STATUS_OK;
}

static void memory_is_predicted(void **state)
{
    struct attempt t;
    (void)state;
    faulty_make();
    faulty.info = little_memory;
    assert_int_equal(attempt_open(&t, &cases[0], &faulty_row), STATUS_RUN);
    assert_non_null(strstr(t.error.text, "on a small GPU, of which 0.0002307 GB can be had"));
    assert_non_null(strstr(t.error.text, "particles.spacing"));
    attempt_close(&t);
}

static double small_memory(int device, char name[64], struct error *e)
{
    (void)device;
    (void)e;
    strcpy(name, "a small GPU");
    return 1 << 16;
}

/* Before any particle is made, when the device was asked for. */
static void memory_is_planned(void **state)
{
    struct attempt t;
    (void)state;
    faulty_make();
    faulty_row.memory = small_memory;
    if (attempt_open(&t, &cases[13], &backend_cpu))
        fail_msg("%s", t.error.text);
    t.plan.backend = &faulty_row;
    assert_int_equal(budget_check(&t.plan, true, &t.error), STATUS_RUN);
    assert_non_null(strstr(t.error.text, "of a small GPU, but 6.554e-05 GB are free there"));
    attempt_close(&t);
}

static void *failing_create(struct device *d, const char *label, size_t bytes, struct error *e)
{
    if (creates_left-- > 0)
        return device_host.create(d, label, bytes, e);
    error_set(e, STATUS_RUN, "no memory for %s", label);
    return NULL;
}

/* Whichever array does not fit: an error, and nothing stays allocated. */
static void short_memory_leaks_nothing(void **state)
{
    const struct test_case *c = &cases[4]; /* with wall particles */
    (void)state;
    faulty_make();
    faulty.create = failing_create;
    enum status status = STATUS_RUN;
    int creates = 0;
    for (; status && creates < 200; creates++) {
        struct attempt t;
        size_t before = memory_now();
        creates_left = creates;
        status = attempt_open(&t, c, &faulty_row);
        assert_true(status == STATUS_OK || status == STATUS_RUN);
        if (status)
            assert_non_null(strstr(t.error.text, "no memory for "));
        attempt_close(&t);
        assert_int_equal(memory_now(), before);
    }
    assert_true(creates > 30 && creates < 200);
}

static enum status failing_read(struct device *d, void *host, const void *from, size_t bytes,
                                struct error *e)
{
    if (reads_left-- > 0)
        return device_host.read(d, host, from, bytes, e);
    return error_set(e, STATUS_RUN, "the device is lost");
}

static void lost_device_is_an_error(void **state)
{
    (void)state;
    for (int reads = 0; reads < 40; reads += 3) {
        struct attempt t;
        struct outcome out;
        memset(&out, 0, sizeof out);
        size_t before = memory_now();
        faulty_make();
        faulty.read = failing_read;
        reads_left = reads;
        enum status status = attempt_open(&t, &cases[13], &faulty_row);
        if (!status)
            status = advance(&t, 40, &out);
        assert_int_equal(status, STATUS_RUN);
        assert_non_null(strstr(t.error.text, "the device is lost"));
        attempt_close(&t);
        assert_int_equal(memory_now(), before);
    }
}

static struct device_graph *not_recorded(struct device *d)
{
    device_host.forget(d, device_host.recorded(d));
    return NULL;
}

/* A device that cannot record graphs runs passes one by one. */
static void graphs_are_optional(void **state)
{
    (void)state;
    faulty_make();
    faulty.recorded = not_recorded;
    for (size_t k = 9; k < 14; k += 4) {
        struct outcome with = run(&cases[k], &backend_cuda_host), without = run(&cases[k], &faulty_row);
        assert_memory_equal(&with, &without, sizeof with);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_bits),
        cmocka_unit_test(late_same_bits),
        cmocka_unit_test(memory_is_predicted),
        cmocka_unit_test(memory_is_planned),
        cmocka_unit_test(short_memory_leaks_nothing),
        cmocka_unit_test(lost_device_is_an_error),
        cmocka_unit_test(graphs_are_optional),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
