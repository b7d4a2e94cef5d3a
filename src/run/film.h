/* The film pipeline: while the solver computes, one thread draws and another feeds the encoders.
 *
 *     solver --snapshots--> drawing thread --images--> encoding thread --> every output
 *
 * Both streams are bounded by pools (FILM_SNAPSHOTS, FILM_IMAGES); a slow consumer makes the
 * solver wait in film_snapshot_create. When no output wants pixels there are no threads, no
 * renderer and no images, and the outputs get their frames in film_frame itself. */
#ifndef RUN_FILM_H
#define RUN_FILM_H

#include "base/error.h"
#include "encode/encode.h"
#include "render/render.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    FILM_SNAPSHOTS = RENDER_SLOTS, /* one filled, one waiting, one drawn */
    FILM_IMAGES = 3                /* one drawn, one waiting, one encoded */
};

struct encode_reference;

struct film_setup {
    const struct scene *scene;         /* movie.size, movie.fps, title */
    const struct render_setup *render; /* may be NULL when no output wants pixels */
    const char *const *outputs;        /* as given to -o */
    size_t output_count;
    bool single;                       /* one frame only */
    int sheet[2];                      /* columns and rows of pictures in one frame; 0: none */
    const char *comment;               /* about the film, in its file; may be NULL */
    struct encode_video video;         /* how films are compressed */
    const char *const *columns;        /* of measured rows; NULL when no output wants rows */
    size_t column_count;
    long frame_count;                  /* of the whole film */
    const struct encode_reference *reference; /* accepted frames, or NULL */
    struct render_source source; /* where particles of frames are; zeros: in the host's memory */
};

/* The particles of one frame. The film owns the arrays, or the slot; they are to be filled, not replaced. */
struct film_snapshot {
    long index;                /* frame number, from 0 */
    double time;               /* s */
    size_t count;              /* particles */
    size_t bodies;             /* of them, those that are not of walls */
    const struct render_slot *slot; /* instead of the arrays, when frames are on a device; else NULL */
    float *position;           /* count * 3, m, relative to domain.min; NULL without pixels */
    float *value;              /* count; NULL when render->solid or without pixels */
    uint8_t *color;            /* count * 4 RGBA when render->solid, else NULL */
    uint64_t state_hash;       /* if an output wants hashes */
    size_t capacity;           /* particles that the arrays have room for */
};

/* Wall-clock seconds. */
struct film_times {
    double wait;   /* the solver waited for a free snapshot */
    double draw;   /* in the renderer */
    double encode; /* in the encoders, also at the end of the film */
};

struct film;

/* True when some output wants pixels, so that a render_setup is needed; an output that no encoder
 * writes counts as none. */
bool film_wants_pixels(const char *const *outputs, size_t count);

/* The same for rows of measured numbers, raw numbers of pixels, text that is not pixels, and states' hashes. */
bool film_wants_rows(const char *const *outputs, size_t count);
bool film_wants_raw(const char *const *outputs, size_t count);
bool film_wants_vectors(const char *const *outputs, size_t count);
bool film_wants_hashes(const char *const *outputs, size_t count);

/* Checks every output, then opens every encoder and, in the drawing thread, the renderer. The
 * scene and the render_setup must outlive the film; the setup itself and the outputs need not.
 * STATUS_USAGE, STATUS_OUTPUT, STATUS_BACKEND, STATUS_RUN; then nothing is left open or written. */
enum status film_open(struct film **film, const struct film_setup *setup, struct error *e);

/* "context (GL renderer)" as of renderer_name, or NULL when nothing is drawn. */
const char *film_renderer(const struct film *film);

/* A snapshot with room for `count` particles, index, time and state_hash unset; waits until one is
 * free. An error of drawing or encoding surfaces here too: no further frame can succeed then. */
enum status film_snapshot_create(struct film *film, size_t count, struct film_snapshot **snapshot,
                                 struct error *e);

/* Gives a snapshot back that will not be a frame. */
void film_snapshot_free(struct film *film, struct film_snapshot *snapshot);

/* Takes the snapshot, also on failure. Does not wait for drawing. Indices must increase. On failure
 * (the first error of any thread) close the film with keep = false. */
enum status film_frame(struct film *film, struct film_snapshot *snapshot, struct error *e);

/* Hands a row, a number for each column, to every output that wants rows; on disk when it returns.
 * On failure close the film with keep = false. */
enum status film_row(struct film *film, const double *numbers, struct error *e);

/* keep: draws what is queued, completes every output; else drops the queue and leaves no trace. A
 * film that failed is never kept, but for frames that were drawn before a device was lost: returns its first
 * error when keep is set. Always frees `film` (NULL is allowed); `times` may be NULL. */
enum status film_close(struct film *film, bool keep, struct film_times *times, struct error *e);

#endif
