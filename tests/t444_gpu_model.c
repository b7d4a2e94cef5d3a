/* The .cu files themselves, on a model of a GPU (tests/gpu_model): warps and blocks that meet, atomics, streams that
 * put off what they are asked, graphs. States have the bits of the cpu back end, pictures those of the cpu
 * renderer, in whatever order blocks and threads come. */
#include "backend/cuda/cuda.h"
#include "gpu_model/gpu_model.h"
#include "render/cuda/canvas_device.h"
#include "render/cuda/draw_kernels.h"
#include "render_fixture.h"
#include "run/simulation.h"
#include "scene/load.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SETS_MAX = 4 };

struct test_case {
    const char *name, *path;
    long steps;
    const char *sets[SETS_MAX];
};

/* Every kind of stage, sum and pair, and walls. */
static const struct test_case cases[] = {
    {"two fluids", "tests/scenes/two-fluids.json", 4, {0}},
    {"wall particles, shifting", "tests/scenes/wall-particles.json", 4, {"solver.shifting=on"}},
    {"diffusion by gradients", "tests/scenes/dam.json", 4, {"solver.diffusion_form=antuono"}},
    {"muller", "scenes/muller-splash.json", 4, {"particles.spacing=0.08"}},
    {"dfsph", "scenes/dambreak.json", 3, {"solver={\"method\": \"dfsph\"}", "particles.spacing=0.1"}},
    {"dfsph, thick", "tests/scenes/honey.json", 3, {0}},
    {"isph", "scenes/dambreak.json", 3, {"particles.spacing=0.1"}},
    {"isph, wall particles", "tests/scenes/projection-wall-particles.json", 2, {0}},
    {"isph, obstacles", "tests/scenes/obstacles.json", 2, {"particles.spacing=0.035"}},
    {"isph, two fluids, enclosed", "tests/scenes/drop-in-fluid.json", 2, {0}},
};
enum { CASES = sizeof cases / sizeof *cases };

static enum status open_model(struct backend **out, const struct backend_setup *setup,
                              struct particles *particles, struct particles *walls, struct error *e)
{
    return cuda_open_on(&device_cuda, kernels_cuda, out, setup, particles, walls, e);
}

struct outcome {
    uint64_t hash;
    long steps, sorts, sweeps[SOLVE_COUNT];
    double pairs, time;
};

/* block: threads of a block of sums over neighbours. */
static struct outcome run(const struct test_case *c, const struct backend_row *row, unsigned block)
{
    struct run_options options = {.backend = "cpu", .isa = "auto", .threads = 1};
    struct scene_overrides set = {.items = c->sets};
    struct scene *scene;
    struct plan plan;
    struct simulation s;
    struct outcome out;
    struct error e = {0};
    memset(&out, 0, sizeof out);
    while (set.count < SETS_MAX && c->sets[set.count])
        set.count++;
    if (scene_load(&scene, c->path, &set, &run_vocabulary, &e) || plan_make(&plan, scene, &options, &e))
        fail_msg("%s: %s", c->name, e.text);
    plan.backend = row;
    plan.block = block;
    if (simulation_open(&s, &plan, &options, &e))
        fail_msg("%s: %s", c->name, e.text);
    for (long k = 0; k < c->steps; k++)
        if (simulation_step(&s, INFINITY, &e))
            fail_msg("%s: %s", c->name, e.text);
    if (row->hash(s.backend, &out.hash, &e))
        fail_msg("%s: %s", c->name, e.text);
    out.steps = s.stats.steps;
    out.sorts = s.stats.sorts;
    for (int k = 0; k < SOLVE_COUNT; k++)
        out.sweeps[k] = s.stats.solves[k].sweeps;
    out.pairs = row->counts(s.backend)->pairs;
    out.time = s.time;
    simulation_close(&s);
    plan_free(&plan);
    scene_free(scene);
    return out;
}

static void same_bits_in_any_order(void **state)
{
    static const unsigned blocks[] = {0, 32, 160, 512};
    struct backend_row row = backend_cuda_host;
    (void)state;
    row.device = &device_cuda;
    row.open = open_model;
    for (size_t k = 0; k < CASES; k++) {
        const struct outcome cpu = run(&cases[k], &backend_cpu, 0);
        gpu_model_order((enum gpu_model_order)(k % 3));
        const struct outcome gpu = run(&cases[k], &row, blocks[k % 4]);
        if (memcmp(&cpu, &gpu, sizeof cpu) != 0)
            fail_msg("%s: %ld steps, %g pairs; on the model %ld, %g, state %s", cases[k].name, cpu.steps,
                     cpu.pairs, gpu.steps, gpu.pairs, cpu.hash == gpu.hash ? "the same" : "another");
        assert_int_equal(gpu_model_counts().device_bytes, 0);
    }
    struct gpu_model_counts counts = gpu_model_counts();
    printf("# %ld kernels, %ld of them in graphs; warps met %ld times, blocks %ld times (counted by threads)\n",
           counts.kernels, counts.in_graphs, counts.warps, counts.blocks);
    assert_true(counts.in_graphs > 500 && counts.warps > 1000 && counts.blocks > 1000);
}

static enum status canvas_open_model(void **canvas, const struct canvas_row *row,
                                     const struct render_setup *setup, struct error *e)
{
    (void)row;
    return canvas_device_open(canvas, &device_cuda, draw_kernels_cuda, setup, e);
}

static const struct canvas_row on_model = {.variant = {.name = "cuda"}, .open = canvas_open_model,
                                           .draw = canvas_device_draw, .name = canvas_device_name,
                                           .close = canvas_device_close};

static void draw(const struct canvas_row *row, const struct render_setup *setup,
                 const struct render_frame *frame, struct image *image)
{
    const struct scene *scene = setup->scene;
    struct camera camera;
    struct error e = {0};
    void *canvas;
    camera_make(&camera, scene, setup->radius, 0);
    if (row->open(&canvas, row, setup, &e) ||
        image_create(image, scene->movie.size[0], scene->movie.size[1], &e) ||
        row->draw(canvas, &camera, frame, image, &e))
        fail_msg("%s", e.text);
    row->close(canvas);
}

static void same_pictures(void **state)
{
    struct fixture_cloud cloud = fixture_cloud(3000, 7);
    const struct render_frame frame = {.count = cloud.count, .position = cloud.position, .value = cloud.value};
    struct scene scene;
    (void)state;
    fixture_scene(&scene, 97, 61);
    scene.render.box = BOX_FACES;
    for (int order = 0; order < 3; order++) {
        struct image cpu = {0}, gpu = {0};
        struct render_setup setup = fixture_setup(&scene, "cpu");
        setup.radius = 0.012;
        gpu_model_order((enum gpu_model_order)order);
        draw(&canvas_cpu, &setup, &frame, &cpu);
        draw(&on_model, &setup, &frame, &gpu);
        assert_memory_equal(cpu.rgba, gpu.rgba, 97 * 61 * 4);
        assert_int_equal(gpu_model_counts().device_bytes, 0);
        image_free(&cpu);
        image_free(&gpu);
    }
    fixture_cloud_free(&cloud);
}

/* A device copies what is in a queue of its own only when it is told to wait for it. */
static void queues_wait_for_events(void **state)
{
    enum { COUNT = 1000 };
    struct error e = {0};
    struct device *one, *other;
    (void)state;
    assert_int_equal(device_cuda.open(&one, 0, &e) || device_cuda.open(&other, 0, &e), 0);
    uint32_t *host = device_cuda.pin(one, COUNT * sizeof *host, &e), *back = calloc(COUNT, sizeof *back);
    uint32_t *there = device_cuda.create(one, "numbers", COUNT * sizeof *there, &e);
    struct device_event *event = device_cuda.event(one, &e);
    for (uint32_t i = 0; i < COUNT; i++)
        host[i] = i;
    device_cuda.upload(one, there, host, COUNT * sizeof *host);
    assert_int_equal(device_cuda.signal(one, event, &e), STATUS_OK);
    assert_int_equal(device_cuda.read(other, back, there, COUNT * sizeof *back, &e), STATUS_OK);
    assert_int_not_equal(back[COUNT - 1], COUNT - 1); /* too early */
    device_cuda.follow(other, event);
    assert_int_equal(device_cuda.read(other, back, there, COUNT * sizeof *back, &e), STATUS_OK);
    assert_memory_equal(back, host, COUNT * sizeof *back);
    device_cuda.drop(one, event);
    device_cuda.destroy(one, there);
    device_cuda.unpin(one, host);
    device_cuda.close(one);
    device_cuda.close(other);
    free(back);
    assert_int_equal(gpu_model_counts().device_bytes, 0);
}

/* What was queued and failed is known when an event is signalled, before anybody waits. */
static void events_tell_failures(void **state)
{
    struct error e = {0};
    struct device *d;
    uint32_t not_there[4];
    (void)state;
    assert_int_equal(device_cuda.open(&d, 0, &e), STATUS_OK);
    struct device_event *event = device_cuda.event(d, &e);
    assert_int_equal(device_cuda.signal(d, event, &e), STATUS_OK);
    device_cuda.clear(d, not_there, sizeof not_there);
    assert_int_equal(device_cuda.signal(d, event, &e), STATUS_RUN);
    assert_non_null(strstr(e.text, "the GPU failed in or before"));
    device_cuda.drop(d, event);
    device_cuda.close(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_bits_in_any_order),
        cmocka_unit_test(same_pictures),
        cmocka_unit_test(queues_wait_for_events),
        cmocka_unit_test(events_tell_failures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
