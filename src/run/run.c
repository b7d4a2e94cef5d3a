/* Runs a scene: advances to each frame's time, hands snapshots to the film, reports. */
#include "run/run.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "run/frame.h"
#include "run/report.h"
#include "run/step.h"
#include "run/video.h"

#include <inttypes.h>
#include <math.h>
#include <omp.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static volatile sig_atomic_t interrupts;

static void on_interrupt(int signal_number)
{
    (void)signal_number;
    if (++interrupts > 1)
        _exit(STATUS_INTERRUPTED);
}

/* Chosen times: number k is at start + k * step, or of a list. */
struct schedule {
    const double *times; /* s; NULL: start and step count */
    double start, step;  /* s */
    long count, done;
};

/* Up to and with the end. */
static struct schedule schedule_make(double start, double step, double end)
{
    struct schedule s = {.start = start, .step = step};
    s.count = 1 + (long)floor((end - start) / step * (1 + 1e-12) + 1e-9);
    if (s.count < 0)
        s.count = 0;
    return s;
}

/* `count` times equally far apart, from the start to the end; one is the end. */
static struct schedule schedule_spread(double start, double end, long count)
{
    if (count == 1)
        return (struct schedule){.start = end, .count = 1};
    return (struct schedule){.start = start, .step = (end - start) / (double)(count - 1),
                             .count = count};
}

static double schedule_time(const struct schedule *s, long k)
{
    return s->times ? s->times[k] : s->start + (double)k * s->step;
}

/* The next time that is not done; INFINITY when all are. */
static double schedule_next(const struct schedule *s)
{
    return s->done < s->count ? schedule_time(s, s->done) : (double)INFINITY;
}

struct session {
    struct plan plan;
    struct simulation simulation;
    struct film *film;
    struct report report;
    struct schedule frames, rows;
    double end;  /* s */
    bool hashes; /* somebody wants those of states */
};

/* Frames from movie.start on, rows from 0 on; of pictures at single times one row each. */
static void session_schedule(struct session *x, const struct scene *scene,
                             const struct run_options *options)
{
    double start = scene->movie.start, end = scene->time.end;
    bool film = !options->time_count && !options->sheet[0];
    if (film)
        x->frames = schedule_make(start, scene->movie.speed / scene->movie.fps, end);
    else if (options->time_count)
        x->frames = (struct schedule){.times = options->times, .count = (long)options->time_count};
    else
        x->frames = schedule_spread(start, end, (long)options->sheet[0] * options->sheet[1]);
    x->end = film ? end : schedule_time(&x->frames, x->frames.count - 1);
    if (x->plan.measures.count)
        x->rows = film ? schedule_make(0, x->plan.measures.interval, end) : x->frames;
}

static enum status advance(struct session *x, double target, struct error *e)
{
    double start = clock_seconds(), end = x->end;
    struct simulation *s = &x->simulation;
    char note[96];
    while (s->time < target) {
        if (interrupts)
            return error_set(e, STATUS_INTERRUPTED, "interrupted at t = %.4g s", s->time);
        if (simulation_step(s, target, e))
            return e->status;
        snprintf(note, sizeof note, "t %.3f s, frame %zu, %ld steps", s->time,
                 x->report.frame_count, s->stats.steps);
        log_progress(s->time, end > 0 ? end : 1, note);
    }
    x->report.solve += clock_seconds() - start;
    return STATUS_OK;
}

static enum status emit(struct session *x, long index, struct error *e)
{
    struct simulation *s = &x->simulation;
    struct film_snapshot *snapshot;
    if (film_snapshot_create(x->film, frame_count(&x->plan), &snapshot, e))
        return e->status;
    snapshot->index = index;
    snapshot->time = s->time;
    if ((x->hashes && s->row->hash(s->backend, &snapshot->state_hash, e)) ||
        (x->plan.draws && frame_fill(s, snapshot, e))) {
        film_snapshot_free(x->film, snapshot);
        return e->status;
    }
    x->report.frames[x->report.frame_count++] =
        (struct report_frame){index, s->time, snapshot->state_hash};
    return film_frame(x->film, snapshot, e);
}

static enum status measure(struct session *x, struct error *e)
{
    double start = clock_seconds();
    struct simulation *s = &x->simulation;
    const struct plan *plan = &x->plan;
    const unsigned fields = plan->measures.reads | PARTICLES_HASHED | FIELD_BIT(FIELD_FLUID);
    const struct particles *p = s->row->state(s->backend, fields, e);
    if (!p)
        return e->status;
    const double *row = measures_take(&x->plan.measures, plan->scene, &plan->space, &plan->choice, p,
                                      s->time);
    if (film_row(x->film, row, e))
        return e->status;
    x->report.row_count++;
    x->report.measure += clock_seconds() - start;
    return STATUS_OK;
}

/* Stops at the times of frames and of rows; times that differ only by rounding are one. */
static enum status run_times(struct session *x, struct error *e)
{
    double frame, row;
    while (frame = schedule_next(&x->frames), row = schedule_next(&x->rows),
           isfinite(fmin(frame, row))) {
        double slack = 1e-12 * x->end, target = frame <= row + slack ? frame : row;
        if (advance(x, target, e))
            return e->status;
        if (row <= target + slack) {
            x->rows.done++;
            if (measure(x, e))
                return e->status;
        }
        if (frame <= target && emit(x, x->frames.done++, e))
            return e->status;
    }
    return advance(x, x->end, e);
}

/* How values spread, where the scene does not say. */
static void say_range(const struct plan *plan, const struct render_setup *render)
{
    const struct scene *scene = plan->scene;
    if (plan->draws && isnan(scene->color.range[0]) && isnan(scene->color.percentiles[0]) && !render->solid &&
        !render->scale.counts)
        log_info("colour range %.4g to %.4g %s: %s", render->scale.range[0], render->scale.range[1],
                 render->unit, plan->color->estimate);
}

static enum status film_start(struct session *x, const struct run_options *options,
                              struct error *e)
{
    const struct plan *plan = &x->plan;
    const struct scene *scene = plan->scene;
    static struct render_setup render; /* the film keeps a pointer to it */
    render = frame_setup(plan, options);
    say_range(plan, &render);
    char crf[VIDEO_NUMBER], comment[100];
    snprintf(comment, sizeof comment, "sph-render %s, scene %016" PRIx64, SPH_VERSION,
             scene_hash(scene, &run_vocabulary));
    struct film_setup setup = {.scene = scene,
                               .comment = comment,
                               .video = video_of_scene(scene, crf),
                               .render = plan->draws ? &render : NULL,
                               .outputs = options->outputs,
                               .output_count = options->output_count,
                               .columns = plan->measures.columns,
                               .column_count = plan->measures.column_count,
                               .sheet = {options->sheet[0], options->sheet[1]},
                               .single = options->time_count == 1 || options->sheet[0],
                               .frame_count = x->frames.count,
                               .reference = options->reference};
    if (plan->draws)
        setup.source = frame_source(plan, plan->backend);
    video_warn(scene, &setup.video, options->outputs, options->output_count);
    return film_open(&x->film, &setup, e);
}

void run_warn_threads(int threads)
{
    int processors = omp_get_num_procs();
    if (threads > processors)
        log_info("warning: %d threads on %d processor%s wait for each other; use --threads %d, or 0",
                 threads, processors, processors == 1 ? "" : "s", processors);
}

static void say_choices(const struct session *x)
{
    const struct solver_choice *c = &x->plan.choice;
    const struct simulation *s = &x->simulation;
    char sound[48] = "";
    if (x->plan.bodies.count == 0)
        log_info("no particles: the scene has no bodies, so nothing moves");
    else if (c->sound_speed > 0)
        snprintf(sound, sizeof sound, "sound speed %.4g m/s, ", c->sound_speed);
    if (x->plan.bodies.count > 0)
        log_info("%zu particles, %s on %s, support %.3g spacings, %sstep %.3g s",
                 x->plan.bodies.count, x->plan.solver->variant.name,
                 s->row->describe(s->backend), c->support / c->spacing, sound, s->last_dt);
    if (film_renderer(x->film))
        log_info("renderer %s", film_renderer(x->film));
    if (x->plan.scene->measure_count && !x->plan.measures.count)
        log_info("the scene's measures are not written: no output is a csv file; add -o FILE.csv");
}

static void say_results(const struct session *x)
{
    const struct simulation *s = &x->simulation;
    double n = (double)x->plan.bodies.count, steps = (double)s->stats.steps;
    log_info("%zu frame%s, %ld steps (%ld rejected), %.1f s: solve %.1f s (%.0f ns per particle and "
             "step), draw %.1f s, encode %.1f s",
             x->report.frame_count, x->report.frame_count == 1 ? "" : "s", s->stats.steps,
             s->stats.rejected, x->report.wall,
             x->report.solve, n > 0 && steps > 0 ? x->report.solve * 1e9 / n / steps : 0.0,
             x->report.film.draw, x->report.film.encode);
}

/* Ends the film, and keeps what an interrupted or stopped run has; a failed output cannot. */
static void finish(struct session *x, const struct run_options *options, double start,
                   struct error *e)
{
    static char renderer[256];
    struct error closing = {STATUS_OK, ""};
    bool keep = e->status == STATUS_OK || e->status == STATUS_INTERRUPTED ||
                e->status == STATUS_RUN;
    keep = keep && x->report.frame_count + (size_t)x->report.row_count > 0;
    if (film_renderer(x->film)) {
        snprintf(renderer, sizeof renderer, "%s", film_renderer(x->film));
        x->report.renderer = renderer;
    }
    if (film_close(x->film, keep, &x->report.film, &closing) &&
        (e->status == STATUS_OK || e->status == STATUS_INTERRUPTED))
        *e = closing;
    log_progress_end();
    x->report.wall = clock_seconds() - start;
    x->report.end = *e;
    if (e->status == STATUS_INTERRUPTED)
        log_info("%s", e->text);
    if (e->status == STATUS_OK || e->status == STATUS_INTERRUPTED)
        say_results(x);
    if (options->report && e->status != STATUS_OUTPUT && e->status != STATUS_USAGE &&
        report_write(options->report, &x->report, &x->simulation, &closing) &&
        e->status == STATUS_OK)
        *e = closing;
}

static enum status session_run(struct session *x, const struct run_options *options,
                               struct error *e)
{
    double start = clock_seconds();
    struct error closing;
    x->plan.backend = simulation_backend(&x->plan, options);
    x->hashes = options->report || film_wants_hashes(options->outputs, options->output_count);
    x->report.frames =
        memory_create("report", (size_t)x->frames.count + 1, sizeof *x->report.frames, e);
    if (!x->report.frames || film_start(x, options, e))
        return e->status;
    bool open = simulation_open(&x->simulation, &x->plan, options, e) == STATUS_OK;
    /* the scene once nothing of what was asked for is refused */
    if (!open || (options->write_scene && scene_save(x->plan.scene, &run_vocabulary, options->write_scene, e))) {
        film_close(x->film, false, NULL, &closing);
        if (open)
            simulation_close(&x->simulation);
        return e->status;
    }
    say_choices(x);
    struct step last = {0};
    if (run_times(x, e) == STATUS_OK && step_settle(&x->simulation, &last, e) == STATUS_OK)
        e->status = STATUS_OK;
    finish(x, options, start, e);
    simulation_close(&x->simulation);
    return e->status;
}

/* Signals that end a film early, but whole; a reader of our output who leaves is an error of that
 * output. One that the caller ignores, as nohup does with SIGHUP, stays ignored, except SIGINT,
 * which shells ignore for every background job. */
static void catch_signals(bool on)
{
    static const struct {
        int number;
        void (*handler)(int);
    } rows[] = {{SIGINT, on_interrupt}, {SIGTERM, on_interrupt}, {SIGHUP, on_interrupt},
                {SIGPIPE, SIG_IGN}};
    static struct sigaction before[sizeof rows / sizeof *rows];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sigaction action = {.sa_handler = rows[i].handler};
        if (!on)
            sigaction(rows[i].number, &before[i], NULL);
        else if (sigaction(rows[i].number, NULL, &before[i]) == 0 &&
                 (before[i].sa_handler != SIG_IGN || rows[i].number == SIGINT))
            sigaction(rows[i].number, &action, NULL);
    }
    interrupts = 0;
}

enum status run_scene(const struct scene *scene, const struct run_options *options,
                      struct error *e)
{
    struct session x = {0};
    e->status = STATUS_OK;
    if (options->report && output_check(options->report, e))
        return e->status;
    if (plan_make(&x.plan, scene, options, e))
        return e->status;
    run_warn_threads(options->threads);
    session_schedule(&x, scene, options);
    catch_signals(true);
    session_run(&x, options, e);
    catch_signals(false);
    memory_free(x.report.frames);
    plan_free(&x.plan);
    return e->status;
}

enum status run_check(const struct scene *scene, const struct run_options *options,
                      struct error *e)
{
    return plan_check(scene, options, e);
}

enum status run_plan(const struct scene *scene, const struct run_options *options, FILE *out,
                     struct error *e)
{
    struct plan plan;
    e->status = STATUS_OK;
    if (plan_make(&plan, scene, options, e))
        return e->status;
    plan_write(&plan, out);
    plan_free(&plan);
    return STATUS_OK;
}
