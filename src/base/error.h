/* One error, said once where it is known, and carried up as a return code. */
#ifndef BASE_ERROR_H
#define BASE_ERROR_H

/* Every fallible function returns one of these; they are also the exit codes of the program. */
enum status {
    STATUS_OK = 0,
    STATUS_RUN = 1,          /* the run failed: unstable, out of memory, lost device */
    STATUS_USAGE = 2,        /* command line or scene file */
    STATUS_BACKEND = 3,      /* no renderer or encoder */
    STATUS_OUTPUT = 4,       /* output file or disk */
    STATUS_INTERRUPTED = 130 /* SIGINT */
};

struct error {
    enum status status;
    char text[2000]; /* what is wrong and what to do, no trailing newline */
};

/* Records a message and returns `status`, so that `return error_set(e, ...)` is the usual form. */
enum status error_set(struct error *e, enum status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Puts "context: " before the recorded message; returns the recorded status. */
enum status error_context(struct error *e, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
