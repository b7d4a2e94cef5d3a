/* Arguments in, exit code out. */
#include "tools/cli.h"

#include <limits.h>
#include <stdlib.h>
#include <unistd.h>

/* Threads that wait for the others spin first, and by default so long that on a machine with other
 * work each takes the time the others need: steps cost up to 5 times as much. OpenMP reads its
 * settings before main, so the program starts itself again with a shorter spin, which measures the
 * same on a quiet machine; sleeping at once (OMP_WAIT_POLICY=passive) costs a fifth there. Settings
 * of the caller's own are left alone. */
static void wait_politely(char **argv)
{
    char program[PATH_MAX];
    if (getenv("OMP_WAIT_POLICY") || getenv("GOMP_SPINCOUNT") || getenv("KMP_BLOCKTIME"))
        return;
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (length <= 0)
        return;
    program[length] = 0;
    if (setenv("GOMP_SPINCOUNT", "30000", 1) || setenv("KMP_BLOCKTIME", "1", 1))
        return;
    execv(program, argv); /* comes back only when it fails, and then nothing is lost */
}

int main(int argc, char **argv)
{
    wait_politely(argv);
    exit(cli_main(argc, argv));
}
