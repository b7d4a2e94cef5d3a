/* Turns the codes and log lines of libavcodec and its family into our messages. */
#ifndef BASE_LIBAV_H
#define BASE_LIBAV_H

#include "base/error.h"

#include <stddef.h>

/* Keeps the libraries from printing; from now on their last error line is remembered instead. */
void libav_quiet(void);

/* "text of the code (last error line)" in `text`; forgets the line. */
void libav_reason(int code, char *text, size_t size);

/* Records "what: reason"; returns `status`. */
enum status libav_error(struct error *e, enum status status, int code, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif
