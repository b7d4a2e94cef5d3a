/* Runs this program again, or another, as a child. */
#include "study/process.h"

#include "base/log.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t interrupted;

static void on_signal(int number)
{
    (void)number;
    interrupted = 1;
}

void process_catch_signals(void)
{
    struct sigaction action = {.sa_handler = on_signal}, before;
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        if (sigaction(numbers[k], NULL, &before) == 0 &&
            (before.sa_handler != SIG_IGN || numbers[k] == SIGINT))
            sigaction(numbers[k], &action, NULL);
}

bool process_interrupted(void)
{
    return interrupted;
}

/* In the child. It gets no signal of the terminal's, so that what it wrote is whole or absent as we
 * say, and ends when we do. */
static void become(const char *const *argv, const char *directory, int log)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    signal(SIGHUP, SIG_DFL);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    if (!directory)
        execv("/proc/self/exe", (char *const *)argv);
    else if (chdir(directory) == 0)
        execvp(argv[0], (char *const *)argv);
}

/* Waits, and ends what is late or no longer wanted. */
static int wait_for(pid_t child, double limit, struct process_end *end)
{
    const struct timespec nap = {0, 2000000};
    double start = clock_seconds();
    int state = 0;
    for (bool killed = false; waitpid(child, &state, killed ? 0 : WNOHANG) != child;) {
        end->late = clock_seconds() - start > limit;
        if (!killed && (end->late || interrupted)) {
            kill(child, SIGKILL);
            killed = true;
        }
        if (!killed)
            nanosleep(&nap, NULL);
    }
    end->seconds = clock_seconds() - start;
    return state;
}

/* `directory`: of another program; NULL: it is this one, here. */
static enum status start(const char *const *argv, const char *directory, const char *log,
                         double limit, struct process_end *end, struct error *e)
{
    *end = (struct process_end){0};
    int file = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        return error_set(e, STATUS_OUTPUT, "%s: %s", log, strerror(errno));
    pid_t child = interrupted ? -1 : fork();
    if (child == 0) {
        become(argv, directory, file);
        _exit(STATUS_INTERRUPTED); /* only when there is no program to become */
    }
    close(file);
    if (child > 0) {
        int state = wait_for(child, limit, end);
        end->code = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    }
    if (interrupted)
        return error_set(e, STATUS_INTERRUPTED, "interrupted; the same command goes on where this "
                         "one stopped");
    return child > 0 ? STATUS_OK
                     : error_set(e, STATUS_RUN, "no child process: %s", strerror(errno));
}

enum status process_run(const char *const *argv, const char *log, double limit,
                        struct process_end *end, struct error *e)
{
    return start(argv, NULL, log, limit, end, e);
}

enum status process_run_other(const char *const *argv, const char *directory, const char *log,
                              struct process_end *end, struct error *e)
{
    return start(argv, directory, log, INFINITY, end, e);
}

bool process_found(const char *name)
{
    char path[4096];
    const char *from = getenv("PATH");
    while (from && *from) {
        size_t length = strcspn(from, ":");
        snprintf(path, sizeof path, "%.*s/%s", (int)length, from, name);
        if (access(path, X_OK) == 0)
            return true;
        from += length + (from[length] == ':');
    }
    return false;
}
