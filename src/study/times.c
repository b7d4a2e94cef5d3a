/* Times of a point's runs: the least, the median, and which runs were disturbed by others on the machine. */
#include "study/study.h"

#include <math.h>
#include <stddef.h>

/* The same work takes the same time: a run that took more than this above the least was disturbed. */
#define DISTURBED 1.1

static double least(const double *values, int count)
{
    double value = (double)NAN;
    for (int k = 0; k < count; k++)
        value = fmin(value, values[k]);
    return value;
}

bool study_is_disturbed(const struct study_point *point, int repeat)
{
    double wall = point->wall[repeat], cpu = point->cpu[repeat], calm = INFINITY;
    for (int k = 0; k < point->repeats; k++)
        calm = fmin(calm, point->wall[k] / point->cpu[k]);
    if (wall > DISTURBED * least(point->wall, point->repeats))
        return true;
    /* it waited for a processor: solving takes at least a thread's time all along */
    return cpu > 0 && (wall / cpu > DISTURBED * calm || wall > DISTURBED * cpu);
}

int study_calm(const struct study_point *point)
{
    int calm = 0;
    for (int k = 0; k < point->repeats; k++)
        calm += !study_is_disturbed(point, k);
    return calm;
}

static double median(double *values, int count)
{
    for (int i = 1; i < count; i++)
        for (int j = i; j > 0 && values[j - 1] > values[j]; j--) {
            double swap = values[j];
            values[j] = values[j - 1];
            values[j - 1] = swap;
        }
    return count ? (values[(count - 1) / 2] + values[count / 2]) / 2 : (double)NAN;
}

static double wall(const struct study_point *point)
{
    return least(point->wall, point->repeats);
}

static double cpu(const struct study_point *point)
{
    return least(point->cpu, point->repeats);
}

/* Of the runs that were not disturbed; of all when every one was. */
static double wall_median(const struct study_point *point)
{
    double values[STUDY_RUNS_MAX];
    int count = 0;
    bool all = study_calm(point) == 0;
    for (int k = 0; k < point->repeats; k++)
        if (all || !study_is_disturbed(point, k))
            values[count++] = point->wall[k];
    return median(values, count);
}

static double pairs(const struct study_point *point)
{
    return point->repeats > 0 && point->pairs > 0 ? point->pairs : (double)NAN;
}

/* Of the point's runs from each seed that is done; of its own without seeds. */
static double mean(const struct study_point *point, double (*of)(const struct study_point *))
{
    double sum = 0;
    size_t count = 0;
    if (!point->member_count)
        return of(point);
    for (size_t k = 0; k < point->member_count; k++)
        if (!isnan(of(&point->members[k]))) {
            sum += of(&point->members[k]);
            count++;
        }
    return count ? sum / (double)count : (double)NAN;
}

double study_wall(const struct study_point *point)
{
    return mean(point, wall);
}

double study_cpu(const struct study_point *point)
{
    return mean(point, cpu);
}

double study_wall_median(const struct study_point *point)
{
    return mean(point, wall_median);
}

double study_pairs(const struct study_point *point)
{
    return mean(point, pairs);
}
