/* Encoder "png": a numbered sequence x-%04d.png, or one picture x.png, written by worker threads.
 *
 * A frame appears under its name as soon as it is whole, so that a film can be watched while it
 * grows. Where an earlier file has that name, the new one waits as NAME.new until close. */
#include "base/log.h"
#include "base/memory.h"
#include "base/queue.h"
#include "encode/numbered.h"

#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WORKERS_MAX = 4, JOBS_MAX = 2 * WORKERS_MAX };

struct job {
    struct image image; /* a copy: the caller may go on drawing */
    long index;
};

enum written { WRITTEN_NOT, WRITTEN_NEW, WRITTEN_STAGED };

struct encoder {
    struct sequence names;
    struct job jobs[JOBS_MAX];
    size_t job_count;
    pthread_t workers[WORKERS_MAX];
    size_t worker_count;
    struct queue idle, ready; /* of jobs */

    pthread_mutex_t mutex;    /* guards the rest */
    unsigned char *written;   /* enum written, by frame index */
    size_t written_count;
    struct error error;       /* the first */
};

static enum status png_check(const struct encode_target *target, struct error *e)
{
    struct sequence names;
    return numbered_names(&names, target, ".png", e);
}

static void record_error(struct encoder *encoder, const struct error *e)
{
    pthread_mutex_lock(&encoder->mutex);
    if (!encoder->error.status)
        encoder->error = *e;
    pthread_mutex_unlock(&encoder->mutex);
}

/* Copies the first error of any worker to `e`. */
static enum status first_error(struct encoder *encoder, struct error *e)
{
    pthread_mutex_lock(&encoder->mutex);
    enum status status = encoder->error.status;
    if (status)
        *e = encoder->error;
    pthread_mutex_unlock(&encoder->mutex);
    return status;
}

static enum status write_job(struct encoder *encoder, const struct job *job, struct error *e)
{
    char name[SEQUENCE_NAME + 8];
    sequence_name(&encoder->names, job->index, name, SEQUENCE_NAME);
    bool stage = access(name, F_OK) == 0;
    if (stage)
        strcat(name, ".new");
    if (image_write_png(&job->image, name, e))
        return e->status;
    pthread_mutex_lock(&encoder->mutex);
    encoder->written[job->index] = stage ? WRITTEN_STAGED : WRITTEN_NEW;
    pthread_mutex_unlock(&encoder->mutex);
    return STATUS_OK;
}

/* After an error the rest is passed by, so that whoever waits for a job gets one. */
static void *work(void *argument)
{
    struct encoder *encoder = argument;
    struct error e;
    struct job *job;
    while ((job = queue_pop(&encoder->ready))) {
        if (!first_error(encoder, &e) && write_job(encoder, job, &e))
            record_error(encoder, &e);
        queue_push(&encoder->idle, job);
    }
    return NULL;
}

static void encoder_free(struct encoder *encoder)
{
    queue_close(&encoder->ready);
    for (size_t i = 0; i < encoder->worker_count; i++)
        pthread_join(encoder->workers[i], NULL);
    for (size_t i = 0; i < encoder->job_count; i++)
        image_free(&encoder->jobs[i].image);
    queue_destroy(&encoder->idle);
    queue_destroy(&encoder->ready);
    pthread_mutex_destroy(&encoder->mutex);
    free(encoder->written);
    memory_free(encoder);
}

static size_t worker_count(const struct encode_target *target)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    if (target->single || processors < 2)
        return 1;
    return processors < WORKERS_MAX ? (size_t)processors : WORKERS_MAX;
}

static enum status png_open(struct encoder **made, const struct encode_target *target,
                            struct error *e)
{
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    *made = NULL;
    if (!encoder)
        return e->status;
    pthread_mutex_init(&encoder->mutex, NULL);
    queue_init(&encoder->idle);
    queue_init(&encoder->ready);
    size_t workers = worker_count(target);
    if (numbered_names(&encoder->names, target, ".png", e))
        goto fail;
    for (size_t i = 0; i < (target->single ? 1 : 2 * workers); i++) {
        struct job *job = &encoder->jobs[i];
        if (image_create(&job->image, target->width, target->height, e))
            goto fail;
        encoder->job_count++;
        queue_push(&encoder->idle, job);
    }
    for (size_t i = 0; i < workers; i++) {
        int code = pthread_create(&encoder->workers[i], NULL, work, encoder);
        if (code) {
            error_set(e, STATUS_RUN, "png: cannot start a thread: %s", strerror(code));
            goto fail;
        }
        encoder->worker_count++;
    }
    *made = encoder;
    return STATUS_OK;
fail:
    encoder_free(encoder);
    return e->status;
}

/* Room to note what became of frame `index`. */
static enum status note_frame(struct encoder *encoder, long index, struct error *e)
{
    enum status status = STATUS_OK;
    if (index < 0)
        return error_set(e, STATUS_RUN, "png: frame number %ld is negative", index);
    pthread_mutex_lock(&encoder->mutex);
    if ((size_t)index >= encoder->written_count) {
        size_t count = 2 * (size_t)index + 64;
        unsigned char *grown = realloc(encoder->written, count);
        if (grown) {
            memset(grown + encoder->written_count, WRITTEN_NOT, count - encoder->written_count);
            encoder->written = grown;
            encoder->written_count = count;
        } else {
            status = error_set(e, STATUS_RUN, "png: no memory to note frame %ld", index);
        }
    }
    pthread_mutex_unlock(&encoder->mutex);
    return status;
}

static enum status png_frame(struct encoder *encoder, const struct encode_frame *frame,
                             struct error *e)
{
    if (first_error(encoder, e) || note_frame(encoder, frame->index, e))
        return e->status;
    struct job *job = queue_pop(&encoder->idle);
    const struct image *from = frame->image;
    job->index = frame->index;
    memcpy(job->image.rgba, from->rgba, (size_t)from->width * (size_t)from->height * 4);
    queue_push(&encoder->ready, job);
    return STATUS_OK;
}

/* Brings a staged frame to its name, or removes what this run wrote. */
static enum status settle(struct encoder *encoder, long index, bool keep, struct error *e)
{
    char name[SEQUENCE_NAME], staged[SEQUENCE_NAME + 8];
    sequence_name(&encoder->names, index, name, sizeof name);
    snprintf(staged, sizeof staged, "%s.new", name);
    bool is_staged = encoder->written[index] == WRITTEN_STAGED;
    if (!keep)
        unlink(is_staged ? staged : name);
    else if (is_staged && rename(staged, name))
        return error_set(e, STATUS_OUTPUT, "%s: %s", name, strerror(errno));
    return STATUS_OK;
}

/* Says when frames of an earlier, longer film follow on this one's. */
static void warn_of_older(const struct encoder *encoder, long count)
{
    char name[SEQUENCE_NAME];
    sequence_name(&encoder->names, count, name, sizeof name);
    if (encoder->names.digits && count && access(name, F_OK) == 0)
        log_info("%s and what follows it belong to an earlier film", name);
}

static enum status png_close(struct encoder *encoder, bool keep, struct error *e)
{
    long count = 0;
    queue_close(&encoder->ready);
    for (size_t i = 0; i < encoder->worker_count; i++)
        pthread_join(encoder->workers[i], NULL);
    encoder->worker_count = 0;
    enum status status = first_error(encoder, e);
    for (long i = 0; (size_t)i < encoder->written_count; i++) {
        if (encoder->written[i] == WRITTEN_NOT)
            continue;
        count = i + 1;
        if (settle(encoder, i, keep && !status, e))
            status = e->status;
    }
    if (keep && !status)
        warn_of_older(encoder, count);
    encoder_free(encoder);
    return keep ? status : STATUS_OK;
}

extern const struct encoder_row encoder_png;
const struct encoder_row encoder_png = {
    .variant = {.name = "png",
                .doc = "a sequence of pictures x-%04d.png, or one, x.png, with --at T"},
    .extensions = (const char *const[]){".png", NULL},
    .wants_pixels = true,
    .check = png_check,
    .open = png_open,
    .frame = png_frame,
    .close = png_close,
};
