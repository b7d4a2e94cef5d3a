/* Overlaps solver, drawing and encoding of a film by two threads and bounded pools. */
#include "run/film.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/queue.h"
#include "encode/encode.h"
#include "render/sheet.h"
#include "scene/scene.h"

#include <pthread.h>
#include <stdatomic.h>
#include <string.h>

struct output {
    const struct encoder_row *row;
    struct encoder *encoder;
    struct output_claim claim; /* of a file */
    bool fed;                  /* a frame or a row */
};

/* A drawn frame on its way to the encoders. */
struct picture {
    struct image image;
    long index;
    double time;
    uint64_t state_hash;
};

struct film {
    struct film_setup setup;
    bool pixels, solid;
    struct output *outputs;
    size_t output_count;      /* opened */

    struct film_snapshot snapshots[FILM_SNAPSHOTS];
    struct picture pictures[FILM_IMAGES];
    struct sheet *sheet;      /* that pictures go into, or NULL */
    struct queue snapshots_idle, snapshots_ready, pictures_idle, pictures_ready;
    pthread_t drawer, encoder;
    bool drawing, encoding;   /* threads to join */
    atomic_bool dropped;      /* an error, or a film that is not kept: empty the queues idly */
    atomic_bool lost;         /* the device that had the frames is: no more come, those drawn are kept */

    pthread_mutex_t mutex;    /* guards the next three */
    pthread_cond_t opened;
    struct error error;       /* the first of any thread */
    bool is_open;             /* the drawing thread has opened its renderer, or failed */

    char name[200];           /* of the renderer */
    struct film_times times;  /* each member is written by one thread, and read after joins */
};

/* Keeps the first error, and raises a flag of the film's. */
static void film_stop(struct film *film, const struct error *e, atomic_bool *flag)
{
    pthread_mutex_lock(&film->mutex);
    if (!film->error.status)
        film->error = *e;
    pthread_mutex_unlock(&film->mutex);
    atomic_store(flag, true);
}

static void film_fail(struct film *film, const struct error *e)
{
    film_stop(film, e, &film->dropped);
}

static enum status film_error(struct film *film, struct error *e)
{
    pthread_mutex_lock(&film->mutex);
    enum status status = film->error.status;
    if (status)
        *e = film->error;
    pthread_mutex_unlock(&film->mutex);
    return status;
}

/* Hands one frame to every output in turn; `image` may be NULL. */
static enum status encode_frame(struct film *film, const struct encode_frame *frame,
                                struct error *e)
{
    for (size_t i = 0; i < film->output_count; i++) {
        struct output *output = &film->outputs[i];
        struct encode_frame given = *frame;
        if (!output->row->wants_pixels)
            given.image = NULL;
        if (output->row->frame(output->encoder, &given, e))
            return e->status;
        if (!output->row->wants_rows)
            output->fed = true; /* the others are by film_row, in another thread */
    }
    return STATUS_OK;
}

/* A sheet is the only frame, once no more pictures come. */
static void *encode_thread(void *argument)
{
    struct film *film = argument;
    struct picture *picture;
    struct error e;
    struct encode_frame frame = {.image = NULL};
    while ((picture = queue_pop(&film->pictures_ready))) {
        double start = clock_seconds();
        frame = (struct encode_frame){picture->index, picture->time, &picture->image,
                                      picture->state_hash};
        if (film->sheet)
            sheet_add(film->sheet, picture->time, &picture->image);
        else if (!atomic_load(&film->dropped) && encode_frame(film, &frame, &e))
            film_fail(film, &e);
        film->times.encode += clock_seconds() - start;
        queue_push(&film->pictures_idle, picture);
    }
    if (film->sheet && frame.image && !atomic_load(&film->dropped)) {
        frame.index = 0;
        frame.image = sheet_image(film->sheet);
        if (encode_frame(film, &frame, &e))
            film_fail(film, &e);
    }
    return NULL;
}

static enum status draw_snapshot(struct film *film, struct renderer *renderer,
                                 const struct film_snapshot *snapshot, struct picture *picture,
                                 struct error *e)
{
    struct render_frame frame = {
        .index = snapshot->index,
        .time = snapshot->time,
        .count = snapshot->count,
        .position = snapshot->position,
        .value = snapshot->value,
        .color = snapshot->color,
        .slot = snapshot->slot,
        .bodies = snapshot->bodies,
    };
    picture->index = snapshot->index;
    picture->time = snapshot->time;
    picture->state_hash = snapshot->state_hash;
    double start = clock_seconds();
    enum status status = renderer_draw(renderer, &frame, &picture->image, e);
    film->times.draw += clock_seconds() - start;
    return status;
}

/* Draws until the queue ends; after an error it only recycles, so that nobody waits for ever. */
static void draw_all(struct film *film, struct renderer *renderer)
{
    struct film_snapshot *snapshot;
    struct error e;
    while ((snapshot = queue_pop(&film->snapshots_ready))) {
        if (!atomic_load(&film->dropped) && !atomic_load(&film->lost)) {
            struct picture *picture = queue_pop(&film->pictures_idle);
            bool drawn = draw_snapshot(film, renderer, snapshot, picture, &e) == STATUS_OK;
            if (!drawn && snapshot->slot)
                film_stop(film, &e, &film->lost);
            else if (!drawn)
                film_fail(film, &e);
            queue_push(drawn ? &film->pictures_ready : &film->pictures_idle, picture);
        }
        queue_push(&film->snapshots_idle, snapshot);
    }
}

/* Frames on a device have slots of the renderer's. */
static enum status lend_slots(struct film *film, struct renderer *renderer, struct error *e)
{
    struct render_slot *slots;
    if (!film->setup.source.row)
        return STATUS_OK;
    if (renderer_slots(renderer, &film->setup.source, &slots, e))
        return e->status;
    for (size_t k = 0; k < FILM_SNAPSHOTS; k++)
        film->snapshots[k].slot = &slots[k];
    return STATUS_OK;
}

/* The renderer lives and dies in this thread, as GL contexts want. */
static void *draw_thread(void *argument)
{
    struct film *film = argument;
    struct renderer *renderer = NULL;
    struct error e;
    if (renderer_open(&renderer, film->setup.render, &e) || lend_slots(film, renderer, &e)) {
        film_fail(film, &e);
    } else {
        const char *name = renderer_name(renderer);
        strncpy(film->name, name ? name : "", sizeof film->name - 1);
    }
    pthread_mutex_lock(&film->mutex);
    film->is_open = true;
    pthread_cond_signal(&film->opened);
    pthread_mutex_unlock(&film->mutex);
    draw_all(film, renderer);
    if (renderer)
        renderer_close(renderer);
    return NULL;
}

static struct encode_target target_of(const struct film_setup *setup, size_t output)
{
    const struct scene *scene = setup->scene;
    int size[2] = {scene->movie.size[0], scene->movie.size[1]};
    if (setup->sheet[0])
        sheet_size(scene, setup->sheet, size);
    return (struct encode_target){
        .path = setup->outputs[output],
        .width = size[0],
        .height = size[1],
        .fps = scene->movie.fps,
        .single = setup->single,
        .title = scene->title,
        .comment = setup->comment,
        .video = setup->video,
        .columns = setup->columns,
        .column_count = setup->column_count,
        .frame_count = setup->frame_count,
        .reference = setup->reference,
    };
}

static enum status check_outputs(const struct film_setup *setup, struct error *e)
{
    for (size_t i = 0; i < setup->output_count; i++) {
        struct encode_target target = target_of(setup, i);
        if (encode_check(&target, e))
            return e->status;
        for (size_t k = 0; k < i; k++)
            if (strcmp(setup->outputs[i], setup->outputs[k]) == 0)
                return error_set(e, STATUS_USAGE, "output \"%s\" is given twice",
                                 setup->outputs[i]);
    }
    if (film_wants_pixels(setup->outputs, setup->output_count) && !setup->render)
        return error_set(e, STATUS_RUN, "the outputs want pictures, but nothing would draw them");
    return STATUS_OK;
}

static enum status open_output(struct output *output, const struct film_setup *setup, size_t index,
                               struct error *e)
{
    struct encode_target target = target_of(setup, index);
    output->row = encode_find(target.path, e);
    if (!output->row)
        return e->status;
    if (encode_is_file(output->row, target.path) &&
        output_claim(&output->claim, target.path, e))
        return e->status;
    if (output->row->open(&output->encoder, &target, e)) {
        output_release(&output->claim);
        return e->status;
    }
    return STATUS_OK;
}

static enum status open_outputs(struct film *film, struct error *e)
{
    const struct film_setup *setup = &film->setup;
    film->outputs = memory_create("film", setup->output_count, sizeof *film->outputs, e);
    if (!film->outputs)
        return e->status;
    for (size_t i = 0; i < setup->output_count; i++) {
        if (open_output(&film->outputs[i], setup, i, e))
            return e->status;
        film->output_count++;
    }
    return STATUS_OK;
}

static enum status start_thread(pthread_t *thread, bool *started, void *(*body)(void *),
                                struct film *film, struct error *e)
{
    int code = pthread_create(thread, NULL, body, film);
    if (code)
        return error_set(e, STATUS_RUN, "cannot start a thread: %s", strerror(code));
    *started = true;
    return STATUS_OK;
}

/* Starts the drawing thread and waits until its renderer is open. */
static enum status open_drawing(struct film *film, struct error *e)
{
    if (start_thread(&film->drawer, &film->drawing, draw_thread, film, e))
        return e->status;
    pthread_mutex_lock(&film->mutex);
    while (!film->is_open)
        pthread_cond_wait(&film->opened, &film->mutex);
    pthread_mutex_unlock(&film->mutex);
    return film_error(film, e);
}

static enum status open_pictures(struct film *film, struct error *e)
{
    const int *size = film->setup.scene->movie.size, *sheet = film->setup.sheet;
    if (sheet[0] && sheet_open(&film->sheet, film->setup.render, sheet, e))
        return e->status;
    for (size_t i = 0; i < (film->setup.single && !sheet[0] ? 1 : FILM_IMAGES); i++) {
        struct image *image = &film->pictures[i].image;
        if (image_create(image, size[0], size[1], e) ||
            (film->setup.render->raw && image_create_raw(image, e)))
            return e->status;
        queue_push(&film->pictures_idle, &film->pictures[i]);
    }
    return start_thread(&film->encoder, &film->encoding, encode_thread, film, e);
}

enum status film_open(struct film **opened, const struct film_setup *setup, struct error *e)
{
    struct error ignored;
    *opened = NULL;
    if (check_outputs(setup, e))
        return e->status;
    struct film *film = memory_create("film", 1, sizeof *film, e);
    if (!film)
        return e->status;
    film->setup = *setup;
    film->pixels = film_wants_pixels(setup->outputs, setup->output_count);
    film->solid = film->pixels && setup->render->solid;
    atomic_init(&film->dropped, false);
    atomic_init(&film->lost, false);
    pthread_mutex_init(&film->mutex, NULL);
    pthread_cond_init(&film->opened, NULL);
    queue_init(&film->snapshots_idle);
    queue_init(&film->snapshots_ready);
    queue_init(&film->pictures_idle);
    queue_init(&film->pictures_ready);
    for (size_t i = 0; i < FILM_SNAPSHOTS; i++)
        queue_push(&film->snapshots_idle, &film->snapshots[i]);

    enum status status = STATUS_OK;
    if (film->pixels) /* the renderer first: a film that cannot be drawn creates no file */
        status = open_drawing(film, e);
    if (!status)
        status = open_outputs(film, e);
    if (!status && film->pixels)
        status = open_pictures(film, e);
    if (!status)
        *opened = film;
    else
        film_close(film, false, NULL, &ignored);
    return status;
}

const char *film_renderer(const struct film *film)
{
    return film->pixels ? film->name : NULL;
}

static void snapshot_release(struct film_snapshot *snapshot)
{
    memory_free(snapshot->position);
    memory_free(snapshot->value);
    memory_free(snapshot->color);
    memset(snapshot, 0, sizeof *snapshot);
}

static enum status snapshot_fit(const struct film *film, struct film_snapshot *snapshot,
                                size_t count, struct error *e)
{
    if (!film->pixels || snapshot->slot || count <= snapshot->capacity)
        return STATUS_OK;
    snapshot_release(snapshot);
    snapshot->position = memory_create("snapshots", count, 3 * sizeof *snapshot->position, e);
    if (film->solid)
        snapshot->color = memory_create("snapshots", count, 4 * sizeof *snapshot->color, e);
    else
        snapshot->value = memory_create("snapshots", count, sizeof *snapshot->value, e);
    if (!snapshot->position || (film->solid ? !snapshot->color : !snapshot->value))
        return e->status;
    snapshot->capacity = count;
    return STATUS_OK;
}

enum status film_snapshot_create(struct film *film, size_t count, struct film_snapshot **made,
                                 struct error *e)
{
    *made = NULL;
    if (film_error(film, e))
        return e->status;
    double start = clock_seconds();
    struct film_snapshot *snapshot = queue_pop(&film->snapshots_idle);
    film->times.wait += clock_seconds() - start;
    if (film_error(film, e) || snapshot_fit(film, snapshot, count, e)) {
        queue_push(&film->snapshots_idle, snapshot);
        return e->status;
    }
    snapshot->count = count;
    *made = snapshot;
    return STATUS_OK;
}

void film_snapshot_free(struct film *film, struct film_snapshot *snapshot)
{
    if (snapshot)
        queue_push(&film->snapshots_idle, snapshot);
}

enum status film_frame(struct film *film, struct film_snapshot *snapshot, struct error *e)
{
    if (film_error(film, e)) {
        queue_push(&film->snapshots_idle, snapshot);
    } else if (film->pixels) {
        queue_push(&film->snapshots_ready, snapshot);
    } else {
        struct encode_frame frame = {snapshot->index, snapshot->time, NULL, snapshot->state_hash};
        double start = clock_seconds();
        if (encode_frame(film, &frame, e))
            film_fail(film, e);
        film->times.encode += clock_seconds() - start;
        queue_push(&film->snapshots_idle, snapshot);
    }
    return film_error(film, e);
}

enum status film_row(struct film *film, const double *numbers, struct error *e)
{
    if (film_error(film, e))
        return e->status;
    for (size_t i = 0; i < film->output_count; i++) {
        struct output *output = &film->outputs[i];
        if (!output->row->wants_rows)
            continue;
        if (output->row->row(output->encoder, numbers, e)) {
            film_fail(film, e);
            return e->status;
        }
        output->fed = true;
    }
    return STATUS_OK;
}

/* Ends the threads from front to back, so that each finishes what it was given. */
static void join_threads(struct film *film)
{
    queue_close(&film->snapshots_ready);
    if (film->drawing)
        pthread_join(film->drawer, NULL);
    queue_close(&film->pictures_ready);
    if (film->encoding)
        pthread_join(film->encoder, NULL);
}

static void film_free(struct film *film)
{
    for (size_t i = 0; i < FILM_SNAPSHOTS; i++)
        snapshot_release(&film->snapshots[i]);
    for (size_t i = 0; i < FILM_IMAGES; i++)
        image_free(&film->pictures[i].image);
    sheet_close(film->sheet);
    queue_destroy(&film->snapshots_idle);
    queue_destroy(&film->snapshots_ready);
    queue_destroy(&film->pictures_idle);
    queue_destroy(&film->pictures_ready);
    pthread_cond_destroy(&film->opened);
    pthread_mutex_destroy(&film->mutex);
    memory_free(film->outputs);
    memory_free(film);
}

enum status film_close(struct film *film, bool keep, struct film_times *times, struct error *e)
{
    struct error closing;
    if (!film)
        return STATUS_OK;
    if (!keep)
        atomic_store(&film->dropped, true);
    join_threads(film);
    double start = clock_seconds();
    enum status status = film_error(film, &closing);
    const bool lost = film->lost && !film->dropped;
    if (keep && status)
        *e = closing;
    for (size_t i = 0; i < film->output_count; i++) {
        struct output *output = &film->outputs[i];
        bool whole = keep && (!status || (lost && output->fed));
        if (output->row->close(output->encoder, whole, &closing) && !status) {
            *e = closing;
            status = closing.status;
        }
        output_release(&output->claim);
    }
    film->times.encode += clock_seconds() - start;
    if (times)
        *times = film->times;
    film_free(film);
    return keep ? status : STATUS_OK;
}
