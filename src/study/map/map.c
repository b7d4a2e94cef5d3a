/* Judges the cells of a stability map. */
#include "study/products/text.h"
#include "study/map/map.h"

#include "base/memory.h"
#include "study/record.h"
#include "study/report_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Colours of Okabe & Ito, which differ for every kind of colour vision and in grey. */
const struct cell_look cell_looks[CELL_KINDS] = {
    [CELL_STABLE] = {"stable", "done, all steps as long as asked", "#009E73", ""},
    [CELL_SHORTENED] = {"shortened", "done, in steps that the program made shorter", "#A6D8F5", NULL},
    [CELL_STOPPED] = {"stopped", "the program stopped it and says why", "#E69F00", "×"},
    [CELL_WRONG] = {"wrong", "done, but beyond a bound, or crashed", "#A00000", "!"},
    [CELL_LATE] = {"late", "longer than the limit of time", "#999999", "…"},
    [CELL_LEFT_OUT] = {"left out", "no time was left for it", "#FFFFFF", ""},
};

/* Steps from 0 to the end, past every row, none longer than asked: what simulation_step would take. */
static double fewest_steps(const struct scene *scene)
{
    double step = scene->time.step, end = scene->time.end, every = scene->time.measure;
    double sum = 0, slack = 1e-9;
    if (isnan(every))
        every = scene->movie.speed / scene->movie.fps;
    double whole = floor(end / every * (1 + 1e-12) + slack), rest = end - whole * every;
    sum = whole * fmax(ceil(every / step * (1 - slack)), 1);
    if (rest > slack * end)
        sum += fmax(ceil(rest / step * (1 - slack)), 1);
    return sum;
}

static void read_bound(struct map_cell *cell, const struct json *report)
{
    double most = 0;
    for (int k = 0; k < LIMIT_COUNT; k++) {
        char path[64];
        snprintf(path, sizeof path, "limits.%s", limit_words[k]);
        double limit = report_number(report, path);
        cell->limits[k] = isnan(limit) ? INFINITY : limit;
        snprintf(path, sizeof path, "bound.%s", limit_words[k]);
        double steps = report_number(report, path);
        if (k != LIMIT_USER && steps > most) {
            most = steps;
            cell->bound = limit_words[k];
        }
    }
    cell->bound_part = cell->steps > 0 ? most / cell->steps : 0;
    cell->explicit_viscous = report_number(report, "limits.explicit_viscous");
}

/* A run that was killed left no report. */
static enum status read_report(struct map_cell *cell, const char *directory, struct error *e)
{
    struct json report = {0};
    char *path = record_path(cell->point, directory, 0, "json");
    if (!path)
        return error_set(e, STATUS_RUN, "memory is short");
    enum status status = STATUS_OK;
    if (cell->point->outcome != OUTCOME_LEFT_OUT && access(path, R_OK) == 0 &&
        !(status = json_read_file(&report, path, e))) {
        cell->steps = report_number(&report, "steps");
        cell->rejected = report_number(&report, "rejected");
        read_bound(cell, &report);
    }
    json_free(&report);
    free(path);
    return status;
}

/* The first error that is beyond its bound, or is no number. */
static bool find_wrong(struct map_cell *cell)
{
    const struct study_errors *errors = &cell->point->errors;
    for (size_t k = 0; k < errors->count; k++) {
        const struct study_error *error = &errors->items[k];
        char found[64], bound[64];
        if (isnan(error->asked) || fabs(error->value) <= error->asked)
            continue;
        text_error(error->value, error->unit, found, sizeof found);
        text_error(error->asked, error->unit, bound, sizeof bound);
        snprintf(cell->why, sizeof cell->why, "%s is %s, bound %s", error->name, found, bound);
        return true;
    }
    return false;
}

static void judge(struct map_cell *cell)
{
    const struct study_point *point = cell->point;
    snprintf(cell->why, sizeof cell->why, "%s", point->cause);
    switch (point->outcome) {
    case OUTCOME_LEFT_OUT: cell->kind = CELL_LEFT_OUT; return;
    case OUTCOME_STOPPED: cell->kind = CELL_STOPPED; return;
    case OUTCOME_LATE: cell->kind = CELL_LATE; return;
    case OUTCOME_CRASHED: cell->kind = CELL_WRONG; return;
    case OUTCOME_DONE: break;
    }
    cell->kind = find_wrong(cell)                             ? CELL_WRONG
                 : cell->rejected > 0 || cell->steps > cell->fewest ? CELL_SHORTENED
                                                                    : CELL_STABLE;
}

enum status map_make(struct map *map, const struct study_results *results, struct error *e)
{
    const struct study_points *points = results->points;
    const struct study *study = results->study;
    *map = (struct map){.study = study, .columns = study->map[0].count, .rows = study->map[1].count};
    map->cells = memory_create("stability map", points->count, sizeof *map->cells, e);
    if (!map->cells)
        return e->status;
    size_t cells = map->columns * map->rows;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *point = &points->items[k];
        if (!point->ladder) /* the reference run */
            continue;
        size_t method = (size_t)(point->method - study->methods);
        struct map_cell *cell = &map->cells[method * cells + point->rung];
        *cell = (struct map_cell){.point = point, .method = method, .x = point->rung % map->columns,
                                  .y = point->rung / map->columns, .step = point->scene->time.step,
                                  .steps = (double)NAN, .rejected = (double)NAN, .bound = ""};
        for (int i = 0; i < LIMIT_COUNT; i++)
            cell->limits[i] = (double)NAN;
        cell->explicit_viscous = (double)NAN;
        cell->fewest = isnan(cell->step) ? (double)NAN : fewest_steps(point->scene);
        if (read_report(cell, results->directory, e))
            return e->status;
        judge(cell);
        map->count++;
    }
    return STATUS_OK;
}

void map_free(struct map *map)
{
    memory_free(map->cells);
    map->cells = NULL;
}

double map_limit(const struct map *map, size_t method, size_t row, int limit)
{
    const struct map_cell *cells = &map->cells[(method * map->rows + row) * map->columns];
    for (size_t k = 0; k < map->columns; k++) {
        double value = cells[k].limits[limit];
        if (limit == LIMIT_VISCOUS && !isnan(cells[k].explicit_viscous))
            value = cells[k].explicit_viscous;
        if (!isnan(value))
            return value;
    }
    return (double)NAN;
}
