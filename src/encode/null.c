/* Encoder "null": writes nothing, so that nothing is drawn. */
#include "encode/encode.h"

static enum status null_open(struct encoder **encoder, const struct encode_target *target,
                             struct error *e)
{
    (void)target;
    (void)e;
    *encoder = NULL;
    return STATUS_OK;
}

static enum status null_frame(struct encoder *encoder, const struct encode_frame *frame,
                              struct error *e)
{
    (void)encoder;
    (void)frame;
    (void)e;
    return STATUS_OK;
}

static enum status null_close(struct encoder *encoder, bool keep, struct error *e)
{
    (void)encoder;
    (void)keep;
    (void)e;
    return STATUS_OK;
}

extern const struct encoder_row encoder_null;
const struct encoder_row encoder_null = {
    .variant = {.name = "null", .doc = "nothing is drawn or written; for timing the solver"},
    .extensions = (const char *const[]){"null", NULL},
    .wants_pixels = false,
    .open = null_open,
    .frame = null_frame,
    .close = null_close,
};
