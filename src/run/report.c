/* Writes the report of a run. */
#include "run/report.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/quote.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

double report_pass_seconds(const struct backend_counts *counts)
{
    double sum = 0;
    for (int p = 0; p < PASS_COUNT; p++)
        sum += counts->seconds[p];
    return sum;
}

const char *report_processor(void)
{
    static char model[256] = "unknown processor";
    char line[512];
    FILE *f = fopen("/proc/cpuinfo", "r");
    while (f && fgets(line, sizeof line, f)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) == 0 && colon) {
            colon[strcspn(colon, "\n")] = 0;
            snprintf(model, sizeof model, "%.200s", colon + 2);
            break;
        }
    }
    if (f)
        fclose(f);
    return model;
}

static void write_memory(void *context, const char *label, size_t bytes)
{
    fprintf(context, ", \"%s\": %zu", label, bytes);
}

static void write_phases(FILE *f, const struct report *r, const struct backend_counts *counts)
{
    fprintf(f, "  \"seconds\": {\"wall\": %.6f, \"cpu\": %.6f, \"solve\": %.6f, \"wait\": %.6f, "
               "\"draw\": %.6f, \"encode\": %.6f",
            r->wall, clock_cpu_seconds(), r->solve, r->film.wait, r->film.draw, r->film.encode);
    if (r->row_count)
        fprintf(f, ", \"measure\": %.6f", r->measure);
    for (int p = 0; p < PASS_COUNT; p++)
        if (counts->runs[p])
            fprintf(f, ", \"%s\": %.6f", pass_table[p].name, counts->seconds[p]);
    fputs("},\n", f);
}

static void write_solves(FILE *f, const struct simulation *s)
{
    static const char *const names[] = {[SOLVE_VELOCITY] = "velocity", [SOLVE_SHIFT] = "shift",
                                        [SOLVE_VISCOSITY] = "viscosity"};
    double tries = (double)(s->stats.steps + s->stats.rejected);
    fputs("  \"solves\": {", f);
    int count = s->plan->choice.implicit_viscosity ? SOLVE_COUNT : SOLVE_VISCOSITY;
    for (int k = 0; k < count; k++) {
        const struct solve_stats *solve = &s->stats.solves[k];
        fprintf(f, "%s\"%s\": {\"sweeps\": %ld, \"mean\": %.3f, \"most\": %d, \"unsolved\": %ld, "
                   "\"residual\": %.4g}",
                k ? ", " : "", names[k], solve->sweeps,
                tries > 0 ? (double)solve->sweeps / tries : 0, solve->most, solve->unsolved,
                solve->residual);
    }
    fputs("},\n", f);
}

/* The limits of the time step at the start, and how many steps each of them bound. */
static void write_limits(FILE *f, const struct simulation *s)
{
    const struct solver_choice *c = &s->plan->choice;
    const char *comma = "";
    fputs("  \"limits\": {", f);
    for (int k = 0; k < LIMIT_COUNT; k++)
        if (isfinite(s->stats.limits[k])) {
            fprintf(f, "%s\"%s\": %.9g", comma, limit_words[k], s->stats.limits[k]);
            comma = ", ";
        }
    if (c->implicit_viscosity) /* what it would be by explicit steps */
        fprintf(f, "%s\"explicit_viscous\": %.9g", comma, c->viscous_step);
    fputs("},\n  \"bound\": {", f);
    comma = "";
    for (int k = 0; k < LIMIT_COUNT; k++)
        if (s->stats.bound[k]) {
            fprintf(f, "%s\"%s\": %ld", comma, limit_words[k], s->stats.bound[k]);
            comma = ", ";
        }
    fputs("},\n", f);
}

/* "done", or the message of what ended the run early. */
static void write_end(FILE *f, const struct error *end)
{
    char text[2 * sizeof end->text];
    json_quote(end->status ? end->text : "done", text, sizeof text);
    fprintf(f, "  \"end\": %s,\n", text);
}

static void write_body(FILE *f, const struct report *r, struct simulation *s)
{
    const struct backend_counts *counts = s->row->counts(s->backend);
    double steps = (double)s->stats.steps, n = (double)s->plan->bodies.count;
    fprintf(f, "{\n  \"program\": \"sph-render %s\",\n  \"compiler\": \"%s\",\n", SPH_VERSION,
            __VERSION__);
    fprintf(f, "  \"machine\": {\"processor\": \"%s\", \"processors\": %d},\n", report_processor(),
            omp_get_num_procs());
    fprintf(f, "  \"backend\": \"%s\",\n", s->row->describe(s->backend));
    write_end(f, &r->end);
    if (r->renderer)
        fprintf(f, "  \"renderer\": \"%s\",\n", r->renderer);
    fprintf(f, "  \"particles\": %zu,\n  \"wall_particles\": %zu,\n", s->plan->bodies.count,
            s->plan->walls.count);
    fprintf(f, "  \"steps\": %ld,\n  \"rejected\": %ld,\n  \"sorts\": %ld,\n", s->stats.steps,
            s->stats.rejected, s->stats.sorts);
    if (steps > 0 && n > 0)
        fprintf(f, "  \"dt\": {\"min\": %.9g, \"mean\": %.9g, \"max\": %.9g},\n", s->stats.dt_min,
                s->stats.dt_sum / steps, s->stats.dt_max);
    if (n > 0)
        write_limits(f, s);
    if (n > 0)
        fprintf(f, "  \"sound_speed\": %.9g,\n", s->plan->choice.sound_speed);
    fprintf(f, "  \"pairs\": %.0f,\n", counts->pairs);
    if (steps > 0 && n > 0)
        fprintf(f, "  \"ns_per_particle_step\": %.3f,\n", r->solve * 1e9 / steps / n);
    if (s->plan->choice.is_implicit)
        write_solves(f, s);
    if (r->row_count)
        fprintf(f, "  \"measured\": {\"rows\": %ld, \"columns\": %zu, \"every\": %.9g},\n",
                r->row_count, s->plan->measures.column_count, s->plan->measures.interval);
    write_phases(f, r, counts);
    fprintf(f, "  \"bytes\": {\"peak\": %zu", memory_peak());
    memory_each(write_memory, f);
    fputs("},\n  \"frames\": [", f);
    for (size_t k = 0; k < r->frame_count; k++)
        fprintf(f, "%s\n    {\"index\": %ld, \"time\": %.9g, \"state\": \"%016llx\"}", k ? "," : "",
                r->frames[k].index, r->frames[k].time,
                (unsigned long long)r->frames[k].state_hash);
    fputs("],\n  \"scene\": ", f);
    scene_write(s->plan->scene, &run_vocabulary, f);
    fputs("}\n", f);
}

enum status report_write(const char *path, const struct report *report, struct simulation *s,
                         struct error *e)
{
    struct output_file file;
    if (output_open(&file, path, e))
        return e->status;
    write_body(file.stream, report, s);
    if (output_close(&file, true, e))
        return error_context(e, "the report was not written");
    return STATUS_OK;
}
