/* Finds what memory a run may use. */
#include "base/machine.h"

#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static void lower(double *least, const char **what, double bytes, const char *name)
{
    if (bytes > 0 && (*least == 0 || bytes < *least)) {
        *least = bytes;
        *what = name;
    }
}

/* A number in a file; 0 when there is none ("max" means no limit). */
static double read_number(const char *path)
{
    double number = 0;
    FILE *f = fopen(path, "r");
    if (!f)
        return 0;
    if (fscanf(f, "%lf", &number) != 1)
        number = 0;
    fclose(f);
    return number;
}

/* The group's own limit and those of the groups around it, up to the root. */
static void lower_by_group(double *least, const char **what, const char *root, const char *file,
                           char *group)
{
    char path[4400];
    for (;;) {
        snprintf(path, sizeof path, "%s%s/%s", root, group, file);
        lower(least, what, read_number(path), "the control group's limit");
        char *slash = strrchr(group, '/');
        if (!slash)
            return;
        *slash = '\0';
    }
}

/* Lines of /proc/self/cgroup: "0::/group", or "7:memory:/group" of the older version. */
static void lower_by_groups(double *least, const char **what)
{
    char line[4200];
    FILE *f = fopen("/proc/self/cgroup", "r");
    if (!f)
        return;
    while (fgets(line, sizeof line, f)) {
        char *kind = strchr(line, ':'), *group = kind ? strchr(kind + 1, ':') : NULL;
        if (!group)
            continue;
        *group++ = '\0';
        group[strcspn(group, "\n")] = '\0';
        if (kind[1] == '\0')
            lower_by_group(least, what, "/sys/fs/cgroup", "memory.max", group);
        else if (strstr(kind, "memory"))
            lower_by_group(least, what, "/sys/fs/cgroup/memory", "memory.limit_in_bytes", group);
    }
    fclose(f);
}

double machine_memory(const char **what)
{
    struct rlimit space;
    double least = 0;
    *what = "unknown";
    lower(&least, what, (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE),
          "physical memory");
    lower_by_groups(&least, what);
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
        lower(&least, what, (double)space.rlim_cur, "the address space limit");
    return least;
}
