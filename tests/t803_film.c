/* The film pipeline: order, bounds, and errors from its threads. The renderer is a stand-in. */
#include "base/log.h"
#include "base/memory.h"
#include "picture.h"
#include "run/film.h"
#include "scene/scene.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <time.h>

struct renderer {
    pthread_t owner;
};

static struct {
    int opened, closed, drawn, sleep_ms;
    bool fail_open, wrong_thread;
    long fail_at;   /* frame index; -1: none */
} fake;

static void nap(int ms)
{
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000L}, NULL);
}

enum status renderer_open(struct renderer **made, const struct render_setup *setup,
                          struct error *e)
{
    (void)setup;
    if (fake.fail_open)
        return error_set(e, STATUS_BACKEND, "no context");
    fake.opened++;
    *made = malloc(sizeof **made);
    (*made)->owner = pthread_self();
    return STATUS_OK;
}

enum status renderer_slots(struct renderer *renderer, const struct render_source *source,
                           struct render_slot **slots, struct error *e)
{
    (void)renderer;
    (void)source;
    *slots = NULL;
    return error_set(e, STATUS_BACKEND, "there is no device");
}

const char *renderer_name(const struct renderer *renderer)
{
    (void)renderer;
    return "fake (none)";
}

/* The first pixel tells the frame; a value and a colour are copied to show that they came. */
enum status renderer_draw(struct renderer *renderer, const struct render_frame *frame,
                          struct image *image, struct error *e)
{
    fake.wrong_thread |= !pthread_equal(renderer->owner, pthread_self());
    fake.drawn++;
    nap(fake.sleep_ms);
    if (frame->index == fake.fail_at)
        return error_set(e, STATUS_BACKEND, "lost the context at frame %ld", frame->index);
    memset(image->rgba, 0, (size_t)image->width * (size_t)image->height * 4);
    image->rgba[0] = (uint8_t)frame->index;
    image->rgba[1] = (uint8_t)frame->position[3 * frame->count - 1];
    image->rgba[2] = frame->value ? (uint8_t)frame->value[frame->count - 1]
                                  : frame->color[4 * frame->count - 4];
    image->rgba[3] = 255;
    return STATUS_OK;
}

void renderer_close(struct renderer *renderer)
{
    fake.wrong_thread |= !pthread_equal(renderer->owner, pthread_self());
    fake.closed++;
    free(renderer);
}

static struct scene scene;
static struct render_setup render;

static int film_setup_test(void **state)
{
    memset(&fake, 0, sizeof fake);
    memset(&render, 0, sizeof render);
    fake.fail_at = -1;
    scene.movie.size[0] = 64;
    scene.movie.size[1] = 48;
    scene.movie.fps = 30;
    strcpy(scene.title, "test");
    render.scene = &scene;
    log_set_level(LOG_ERROR);
    return directory_make(state);
}

/* Nothing may be held after a test: neither memory nor a renderer. */
static int film_teardown_test(void **state)
{
    if (memory_now() || fake.opened != fake.closed || fake.wrong_thread)
        return -1;
    return directory_remove(state);
}

/* A film of `count` frames of a growing number of particles, to `outputs` (NULL-terminated). */
static enum status run_film(const char *const *outputs, long count, bool keep,
                            struct film_times *times, struct error *e)
{
    struct film_setup setup = {.scene = &scene, .render = &render, .outputs = outputs};
    struct film *film;
    struct error closing;
    while (outputs[setup.output_count])
        setup.output_count++;
    enum status status = film_open(&film, &setup, e);
    for (long i = 0; !status && i < count; i++) {
        struct film_snapshot *snapshot;
        size_t particles = 10 + (size_t)i;
        status = film_snapshot_create(film, particles, &snapshot, e);
        if (status)
            break;
        snapshot->index = i;
        snapshot->time = (double)i / 30;
        snapshot->state_hash = 1;
        if (snapshot->position)
            snapshot->position[3 * particles - 1] = (float)(i + 1);
        if (snapshot->value)
            snapshot->value[particles - 1] = (float)(i + 2);
        if (snapshot->color)
            snapshot->color[4 * particles - 4] = (uint8_t)(i + 3);
        status = film_frame(film, snapshot, e);
    }
    if (film_close(film, keep && !status, times, &closing) && !status) {
        *e = closing;
        status = e->status;
    }
    return status;
}

static void check_frames(const char *format, long count, int third)
{
    struct error e;
    struct image image;
    for (long i = 0; i < count; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s%ld.png", format, i);
        assert_int_equal(image_read_png(&image, in_directory(name), &e), STATUS_OK);
        assert_int_equal(image.rgba[0], i);
        assert_int_equal(image.rgba[1], i + 1);
        assert_int_equal(image.rgba[2], i + third);
        image_free(&image);
    }
}

static void frames_keep_their_order(void **state)
{
    char pattern[300], second[300];
    struct error e;
    struct film_times times;
    (void)state;
    snprintf(pattern, sizeof pattern, "%s", in_directory("f%d.png"));
    snprintf(second, sizeof second, "%s", in_directory("g%d.png"));
    const char *const outputs[] = {pattern, second, "null", NULL};
    assert_int_equal(run_film(outputs, 30, true, &times, &e), STATUS_OK);
    check_frames("f", 30, 2);
    check_frames("g", 30, 2);
    assert_int_equal(directory_count(), 60);
    assert_int_equal(fake.drawn, 30);
    assert_true(times.encode > 0);
}

static void solid_colours_travel(void **state)
{
    char pattern[300];
    struct error e;
    (void)state;
    render.solid = true;
    snprintf(pattern, sizeof pattern, "%s", in_directory("f%d.png"));
    const char *const outputs[] = {pattern, NULL};
    assert_int_equal(run_film(outputs, 5, true, NULL, &e), STATUS_OK);
    check_frames("f", 5, 3);
}

static void without_pixels_nothing_is_opened(void **state)
{
    const char *const outputs[] = {"null", NULL};
    struct film_setup setup = {.scene = &scene, .outputs = outputs, .output_count = 1};
    struct film_snapshot *snapshot;
    struct film *film;
    struct error e;
    (void)state;
    assert_false(film_wants_pixels(outputs, 1));
    assert_int_equal(film_open(&film, &setup, &e), STATUS_OK);
    assert_null(film_renderer(film));
    size_t before = memory_now();
    assert_int_equal(film_snapshot_create(film, 1000000, &snapshot, &e), STATUS_OK);
    assert_null(snapshot->position);
    assert_int_equal(memory_now(), before);
    assert_int_equal(film_frame(film, snapshot, &e), STATUS_OK);
    assert_int_equal(film_close(film, true, NULL, &e), STATUS_OK);
    assert_int_equal(fake.opened, 0);
}

static void slow_drawing_bounds_memory(void **state)
{
    char pattern[300];
    struct error e;
    struct film_times times;
    (void)state;
    fake.sleep_ms = 10;
    snprintf(pattern, sizeof pattern, "%s", in_directory("f%d.png"));
    const char *const outputs[] = {pattern, NULL};
    assert_int_equal(run_film(outputs, 20, true, &times, &e), STATUS_OK);
    assert_true(times.wait > 0.1);
    assert_true(times.draw > 0.18);
    check_frames("f", 20, 2);
}

static void renderer_that_does_not_open(void **state)
{
    char film[300];
    struct error e;
    (void)state;
    fake.fail_open = true;
    snprintf(film, sizeof film, "%s", in_directory("f%d.png"));
    const char *const outputs[] = {film, NULL};
    assert_int_equal(run_film(outputs, 5, true, NULL, &e), STATUS_BACKEND);
    assert_string_equal(e.text, "no context");
    assert_int_equal(directory_count(), 0);
}

/* The film dies in the drawing thread, early, late, or at its last frame: nothing is left. */
static void renderer_that_fails(void **state)
{
    char film[300];
    struct error e;
    const long at[] = {0, 7, 19};
    (void)state;
    snprintf(film, sizeof film, "%s", in_directory("f%d.png"));
    const char *const outputs[] = {film, NULL};
    for (int i = 0; i < 3; i++) {
        fake.fail_at = at[i];
        assert_int_equal(run_film(outputs, 20, true, NULL, &e), STATUS_BACKEND);
        assert_non_null(strstr(e.text, "lost the context"));
        assert_int_equal(directory_count(), 0);
    }
}

static void encoder_that_fails(void **state)
{
    char pattern[300], other[300], directory[300];
    const char *const outputs[] = {pattern, other, NULL};
    struct film_setup setup = {.scene = &scene, .render = &render, .outputs = outputs,
                               .output_count = 2};
    struct film_snapshot *snapshot;
    struct film *film;
    struct error e;
    (void)state;
    snprintf(directory, sizeof directory, "%s", in_directory("gone"));
    snprintf(pattern, sizeof pattern, "%s", in_directory("gone/f%d.png"));
    snprintf(other, sizeof other, "%s", in_directory("g%d.png"));
    assert_int_equal(mkdir(directory, 0777), 0);
    assert_int_equal(film_open(&film, &setup, &e), STATUS_OK);
    assert_string_equal(film_renderer(film), "fake (none)");
    assert_int_equal(unlink(in_directory("gone/f%d.png.lock")), 0);
    assert_int_equal(rmdir(directory), 0);
    enum status status = STATUS_OK;
    long i = 0;
    for (; !status && i < 1000; i++) {
        status = film_snapshot_create(film, 10, &snapshot, &e);
        if (!status) {
            snapshot->index = i;
            status = film_frame(film, snapshot, &e);
        }
    }
    assert_int_equal(status, STATUS_OUTPUT);
    assert_in_range(i, 1, 100);
    assert_int_equal(film_snapshot_create(film, 10, &snapshot, &e), STATUS_OUTPUT);
    assert_int_equal(film_close(film, true, NULL, &e), STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "gone/f"));
    assert_int_equal(directory_count(), 0);
}

static void outputs_are_checked_before_anything(void **state)
{
    char film[300];
    struct error e;
    (void)state;
    snprintf(film, sizeof film, "%s", in_directory("f%d.png"));
    const char *const unknown[] = {film, "x.avi", NULL};
    assert_int_equal(run_film(unknown, 1, true, NULL, &e), STATUS_USAGE);
    const char *const twice[] = {film, film, NULL};
    assert_int_equal(run_film(twice, 1, true, NULL, &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, "twice"));
    assert_int_equal(fake.opened, 0);
    assert_int_equal(directory_count(), 0);
}

static void not_kept_drops_the_queue(void **state)
{
    char film[300];
    struct error e;
    (void)state;
    fake.sleep_ms = 20;
    snprintf(film, sizeof film, "%s", in_directory("f%d.png"));
    const char *const outputs[] = {film, NULL};
    assert_int_equal(run_film(outputs, 3, false, NULL, &e), STATUS_OK);
    assert_true(fake.drawn < 3);
    assert_int_equal(directory_count(), 0);
}

static void snapshot_is_given_back(void **state)
{
    char path[300];
    const char *const outputs[] = {path, NULL};
    struct film_setup setup = {.scene = &scene, .render = &render, .outputs = outputs,
                               .output_count = 1};
    struct film_snapshot *snapshot;
    struct film *film;
    struct error e;
    (void)state;
    snprintf(path, sizeof path, "%s", in_directory("f%d.png"));
    assert_int_equal(film_open(&film, &setup, &e), STATUS_OK);
    for (int i = 0; i < 10; i++) { /* more than there are */
        assert_int_equal(film_snapshot_create(film, 10, &snapshot, &e), STATUS_OK);
        film_snapshot_free(film, snapshot);
    }
    assert_int_equal(film_close(film, true, NULL, &e), STATUS_OK);
    assert_int_equal(directory_count(), 0);
}

#if HAVE_LIBAV
static void mp4_is_whole_or_untouched(void **state)
{
    char path[300];
    const char *const outputs[] = {path, "null", NULL};
    struct error e;
    (void)state;
    snprintf(path, sizeof path, "%s", in_directory("f.mp4"));
    assert_int_equal(run_film(outputs, 70, true, NULL, &e), STATUS_OK);
    assert_true(exists(path));
    fake.fail_at = 69;
    file_write(path, "earlier");
    assert_int_equal(run_film(outputs, 70, true, NULL, &e), STATUS_BACKEND);
    assert_true(file_is(path, "earlier"));
    assert_int_equal(directory_count(), 1);
}
#endif

#define FILM(f) cmocka_unit_test_setup_teardown(f, film_setup_test, film_teardown_test)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FILM(frames_keep_their_order),
        FILM(solid_colours_travel),
        FILM(without_pixels_nothing_is_opened),
        FILM(slow_drawing_bounds_memory),
        FILM(renderer_that_does_not_open),
        FILM(renderer_that_fails),
        FILM(encoder_that_fails),
        FILM(outputs_are_checked_before_anything),
        FILM(not_kept_drops_the_queue),
        FILM(snapshot_is_given_back),
#if HAVE_LIBAV
        FILM(mp4_is_whole_or_untouched),
#endif
    };
    return cmocka_run_group_tests_name("film", tests, NULL, NULL);
}
