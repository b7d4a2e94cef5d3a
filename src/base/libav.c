/* Remembers the last error line of libavcodec and its family, and words their codes. */
#include "base/libav.h"

#if HAVE_LIBAV

#include <libavutil/error.h>
#include <libavutil/log.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_once_t once = PTHREAD_ONCE_INIT;
static char last_line[300];

static void remember(void *context, int level, const char *format, va_list args)
{
    char line[sizeof last_line];
    (void)context;
    if (level > AV_LOG_ERROR)
        return;
    vsnprintf(line, sizeof line, format, args);
    line[strcspn(line, "\n")] = 0;
    if (!line[0])
        return;
    pthread_mutex_lock(&mutex);
    memcpy(last_line, line, sizeof line);
    pthread_mutex_unlock(&mutex);
}

static void install(void)
{
    av_log_set_callback(remember);
}

void libav_quiet(void)
{
    pthread_once(&once, install);
    pthread_mutex_lock(&mutex);
    last_line[0] = 0;
    pthread_mutex_unlock(&mutex);
}

void libav_reason(int code, char *text, size_t size)
{
    char plain[AV_ERROR_MAX_STRING_SIZE] = "";
    av_strerror(code, plain, sizeof plain);
    pthread_mutex_lock(&mutex);
    if (last_line[0])
        snprintf(text, size, "%s (%s)", plain, last_line);
    else
        snprintf(text, size, "%s", plain);
    last_line[0] = 0;
    pthread_mutex_unlock(&mutex);
}

enum status libav_error(struct error *e, enum status status, int code, const char *format, ...)
{
    char what[1200], reason[400];
    va_list args;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    libav_reason(code, reason, sizeof reason);
    return error_set(e, status, "%s: %s", what, reason);
}

#endif
