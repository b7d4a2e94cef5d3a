/* Prints messages and one progress line on stderr, for a person. */
#include "base/log.h"

#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { BAR_WIDTH = 24, LINE_SIZE = 256 };

static const double REDRAW_SECONDS = 0.1; /* not more often than this */
static const double SMOOTH_SECONDS = 5;   /* memory of the speed that ETA is computed from */

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static enum log_level shown = LOG_INFO;

static struct {
    bool visible;        /* a status line is on the screen now */
    bool started;
    double done, total;  /* at the last measurement of speed */
    double time, redraw; /* s, of the last measurement and the last redraw */
    double speed;        /* smoothed, done per s; 0: not known yet */
} progress;

static bool terminal(void)
{
    const char *term = getenv("TERM");
    return isatty(STDERR_FILENO) && term && strcmp(term, "dumb") != 0;
}

static bool colored(void)
{
    const char *no = getenv("NO_COLOR");
    return terminal() && !(no && *no);
}

void log_set_level(enum log_level level)
{
    pthread_mutex_lock(&mutex);
    shown = level;
    pthread_mutex_unlock(&mutex);
}

enum log_level log_get_level(void)
{
    pthread_mutex_lock(&mutex);
    enum log_level level = shown;
    pthread_mutex_unlock(&mutex);
    return level;
}

static void erase(void)
{
    if (progress.visible)
        fputs("\r\033[K", stderr);
    progress.visible = false;
    progress.redraw = 0;
}

static void message(enum log_level level, const char *format, va_list args)
{
    pthread_mutex_lock(&mutex);
    if (level <= shown) {
        bool color = level == LOG_ERROR && colored();
        erase();
        flockfile(stderr);
        if (level == LOG_ERROR)
            fputs(color ? "sph-render: \033[1;31merror:\033[0m " : "sph-render: error: ", stderr);
        vfprintf(stderr, format, args);
        fputc('\n', stderr);
        fflush(stderr);
        funlockfile(stderr);
    }
    pthread_mutex_unlock(&mutex);
}

void log_error(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    message(LOG_ERROR, format, args);
    va_end(args);
}

void log_info(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    message(LOG_INFO, format, args);
    va_end(args);
}

void log_detail(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    message(LOG_DETAIL, format, args);
    va_end(args);
}

/* Follows the speed with an exponential mean, so that ETA neither jumps nor lags for long. */
static void measure(double now, double done, double total)
{
    double dt = now - progress.time;
    if (!progress.started || total != progress.total || done < progress.done) {
        progress.started = true;
        progress.speed = 0;
    } else if (dt < REDRAW_SECONDS || done == progress.done) {
        return;
    } else {
        double speed = (done - progress.done) / dt;
        double weight = progress.speed > 0 ? -expm1(-dt / SMOOTH_SECONDS) : 1;
        progress.speed += weight * (speed - progress.speed);
    }
    progress.time = now;
    progress.done = done;
    progress.total = total;
}

static void format_eta(char *text, size_t size, double seconds)
{
    if (!(seconds < 360000)) {
        snprintf(text, size, "--:-- left");
        return;
    }
    long s = lround(seconds);
    if (s < 3600)
        snprintf(text, size, "%ld:%02ld left", s / 60, s % 60);
    else
        snprintf(text, size, "%ld:%02ld:%02ld left", s / 3600, s / 60 % 60, s % 60);
}

static void draw(double done, double total, const char *note)
{
    struct winsize window = {0};
    bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col;
    int columns = known ? window.ws_col : 80;
    double share = total > 0 ? fmin(fmax(done / total, 0), 1) : 0;
    int full = (int)(share * BAR_WIDTH);
    double eta = share >= 1 ? 0 : progress.speed > 0 ? (total - done) / progress.speed : INFINITY;
    char left[32], bar[BAR_WIDTH + 1], line[LINE_SIZE];

    for (int i = 0; i < BAR_WIDTH; i++)
        bar[i] = i < full ? '=' : i == full ? '>' : ' ';
    bar[BAR_WIDTH] = 0;
    format_eta(left, sizeof left, eta);
    snprintf(line, sizeof line, "%3d%% [%s] %s  %s", (int)(share * 100), bar, left,
             note ? note : "");
    fprintf(stderr, "\r%.*s\033[K", columns - 1, line);
    fflush(stderr);
    progress.visible = true;
}

void log_progress(double done, double total, const char *note)
{
    pthread_mutex_lock(&mutex);
    if (shown >= LOG_INFO && terminal()) {
        double now = clock_seconds();
        measure(now, done, total);
        if (now - progress.redraw >= REDRAW_SECONDS || done >= total) {
            draw(done, total, note);
            progress.redraw = now;
        }
    }
    pthread_mutex_unlock(&mutex);
}

void log_progress_end(void)
{
    pthread_mutex_lock(&mutex);
    erase();
    fflush(stderr);
    memset(&progress, 0, sizeof progress);
    pthread_mutex_unlock(&mutex);
}

double clock_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double clock_cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
