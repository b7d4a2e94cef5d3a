/* Encoder "reference": compares each frame with accepted ones, or accepts the frames.
 *
 * Accepting is the work of the encoder "png", so that names and care for earlier files are the same. */
#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/sequence.h"
#include "compare/lineup.h"
#include "compare/record.h"
#include "encode/encode.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct encoder {
    char *names[BASELINES_MAX]; /* as -o takes them: x-%04d.png */
    char *files[BASELINES_MAX]; /* of one picture without a number, the file itself; else the same */
    size_t count;
    struct sequence sequence;   /* of the first of them */
    long taken, wanted;         /* frames */
    char failed[300];           /* the first that differs */

    struct lineup accepted;     /* when comparing */
    struct comparison comparison;
    struct record record;

    const struct encoder_row *png; /* when accepting; else NULL */
    struct encoder *inner;
    struct output_claim claim;
};

/* Not the name of a picture, or of many. */
static bool is_directory(const char *path)
{
    size_t length = strlen(path);
    return length <= 4 || strcasecmp(path + length - 4, ".png") != 0;
}

/* "DIR" is DIR/frame-%04d.png, or DIR/frame.png when there is one frame. */
static char *name_of(const char *path, bool single)
{
    size_t size = 2 * strlen(path) + 32;
    char *name = malloc(size), *out = name;
    if (!name)
        return NULL;
    if (!is_directory(path))
        return strcpy(name, path);
    for (const char *p = path; *p; p++) {
        *out++ = *p;
        if (*p == '%')
            *out++ = '%';
    }
    snprintf(out, size - (size_t)(out - name), "%s", single ? "/frame.png" : "/frame-%04d.png");
    return name;
}

static enum status add_name(struct encoder *encoder, const struct encode_target *target,
                            const char *path, struct error *e)
{
    struct sequence sequence;
    char *name = encoder->names[encoder->count++] = name_of(path, target->single);
    if (!name)
        return error_set(e, STATUS_RUN, "memory is short");
    if (sequence_read(&sequence, "--reference", name, e))
        return e->status;
    if (!sequence.digits && !target->single)
        return error_set(e, STATUS_USAGE, "--reference \"%s\" names one picture, but a film has many; "
                         "name a directory or for example x-%%04d.png", path);
    encoder->files[encoder->count - 1] = strdup(sequence.digits ? name : sequence.before);
    if (encoder->count == 1)
        encoder->sequence = sequence;
    if (!encoder->files[encoder->count - 1])
        return error_set(e, STATUS_RUN, "memory is short");
    return STATUS_OK;
}

static void encoder_free(struct encoder *encoder)
{
    lineup_close(&encoder->accepted);
    output_release(&encoder->claim);
    for (size_t i = 0; i < encoder->count; i++) {
        free(encoder->names[i]);
        free(encoder->files[i]);
    }
    memory_free(encoder);
}

static enum status open_accepted(struct encoder *encoder, const struct encode_target *target,
                                 struct error *e)
{
    const struct encode_reference *reference = target->reference;
    struct comparison *comparison = &encoder->comparison;
    if (lineup_open(&encoder->accepted, (const char *const *)encoder->files, encoder->count, e)) {
        const struct error why = *e;
        return error_set(e, why.status, "--reference: %.1500s; accept the frames of this scene with "
                         "--update", why.text);
    }
    comparison->frames = target->title && target->title[0] ? target->title : "this run";
    comparison->baselines = (const char *const *)encoder->names;
    comparison->baseline_count = encoder->count;
    comparison->gate = reference->gate;
    comparison->single = target->single;
    comparison->text = stderr;
    encoder->record.comparison = comparison;
    if (gate_limits(&comparison->limits, reference->gate, e) ||
        (reference->page && record_add(&encoder->record, &sink_page, reference->page, e)))
        return e->status;
    return log_get_level() < LOG_INFO ? STATUS_OK : record_add(&encoder->record, &sink_text, "", e);
}

static enum status open_png(struct encoder *encoder, const struct encode_target *target,
                            struct error *e)
{
    struct encode_target inner = *target;
    const char *path = target->reference->paths[0];
    inner.path = encoder->names[0];
    if (is_directory(path) && mkdir(path, 0777) != 0 && errno != EEXIST)
        return error_set(e, STATUS_OUTPUT, "cannot make directory %s: %s", path, strerror(errno));
    encoder->png = encode_find(inner.path, e);
    if (!encoder->png || encode_check(&inner, e) || output_claim(&encoder->claim, inner.path, e))
        return e->status;
    return encoder->png->open(&encoder->inner, &inner, e);
}

static enum status reference_check(const struct encode_target *target, struct error *e)
{
    const struct encode_reference *reference = target->reference;
    struct limits limits;
    if (!reference)
        return error_set(e, STATUS_USAGE, "output \"reference\" comes by itself with --reference DIR");
    if (reference->count > BASELINES_MAX)
        return error_set(e, STATUS_USAGE, "more than %d --reference", BASELINES_MAX);
    if (reference->update && reference->count > 1)
        return error_set(e, STATUS_USAGE, "--update needs to know which --reference to write; give one");
    return gate_limits(&limits, reference->gate, e);
}

static enum status reference_open(struct encoder **made, const struct encode_target *target,
                                  struct error *e)
{
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    struct error ignored;
    *made = NULL;
    if (!encoder)
        return e->status;
    e->status = STATUS_OK;
    encoder->wanted = target->frame_count;
    for (size_t i = 0; i < target->reference->count && !e->status; i++)
        add_name(encoder, target, target->reference->paths[i], e);
    if (!e->status &&
        (target->reference->update ? open_png : open_accepted)(encoder, target, e) == STATUS_OK) {
        *made = encoder;
        return STATUS_OK;
    }
    record_close(&encoder->record, false, &ignored);
    encoder_free(encoder);
    return e->status;
}

/* Judges one frame, or NULL for those that only the accepted film has. */
static enum status judge(struct encoder *encoder, const struct source *place,
                         const struct image *image, struct error *e)
{
    const struct image *accepted[LINEUP_MAX];
    struct verdict verdict;
    if (lineup_read(&encoder->accepted, place, accepted, e) ||
        verdict_make(&verdict, place->name, &encoder->comparison.limits, image, accepted,
                     encoder->count, e))
        return e->status;
    if (!verdict_passes(verdict.state)) {
        log_progress_end();
        if (!encoder->failed[0])
            snprintf(encoder->failed, sizeof encoder->failed, "%s", place->name);
    }
    return record_frame(&encoder->record, &verdict, e);
}

static enum status reference_frame(struct encoder *encoder, const struct encode_frame *frame,
                                   struct error *e)
{
    struct source place = {.number = frame->index};
    encoder->taken++;
    if (encoder->png)
        return encoder->png->frame(encoder->inner, frame, e);
    char path[SEQUENCE_NAME], *slash;
    sequence_name(&encoder->sequence, frame->index, path, sizeof path);
    slash = strrchr(path, '/');
    snprintf(place.name, sizeof place.name, "%.299s", slash ? slash + 1 : path);
    return judge(encoder, &place, frame->image, e);
}

/* Frames of an earlier, longer film are not accepted any more. */
static void remove_older(const struct encoder *encoder)
{
    struct source old;
    struct error e;
    char name[SEQUENCE_NAME];
    if (!encoder->sequence.digits ||
        source_open(&old, encoder->names[0], SOURCE_SEQUENCE, SOURCE_BY_NUMBER, &e))
        return;
    for (; !old.ended; old.row->next(&old, &e)) {
        sequence_name(&encoder->sequence, old.number, name, sizeof name);
        if (old.number >= encoder->wanted)
            unlink(name);
    }
    source_close(&old);
}

static enum status close_png(struct encoder *encoder, bool keep, struct error *e)
{
    bool whole = encoder->taken == encoder->wanted;
    enum status status = encoder->png->close(encoder->inner, keep && whole, e);
    if (!keep || status)
        return status;
    if (whole) {
        remove_older(encoder);
        log_info("%ld frame%s accepted as %s", encoder->taken, encoder->taken == 1 ? "" : "s",
                 encoder->names[0]);
    } else {
        log_info("%s is unchanged, since only %ld of %ld frames were drawn", encoder->names[0],
                 encoder->taken, encoder->wanted);
    }
    return STATUS_OK;
}

/* What is left over is missing, unless the run ended early. */
static enum status close_accepted(struct encoder *encoder, bool keep, struct error *e)
{
    const struct tally *tally = &encoder->record.tally;
    struct error ignored;
    const struct source *next;
    enum status status = STATUS_OK;
    bool whole = encoder->taken == encoder->wanted;
    log_progress_end();
    while (keep && whole && !status && !(next = lineup_first(&encoder->accepted))->ended) {
        const struct source place = *next;
        status = judge(encoder, &place, NULL, e);
    }
    if (keep && !whole)
        log_info("%ld of %ld frames were drawn and compared", encoder->taken, encoder->wanted);
    bool kept = keep && !status;
    if (record_close(&encoder->record, kept, kept ? e : &ignored) && kept)
        status = e->status;
    if (kept && !status && tally->failed)
        return error_set(e, STATUS_RUN, "%zu of %zu frame%s differ%s from %s (gate %s), first %s; "
                         "--html FILE.html shows how, --update accepts them", tally->failed,
                         tally->frames, tally->frames == 1 ? "" : "s", tally->failed == 1 ? "s" : "",
                         encoder->names[0], encoder->comparison.gate, encoder->failed);
    return status;
}

static enum status reference_close(struct encoder *encoder, bool keep, struct error *e)
{
    enum status status = (encoder->png ? close_png : close_accepted)(encoder, keep, e);
    encoder_free(encoder);
    return keep ? status : STATUS_OK;
}

extern const struct encoder_row encoder_reference;
const struct encoder_row encoder_reference = {
    .variant = {.name = "reference",
                .doc = "compares each frame with accepted ones, or accepts it: --reference DIR"},
    .extensions = (const char *const[]){"reference", NULL},
    .wants_pixels = true,
    .check = reference_check,
    .open = reference_open,
    .frame = reference_frame,
    .close = reference_close,
};
