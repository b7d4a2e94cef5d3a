/* Messages and progress for a person on stderr. */
#ifndef BASE_LOG_H
#define BASE_LOG_H

enum log_level { LOG_ERROR, LOG_INFO, LOG_DETAIL };

/* Shows messages up to `level` (-q: LOG_ERROR, default LOG_INFO, -v: LOG_DETAIL).
 * Colour only on a terminal and without NO_COLOR. */
void log_set_level(enum log_level level);
enum log_level log_get_level(void);

void log_error(const char *format, ...) __attribute__((format(printf, 1, 2)));
void log_info(const char *format, ...) __attribute__((format(printf, 1, 2)));
void log_detail(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* One status line with a bar, percent and ETA, redrawn in place; only on a terminal and not with
 * -q. `done` and `total` in any one unit; `note` is short free text. Thread-safe. */
void log_progress(double done, double total, const char *note);

/* Ends the status line (erases it); messages call it by themselves. */
void log_progress_end(void);

/* Monotonic wall clock, seconds. */
double clock_seconds(void);

/* What all processors have spent on this process, seconds. */
double clock_cpu_seconds(void);

#endif
