/* Frames that stay where they are computed: from the cuda back end, with the host as its device, into every
 * renderer, drawn there or copied; the pictures of the cpu back end, also from a device that works late. */
#include "backend/cuda/cuda.h"
#include "base/log.h"
#include "base/memory.h"
#include "late_device.h"
#include "picture.h"
#include "render/cuda/canvas_device.h"
#include "render/cuda/draw_kernels.h"
#include "render_fixture.h"
#include "run/frame.h"
#include "scene/load.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

enum { SETS_MAX = 8, FRAMES = 7, WIDTH = 160, HEIGHT = 90 };

#ifndef ON_MODEL /* t445 runs the same on a model of a GPU */
static const struct kernel *const kernels = kernels_host, *const draw_kernels = draw_kernels_host;
#define DEVICE device_host
#endif

static struct device_row device; /* what the back end and the renderers run on */

static enum status open_there(struct backend **out, const struct backend_setup *setup,
                              struct particles *particles, struct particles *walls, struct error *e)
{
    return cuda_open_on(&device, kernels, out, setup, particles, walls, e);
}

static enum status canvas_there(void **canvas, const struct canvas_row *row, const struct render_setup *setup,
                                struct error *e)
{
    (void)row;
    return canvas_device_open(canvas, &device, draw_kernels, setup, e);
}

static const struct canvas_row on_device = {
    .variant = {.name = "cuda"}, .open = canvas_there, .share = canvas_device_share,
    .draw = canvas_device_draw, .name = canvas_device_name, .close = canvas_device_close};

/* A film of some steps, and what differs from the usual. */
struct shot {
    const char *name;
    const char *sets[SETS_MAX];
    bool copied; /* the host has to see the frames */
    bool no_gl;  /* OpenGL does not draw it */
};

static const struct shot shots[] = {
    {.name = "speed"},
    {.name = "pressure, a log scale in steps",
     .sets = {"color.by=pressure", "color.scale=log", "color.steps=5", "color.range=[1, 3000]"}},
    {.name = "vorticity", .sets = {"color.by=vorticity"}},
    {.name = "where they began", .sets = {"color.by=start.x", "color.range=auto"}},
    {.name = "bodies", .sets = {"color.by=body", "color.range=auto"}},
    {.name = "walls, in the fluid's colour",
     .sets = {"color.by=solid", "render.boundary=true", "domain.walls.-y=particles"}},
    {.name = "cut, and some values",
     .sets = {"render.clip_max=[1.2, 1, 0.4]", "render.show_range=[0.02, 9]"}},
    {.name = "from inside", .sets = {"camera.eye=[0.5, 0.2, 0.3]", "camera.target=[0, 0.1, 0.3]"}},
    {.name = "percentiles", .copied = true,
     .sets = {"color.by=density", "color.range=auto", "color.percentiles=[2, 98]"}},
    {.name = "occlusion", .copied = true, .no_gl = true, .sets = {"render.occlusion=0.6"}},
    {.name = "shadow", .copied = true, .sets = {"render.shadow=0.5", "render.floor=plain"}},
};
enum { SHOTS = sizeof shots / sizeof *shots };

struct take {
    struct scene *scene;
    struct plan plan;
    struct render_setup render;
    struct film *film;
    struct simulation simulation;
    struct error error;
};

static void take_plan(struct take *t, const struct shot *shot, const struct backend_row *row)
{
    static const char *const outputs[] = {"x.png"};
    const char *sets[SETS_MAX + 2] = {"particles.spacing=0.08", "movie.size=[160, 90]"};
    struct run_options options = {.backend = "cpu", .outputs = outputs, .output_count = 1, .threads = 1};
    struct scene_overrides set = {.items = sets, .count = 2};
    for (size_t k = 0; k < SETS_MAX && shot->sets[k]; k++)
        sets[set.count++] = shot->sets[k];
    memset(t, 0, sizeof *t);
    if (scene_load(&t->scene, "scenes/dambreak.json", &set, &run_vocabulary, &t->error) ||
        plan_make(&t->plan, t->scene, &options, &t->error))
        fail_msg("%s: %s", shot->name, t->error.text);
    t->plan.backend = row;
    t->render = frame_setup(&t->plan, &options);
}

static enum status take_open(struct take *t, const char *pattern)
{
    const char *outputs[] = {in_directory(pattern)};
    struct film_setup setup = {.scene = t->scene, .render = &t->render, .outputs = outputs, .output_count = 1,
                               .frame_count = FRAMES, .source = frame_source(&t->plan, t->plan.backend)};
    struct run_options options = {.backend = "cpu", .threads = 1};
    setup.source.kernels = draw_kernels;
    setup.source.row = setup.source.row ? &device : NULL;
    if (film_open(&t->film, &setup, &t->error))
        return t->error.status;
    return simulation_open(&t->simulation, &t->plan, &options, &t->error);
}

/* After the last frame nothing makes a device that works late do it, but for who draws it. */
static enum status take_frames(struct take *t)
{
    for (long k = 0; k < FRAMES; k++) {
        struct film_snapshot *snapshot;
        if (simulation_advance(&t->simulation, (double)k * 0.02, &t->error) ||
            film_snapshot_create(t->film, frame_count(&t->plan), &snapshot, &t->error))
            return t->error.status;
        snapshot->index = k;
        snapshot->time = t->simulation.time;
        if (frame_fill(&t->simulation, snapshot, &t->error)) {
            film_snapshot_free(t->film, snapshot);
            return t->error.status;
        }
        if (film_frame(t->film, snapshot, &t->error))
            return t->error.status;
    }
    return STATUS_OK;
}

/* Everything but the plan. */
static enum status take_end(struct take *t, enum status status)
{
    struct error closing;
    if (film_close(t->film, !status, NULL, &closing) && !status) {
        t->error = closing;
        status = closing.status;
    }
    simulation_close(&t->simulation);
    t->film = NULL;
    return status;
}

static void take_free(struct take *t)
{
    plan_free(&t->plan);
    scene_free(t->scene);
}

static void take_all(const struct shot *shot, const struct backend_row *row, const char *renderer,
                     const struct canvas_row *canvas, const char *pattern)
{
    struct take t;
    take_plan(&t, shot, row);
    t.render.renderer = renderer;
    t.render.canvas = canvas;
    enum status status = take_open(&t, pattern);
    if (!status)
        status = take_frames(&t);
    if (take_end(&t, status))
        fail_msg("%s, %s: %s", shot->name, renderer, t.error.text);
    take_free(&t);
}

static void frame_read(struct image *image, const char *pattern, int k)
{
    char name[64];
    struct error e;
    snprintf(name, sizeof name, pattern, k);
    if (image_read_png(image, in_directory(name), &e))
        fail_msg("%s", e.text);
}

/* Pixels of all frames of two films that differ, and that are not the first pixel's. */
static size_t films_differ(const char *one, const char *other, size_t *drawn)
{
    size_t differ = 0;
    *drawn = 0;
    for (int k = 0; k < FRAMES; k++) {
        struct image a, b;
        frame_read(&a, one, k);
        frame_read(&b, other, k);
        for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
            *drawn += memcmp(a.rgba + 4 * i, a.rgba, 4) != 0;
            differ += memcmp(a.rgba + 4 * i, b.rgba + 4 * i, 4) != 0;
        }
        image_free(&a);
        image_free(&b);
    }
    return differ;
}

static size_t copied; /* bytes of one frame's positions, read by the host */
static enum status (*read_there)(struct device *d, void *host, const void *from, size_t bytes, struct error *e);

static enum status read_counted(struct device *d, void *host, const void *from, size_t bytes, struct error *e)
{
    copied = bytes > copied && bytes % 12 == 0 && bytes != WIDTH * HEIGHT * 4 ? bytes : copied;
    return read_there(d, host, from, bytes, e);
}

static struct backend_row there(struct device_row row)
{
    struct backend_row backend = backend_cuda_host;
    read_there = row.read;
    device = row;
    device.read = read_counted;
    backend.open = open_there;
    copied = 0;
    return backend;
}

/* Every film by both back ends; `shares`: the renderer draws where frames are, unless the host has to see them. */
static void compare_all(const char *renderer, const struct canvas_row *canvas, bool shares, struct device_row row)
{
    const char *reference = canvas ? "cpu" : renderer;
    for (size_t k = 0; k < SHOTS; k++) {
        size_t drawn, differ;
        if (shots[k].no_gl && variant_find(&render_table, renderer) &&
            ((const struct canvas_row *)variant_find(&render_table, renderer))->context)
            continue;
        const struct backend_row backend = there(row);
        take_all(&shots[k], &backend_cpu, reference, NULL, "here-%d.png");
        take_all(&shots[k], &backend, renderer, canvas, "there-%d.png");
        assert_int_equal(copied > 0, shots[k].copied || !shares);
        differ = films_differ("here-%d.png", "there-%d.png", &drawn);
        printf("# %s, %s: %zu pixels drawn, %zu differ\n", renderer, shots[k].name, drawn, differ);
        assert_true(drawn > FRAMES * 500);
        assert_int_equal(differ, 0);
    }
}

static void compare_on_devices(const char *renderer, const struct canvas_row *canvas, bool shares)
{
    compare_all(renderer, canvas, shares, DEVICE);
#ifndef ON_MODEL
    compare_all(renderer, canvas, shares, late_device());
#endif
}

static void copied_to_the_host(void **state)
{
    (void)state;
    compare_on_devices("cpu", NULL, false);
}

static void drawn_by_kernels(void **state)
{
    (void)state;
    compare_on_devices("cuda", &on_device, true);
}

/* Where there is no such OpenGL the test is skipped. */
static void gl_needed(const char *name)
{
    const struct canvas_row *row = (const struct canvas_row *)variant_find(&render_table, name);
    struct scene scene;
    struct error e = {.text = "not in this build"};
    void *canvas = NULL;
    fixture_scene(&scene, WIDTH, HEIGHT);
    const struct render_setup setup = fixture_setup(&scene, name);
    if (row->variant.missing || row->open(&canvas, row, &setup, &e)) {
        printf("# SKIP %s: %s\n", name, e.text);
        skip();
    }
    row->close(canvas);
}

static void gl_films(const char *name)
{
    gl_needed(name);
    compare_on_devices(name, NULL, true);
}

static void written_into_egl(void **state)
{
    (void)state;
    gl_films("egl");
}
#ifndef ON_MODEL
static void written_into_osmesa(void **state)
{
    (void)state;
    gl_films("osmesa");
}

static struct device_buffer *refused(struct device *d, const struct device_gl *gl, struct error *e)
{
    (void)d;
    (void)gl;
    error_set(e, STATUS_BACKEND, "another GPU draws");
    return NULL;
}

/* The host's copy does what OpenGL's buffer cannot. */
static void refused_is_copied(void **state)
{
    struct device_row row = device_host;
    (void)state;
    row.attach = refused;
    gl_needed("osmesa");
    compare_all("osmesa", NULL, false, row);
}

/* Calls that succeed before one fails; -1: all do. */
static int creates_left, maps_left, reads_left;

static bool fails(int *left)
{
    return *left >= 0 && (*left)-- == 0;
}
static void *failing_create(struct device *d, const char *label, size_t bytes, struct error *e)
{
    if (!fails(&creates_left))
        return device_host.create(d, label, bytes, e);
    error_set(e, STATUS_RUN, "no memory for %s", label);
    return NULL;
}
static void *failing_map(struct device *d, struct device_buffer *buffer, struct error *e)
{
    if (!fails(&maps_left))
        return device_host.map(d, buffer, e);
    error_set(e, STATUS_RUN, "not mapped");
    return NULL;
}
static enum status failing_read(struct device *d, void *host, const void *from, size_t bytes, struct error *e)
{
    if (!fails(&reads_left))
        return device_host.read(d, host, from, bytes, e);
    return error_set(e, STATUS_RUN, "the device is lost");
}

/* A film whose device fails somewhere: an error, not all files, nothing that stays allocated; or none and all. */
static enum status attempt(const char *renderer, const struct canvas_row *canvas)
{
    struct device_row row = device_host;
    row.create = failing_create, row.map = failing_map, row.read = failing_read;
    const struct backend_row backend = there(row);
    const size_t before = memory_now();
    struct take t;
    take_plan(&t, &shots[0], &backend);
    t.render.renderer = renderer;
    t.render.canvas = canvas;
    enum status status = take_open(&t, "film-%d.png");
    if (!status)
        status = take_frames(&t);
    status = take_end(&t, status);
    if (status && !strstr(t.error.text, "no memory for ") && !strstr(t.error.text, "not mapped") &&
        !strstr(t.error.text, "the device is lost"))
        fail_msg("%s", t.error.text);
    take_free(&t);
    assert_int_equal(memory_now(), before);
    assert_in_range(directory_count(), status ? 0 : FRAMES, status ? FRAMES - 1 : FRAMES);
    assert_int_equal(directory_remove(NULL) || directory_make(NULL), 0);
    return status;
}

static int attempts(int *left, const char *renderer, const struct canvas_row *canvas)
{
    int failed = 0, well = 0; /* well: in a row, as what fails may be replaced by the host */
    creates_left = maps_left = reads_left = -1;
    for (int before = 0; well < 3; before++) {
        *left = before;
        bool fails = attempt(renderer, canvas) != STATUS_OK;
        well = fails ? 0 : well + 1;
        failed += fails;
        assert_in_range(failed, 0, 300);
    }
    return failed;
}

static void short_memory_leaks_nothing(void **state)
{
    (void)state;
    assert_in_range(attempts(&creates_left, "cpu", NULL), 20, 100);
}
static void short_memory_of_kernels_leaks_nothing(void **state)
{
    (void)state;
    assert_in_range(attempts(&creates_left, "cuda", &on_device), 25, 100);
}
static void lost_buffers_are_errors(void **state)
{
    (void)state;
    gl_needed("osmesa");
    assert_int_equal(attempts(&maps_left, "osmesa", NULL), FRAMES);
}
static void lost_devices_are_errors(void **state)
{
    (void)state;
    assert_in_range(attempts(&reads_left, "cuda", &on_device), FRAMES, 300);
}

static enum status read_of_lost(struct device *d, void *host, const void *from, size_t bytes, struct error *e)
{
    if (reads_left == 0)
        return error_set(e, STATUS_RUN, "the device is lost");
    reads_left -= bytes == WIDTH * HEIGHT * 4;
    return device_host.read(d, host, from, bytes, e);
}

/* The frames that were drawn before are kept, whoever notices first, and the error is the device's. */
static void drawn_frames_are_kept(void **state)
{
    const size_t before = memory_now();
    (void)state;
    for (int drawn = 1; drawn < FRAMES; drawn++) {
        struct device_row row = device_host;
        struct take t;
        struct error e = {0};
        row.read = read_of_lost;
        const struct backend_row backend = there(row);
        reads_left = drawn;
        take_plan(&t, &shots[0], &backend);
        t.render.canvas = &on_device;
        enum status status = take_open(&t, "film-%d.png");
        status = status ? status : take_frames(&t);
        film_close(t.film, true, NULL, &e);
        simulation_close(&t.simulation);
        take_free(&t);
        assert_true(strstr(status ? t.error.text : e.text, "the device is lost"));
        assert_int_equal(directory_count(), drawn);
        assert_int_equal(directory_remove(NULL) || directory_make(NULL), 0);
        assert_int_equal(memory_now(), before);
    }
}

/* A film that is given up while frames wait. */
static void dropped(void **state)
{
    const struct backend_row backend = there(late_device());
    const size_t before = memory_now();
    struct take t;
    (void)state;
    take_plan(&t, &shots[0], &backend);
    t.render.renderer = "cpu";
    if (take_open(&t, "film-%d.png") || take_frames(&t))
        fail_msg("%s", t.error.text);
    assert_int_equal(take_end(&t, STATUS_RUN), STATUS_RUN);
    take_free(&t);
    assert_int_equal(memory_now(), before);
    assert_int_equal(directory_count(), 0);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(copied_to_the_host, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(drawn_by_kernels, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(written_into_egl, directory_make, directory_remove),
#ifndef ON_MODEL
        cmocka_unit_test_setup_teardown(written_into_osmesa, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(refused_is_copied, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(short_memory_leaks_nothing, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(short_memory_of_kernels_leaks_nothing, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(lost_buffers_are_errors, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(lost_devices_are_errors, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(drawn_frames_are_kept, directory_make, directory_remove),
        cmocka_unit_test_setup_teardown(dropped, directory_make, directory_remove),
#endif
    };
    log_set_level(LOG_ERROR);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
