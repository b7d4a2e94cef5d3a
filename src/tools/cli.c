/* Chooses between a sub-command and a film, and runs it. */
#include "tools/cli.h"
#include "base/log.h"
#include "base/output.h"
#include "base/suggest.h"
#include "encode/encode.h"
#include "render/camera.h"
#include "tools/tools.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void print_version(FILE *out, struct argp_state *state)
{
    (void)state;
    fprintf(out, "sph-render %s (EGL %d, OSMesa %d, libav %d, cairo %d, CUDA %d)\n", SPH_VERSION,
            HAVE_EGL, HAVE_OSMESA, HAVE_LIBAV, HAVE_CAIRO, HAVE_CUDA);
}

/* A mistyped sub-command looks like a scene file that is not there. */
static enum status check_scene_name(const struct cli *cli, struct error *e)
{
    struct suggest near;
    if (!cli->scene)
        return error_set(e, STATUS_USAGE, "no scene; for example: sph-render scenes/dambreak.json "
                         "-o dam.mp4 (--help shows more)");
    if (access(cli->scene, F_OK) == 0)
        return STATUS_OK;
    suggest_start(&near, cli->scene);
    for (size_t i = 0; i < tool_table.count; i++)
        suggest_offer(&near, tool_table.rows[i]->name);
    const char *best = suggest_best(&near);
    if (best)
        return error_set(e, STATUS_USAGE, "%s: there is no such scene file; did you mean the "
                         "sub-command `sph-render %s'?", cli->scene, best);
    return STATUS_OK;
}

/* A film on standard output is alone there. */
static enum status check_pipe(const struct cli *cli, struct error *e)
{
    const char *other = cli->print_camera ? "--print-camera" : NULL;
    bool piped = false;
    if (cli->run.write_scene && strcmp(cli->run.write_scene, "-") == 0)
        other = "--write-scene -";
    for (size_t i = 0; i < cli->run.output_count; i++) {
        piped |= strcmp(cli->outputs[i], "-") == 0;
        if (strcmp(cli->outputs[i], "hash") == 0)
            other = "-o hash";
    }
    return piped && other ? error_set(e, STATUS_USAGE, "-o - and %s both write to standard output; "
                                      "name a file for one", other) : STATUS_OK;
}

/* What is written must not replace the scene, or what else is written. */
static enum status check_files(const struct cli *cli, struct error *e)
{
    const size_t count = cli->run.output_count;
    const struct { const char *option, *path; } others[] = {
        {"the scene", cli->scene}, {"--report", cli->run.report}, {"--write-scene", cli->run.write_scene},
        {"--html", cli->reference.page}};
    const size_t other_count = sizeof others / sizeof *others;
    for (size_t i = 1; i < other_count + count; i++) {
        const bool output = i >= other_count;
        const char *option = output ? "-o" : others[i].option;
        const char *path = output ? cli->outputs[i - other_count] : others[i].path;
        struct error ignored;
        const struct encoder_row *row = output ? encode_find(path, &ignored) : NULL;
        if (!path || strcmp(path, "-") == 0 || (row && !encode_is_file(row, path)))
            continue;
        for (size_t k = 0; k < i && k < other_count; k++)
            if (others[k].path && output_same(path, others[k].path))
                return error_set(e, STATUS_USAGE, "%s %s: it is %s, too; choose another name", option, path,
                                 others[k].option);
    }
    return STATUS_OK;
}

static enum status check_outputs(const struct cli *cli, struct error *e)
{
    for (size_t i = 0; i < cli->run.output_count; i++) {
        if (!cli->outputs[i][0])
            return error_set(e, STATUS_USAGE, "-o: the name is empty; give for example film.mp4");
        for (size_t j = 0; j < i; j++)
            if (strcmp(cli->outputs[i], cli->outputs[j]) == 0)
                return error_set(e, STATUS_USAGE, "-o %s is given twice", cli->outputs[i]);
    }
    if (check_files(cli, e))
        return e->status;
    if (cli->run.output_count || cli->check || cli->plan || cli->run.report ||
        cli->run.write_scene || cli->print_camera)
        return STATUS_OK;
    return error_set(e, STATUS_USAGE, "no output; add -o film.mp4, -o 'frame-%%04d.png', "
                     "-o values.csv, -o null or -o hash; or --reference DIR, --check, --plan or "
                     "--report FILE.json");
}

static void print_camera(const struct cli *cli, const struct scene *scene)
{
    const double *times = cli->run.time_count ? cli->times : &scene->movie.start;
    camera_write(scene, scene->render.radius * scene->particles.spacing, times,
                 cli->run.time_count ? cli->run.time_count : 1, stdout);
}

static enum status film(const struct cli *cli, const struct scene *scene, struct error *e)
{
    bool run = !cli->check && !cli->plan && (cli->run.output_count || cli->run.report);
    double last = cli->run.time_count ? cli->times[cli->run.time_count - 1] : 0;
    if (last > scene->time.end)
        return error_set(e, STATUS_USAGE, "--at %g is after the end of the scene at %g s; add "
                         "--end %g", last, scene->time.end, last);
    if (cli->print_camera)
        print_camera(cli, scene);
    if (run)
        return run_scene(scene, &cli->run, e);
    if (cli->plan ? run_plan(scene, &cli->run, stdout, e) : cli->check ? run_check(scene, &cli->run, e) : STATUS_OK)
        return e->status;
    if (cli->check && !cli->plan && !cli->quiet)
        printf("%s: ok\n", cli->scene);
    return cli->run.write_scene ? scene_save(scene, &run_vocabulary, cli->run.write_scene, e) : STATUS_OK;
}

static enum status film_main(int argc, char **argv, struct error *e)
{
    struct cli cli;
    struct scene *scene = NULL;
    enum status status = cli_parse(&cli, argc, argv);
    if (status)
        *e = cli.error;
    if (!status)
        status = check_scene_name(&cli, e);
    if (!status)
        status = check_outputs(&cli, e);
    if (!status)
        status = check_pipe(&cli, e);
    if (!status)
        status = scene_load(&scene, cli.scene, &cli.set, &run_vocabulary, e);
    if (!status)
        status = film(&cli, scene, e);
    scene_free(scene);
    cli_free(&cli);
    return status;
}

static int exit_code; /* that the program would end with; 0 where argp ends it after --help */

/* At exit, wherever that is: what was printed may not have arrived, on a full disk for example. */
static void check_printed(void)
{
    errno = 0;
    if ((fflush(stdout) == 0 && !ferror(stdout)) || exit_code != STATUS_OK)
        return;
    log_error("standard output cannot be written%s%s", errno ? ": " : "", errno ? strerror(errno) : "");
    _exit(STATUS_OUTPUT);
}

int cli_main(int argc, char **argv)
{
    struct error e = {.status = STATUS_OK};
    argp_err_exit_status = STATUS_USAGE;
    argp_program_version_hook = print_version;
    atexit(check_printed);
    signal(SIGXFSZ, SIG_IGN); /* a file over `ulimit -f' is an error like a full disk */
    const struct variant *row = argc > 1 ? variant_find(&tool_table, argv[1]) : NULL;
    if (row)
        return exit_code = ((const struct tool *)row)->run(argc - 1, argv + 1);
    enum status status = film_main(argc, argv, &e);
    if (status && status != STATUS_INTERRUPTED)
        log_error("%s", e.text);
    return exit_code = (int)status;
}
