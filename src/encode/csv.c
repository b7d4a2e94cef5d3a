/* Encoder "csv": measured numbers as text, a row as soon as it is measured.
 *
 * Rows go to NAME.csv.part, each flushed, so that a run that is killed leaves whole rows there; the
 * file takes its name at the end. */
#include "base/log.h"
#include "base/memory.h"
#include "encode/encode.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct encoder {
    FILE *file;
    char *path, *part;
    size_t columns;
    long rows;
};

static void encoder_free(struct encoder *encoder)
{
    free(encoder->path);
    free(encoder->part);
    memory_free(encoder);
}

static enum status disk_error(const char *path, struct error *e)
{
    return error_set(e, STATUS_OUTPUT, "%s: %s", path, strerror(errno));
}

/* 15 digits: every decimal of that length is itself, so that a time of 0.21 reads 0.21. Never "-0",
 * and "nan" without a sign. */
static void write_number(double number, FILE *out)
{
    if (isnan(number))
        fputs("nan", out);
    else
        fprintf(out, "%.15g", number + 0.0);
}

static enum status write_header(struct encoder *encoder, const struct encode_target *target,
                                struct error *e)
{
    for (size_t i = 0; i < target->column_count; i++)
        fprintf(encoder->file, "%s%s", i ? "," : "", target->columns[i]);
    fputc('\n', encoder->file);
    return fflush(encoder->file) ? disk_error(encoder->part, e) : STATUS_OK;
}

static enum status csv_open(struct encoder **made, const struct encode_target *target,
                            struct error *e)
{
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    *made = NULL;
    if (!encoder)
        return e->status;
    encoder->columns = target->column_count;
    encoder->path = strdup(target->path);
    if (!encoder->path || asprintf(&encoder->part, "%s.part", target->path) < 0) {
        error_set(e, STATUS_RUN, "%s: memory is short", target->path);
        encoder->part = NULL;
        goto fail;
    }
    encoder->file = fopen(encoder->part, "we");
    if (!encoder->file) {
        disk_error(encoder->part, e);
        goto fail;
    }
    if (write_header(encoder, target, e)) {
        fclose(encoder->file);
        unlink(encoder->part);
        goto fail;
    }
    *made = encoder;
    return STATUS_OK;
fail:
    encoder_free(encoder);
    return e->status;
}

static enum status csv_row(struct encoder *encoder, const double *numbers, struct error *e)
{
    for (size_t i = 0; i < encoder->columns; i++) {
        if (i)
            fputc(',', encoder->file);
        write_number(numbers[i], encoder->file);
    }
    fputc('\n', encoder->file);
    if (fflush(encoder->file) || ferror(encoder->file))
        return disk_error(encoder->part, e);
    encoder->rows++;
    return STATUS_OK;
}

/* Pictures are not its business. */
static enum status csv_frame(struct encoder *encoder, const struct encode_frame *frame,
                             struct error *e)
{
    (void)encoder;
    (void)frame;
    (void)e;
    return STATUS_OK;
}

static enum status csv_close(struct encoder *encoder, bool keep, struct error *e)
{
    bool wanted = keep && encoder->rows > 0;
    bool good = !wanted || (fflush(encoder->file) == 0 && !ferror(encoder->file) &&
                            fsync(fileno(encoder->file)) == 0);
    enum status status = good ? STATUS_OK : disk_error(encoder->part, e);
    if (fclose(encoder->file) && wanted && !status)
        status = disk_error(encoder->part, e);
    if (wanted && !status && rename(encoder->part, encoder->path))
        status = disk_error(encoder->path, e);
    if (keep && !wanted)
        log_info("%s: not written, since nothing was measured", encoder->path);
    if (!wanted || status)
        unlink(encoder->part);
    encoder_free(encoder);
    return status;
}

extern const struct encoder_row encoder_csv;
const struct encoder_row encoder_csv = {
    .variant = {.name = "csv", .doc = "measured quantities x.csv, a row each time.measure seconds"},
    .extensions = (const char *const[]){".csv", NULL},
    .wants_rows = true,
    .open = csv_open,
    .frame = csv_frame,
    .row = csv_row,
    .close = csv_close,
};
