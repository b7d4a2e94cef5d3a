/* The table of options, and what is made from it: argp's table, help, "did you mean". */
#include "base/suggest.h"
#include "scene/keys.h"
#include "tools/cli.h"
#include "tools/tools.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const groups[CLI_GROUPS] = {
    "Output:", "Scene (wins over the file; the last one given wins):", "Machine:",
    "Instead of a film, or besides:", "Messages:"};

const struct cli_option cli_options[] = {
    {"output", "OUT", 'o', 1, "Write OUT, by its ending: film.mp4, .webm, .mkv, .gif, .apng or .y4m "
     "(how: keys of movie), frame-%04d.png, frame.png (with --at), values.csv (measured quantities), - "
     "(y4m to standard output), null (compute only), hash (print index, time, state hash and pixel "
     "hash of each frame). May be given several times: one run, several outputs.",
     NULL, NULL},
    {"at", "T,...", CLI_AT, 1, "No film but a frame of the state at exactly T seconds of scene time, "
     "or at each of several times", NULL, NULL},
    {"sheet", "CxR", CLI_SHEET, 1, "One picture made of C columns and R rows of frames, the time under "
     "each: at the times of --at, or equally far apart; --size is that of a frame", NULL, NULL},
    {"size", "WxH", CLI_SIZE, 1, "Pixels of a frame (movie.size)", NULL, "movie.size"},
    {"fps", "N", CLI_FPS, 1, "Frames per second of film (movie.fps)", NULL, "movie.fps"},

    {"set", "KEY=VALUE", CLI_SET, 2, "Set any key: time.end=2, fluids.0.viscosity=0.1, "
     "domain.walls.-x=periodic. `sph-render list keys' shows them.", NULL, NULL},
    {"end", "T", CLI_END, 2, "Stop at T seconds (time.end)", NULL, "time.end"},
    {"solver", "NAME", CLI_SOLVER, 2, "Pressure solver (solver.method)", "solvers",
     "solver.method"},
    {"camera", "\"KEY=VALUE ...\"", CLI_CAMERA, 2, "Camera of this run: \"eye=3,1,3 target=0.8,0.5,0.3 "
     "fov=40\", or any other key of camera; an eye replaces the scene's keyframes", NULL, "camera"},
    {"strict", NULL, CLI_STRICT, 2, "Stop with an error where a limit asks for a shorter step than "
     "time.step, instead of taking it; steps that end at a frame's time may be shorter", NULL, NULL},
    {"color", "NAME", CLI_COLOR, 2, "Quantity shown (color.by)", "colors", "color.by"},

    {"threads", "N", CLI_THREADS, 3, "Threads; 0, the default: one per processor", NULL, NULL},
    {"backend", "NAME", CLI_BACKEND, 3, "Where particles are computed; cuda:N is device N, cuda:N:B with B "
     "threads a block of sums over neighbours",
     "backends", NULL},
    {"renderer", "NAME", CLI_RENDERER, 3, "What draws frames", "renderers", NULL},
    {"isa", "NAME", CLI_ISA, 3, "Vector instructions of the CPU; all give the same bits", "isas",
     NULL},

    {"check", NULL, CLI_CHECK, 4, "Check the scene and stop; nothing is computed or written", NULL, NULL},
    {"plan", NULL, CLI_PLAN, 4, "Print what would be computed, and what is left out and why; stop",
     NULL, NULL},
    {"report", "FILE.json", CLI_REPORT, 4, "Write machine, scene in force, steps, times by phase and state hashes of the run", NULL, NULL},
    {"write-scene", "FILE.json", CLI_WRITE_SCENE, 4, "Write the scene in force, every key with its "
     "value; - is standard output", NULL, NULL},
    {"reference", "DIR", CLI_REFERENCE, 4, "Compare each frame with DIR/frame-0000.png and so on "
     "(DIR/frame.png with --at; or name them as for -o, x-%04d.png); exit code 1 when one differs. May "
     "be given several times: any will do.", NULL, NULL},
    {"update", NULL, CLI_UPDATE, 4, "Accept the frames: write them to the --reference", NULL, NULL},
    {"gate", "NAME", CLI_GATE, 4, "Limits for --reference: same-stack (default), exact, "
     "cross-driver; `sph-render list gates' says what they are", NULL, NULL},
    {"html", "FILE|DIR", CLI_HTML, 4, "Write a page that shows the frames beside the accepted ones",
     NULL, NULL},

    {"print-camera", NULL, CLI_PRINT_CAMERA, 4, "Print the camera at the first frame, or at the "
     "times of --at, as text for a scene file", NULL, NULL},

    {"quiet", NULL, 'q', 5, "Only errors", NULL, NULL},
    {"verbose", NULL, 'v', 5, "More details", NULL, NULL},
};
const size_t cli_option_count = sizeof cli_options / sizeof *cli_options;

void cli_argp_options(struct argp_option *out)
{
    int group = 0;
    for (size_t i = 0; i < cli_option_count; i++) {
        const struct cli_option *o = &cli_options[i];
        if (o->group != group) {
            group = o->group;
            *out++ = (struct argp_option){.doc = groups[group - 1], .group = group};
        }
        *out++ = (struct argp_option){o->name, o->key, o->arg, 0, o->doc, o->group};
    }
    *out = (struct argp_option){0};
}

static void print_choices(FILE *out, const struct variant_table *table)
{
    fputs(": auto", out);
    for (size_t i = 0; i < table->count; i++)
        fprintf(out, ", %s%s", table->rows[i]->name,
                table->rows[i]->missing ? " (not in this build)" : "");
}

/* Below the options: the sub-commands, examples and exit codes. */
static void print_post(FILE *out)
{
    fputs("Sub-commands:\n", out);
    for (size_t i = 0; i < tool_table.count; i++)
        fprintf(out, "  sph-render %-10s %s\n", tool_table.rows[i]->name, tool_table.rows[i]->doc);
    fputs("\nExamples:\n"
          "  sph-render scenes/dambreak.json -o dam.mp4\n"
          "  sph-render scenes/dambreak.json --at 0.5 -o dam.png\n"
          "  sph-render scenes/dambreak.json --sheet 3x2 --size 640x360 -o sheet.png\n"
          "  sph-render scenes/dambreak.json --end 1 --fps 10 -o 'dam-%03d.png' -o hash\n"
          "  sph-render scenes/dambreak.json -o - | ffplay -\n"
          "  sph-render scenes/dambreak.json --plan\n"
          "  sph-render scenes/dambreak.json --set particles.spacing=0.01 -o fine.mp4\n"
          "  sph-render scenes/dambreak.json --reference accepted --html page.html\n"
          "  sph-render bench scenes/bench/dambreak-50k.json --threads 1\n\n"
          "Exit codes: 0 done, 1 run failed or frames differ, 2 usage or scene, 3 no renderer or encoder, 4 output "
          "or disk, 130 interrupted.", out);
}

char *cli_help(int key, const char *text)
{
    const struct variant_table *table = NULL;
    bool chooses = false;
    for (size_t i = 0; i < cli_option_count; i++)
        if (cli_options[i].key == key && cli_options[i].table) {
            table = vocabulary_table(&run_vocabulary, cli_options[i].table);
            chooses = !cli_options[i].path;
        }
    bool post = key == ARGP_KEY_HELP_POST_DOC;
    if (!post && !table)
        return NULL;
    char *made = NULL;
    size_t size;
    FILE *out = open_memstream(&made, &size);
    if (!out)
        return NULL;
    if (post) {
        print_post(out);
    } else if (chooses) {
        fputs(text, out);
        print_choices(out, table);
    } else {
        fprintf(out, "%s:", text);
        for (size_t i = 0; i < table->count; i++)
            fprintf(out, "%s %s", i ? "," : "", table->rows[i]->name);
    }
    fclose(out);
    return made;
}

static const struct cli_option *option_by_letter(int letter)
{
    for (size_t i = 0; i < cli_option_count; i++)
        if (cli_options[i].key == letter)
            return &cli_options[i];
    return NULL;
}

/* Whether the long name, or its beginning, is known; *takes: its value is the next argument. */
static bool long_known(const char *name, struct suggest *near, bool *takes)
{
    static const char *const argp_names[] = {"help", "usage", "version"};
    size_t length = strcspn(name, "=");
    bool known = false;
    for (size_t i = 0; i < cli_option_count; i++) {
        suggest_offer(near, cli_options[i].name);
        if (strncmp(cli_options[i].name, name, length) == 0) {
            known = true;
            *takes = cli_options[i].arg && !name[length];
        }
    }
    for (size_t i = 0; i < sizeof argp_names / sizeof *argp_names; i++) {
        suggest_offer(near, argp_names[i]);
        known |= strncmp(argp_names[i], name, length) == 0;
    }
    return known;
}

/* Whether the letters end in an option whose value is the next argument. */
static bool letters_take(const char *letters)
{
    for (; *letters; letters++) {
        const struct cli_option *o = option_by_letter((unsigned char)*letters);
        if (o && o->arg)
            return letters[1] == '\0';
    }
    return false;
}

enum status cli_check_names(int argc, char **argv, struct error *e)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        bool takes = false;
        struct suggest near;
        char name[64];
        if (argv[i][0] != '-')
            continue;
        if (argv[i][1] != '-') {
            i += letters_take(argv[i] + 1);
            continue;
        }
        snprintf(name, sizeof name, "%.*s", (int)strcspn(argv[i] + 2, "="), argv[i] + 2);
        suggest_start(&near, name);
        if (!long_known(argv[i] + 2, &near, &takes)) {
            const char *best = suggest_best(&near);
            return error_set(e, STATUS_USAGE, "unknown option --%s%s%s%s", name,
                             best ? "; did you mean --" : "; `sph-render --help' shows all",
                             best ? best : "", best ? "?" : "");
        }
        i += takes;
    }
    return STATUS_OK;
}

enum status cli_check_variant(const char *what, const char *table_name, const char *name,
                              struct error *e)
{
    const struct variant_table *table = vocabulary_table(&run_vocabulary, table_name);
    if (!table || strcmp(name, "auto") == 0)
        return STATUS_OK;
    const struct variant *row = variant_find(table, name);
    if (row && row->missing)
        return error_set(e, STATUS_USAGE, "%s %s is not in this build: %s", what, name,
                         row->missing);
    if (row)
        return STATUS_OK;
    struct suggest near;
    char known[500] = "auto";
    suggest_start(&near, name);
    for (size_t i = 0; i < table->count; i++) {
        size_t n = strlen(known);
        snprintf(known + n, sizeof known - n, ", %s", table->rows[i]->name);
        suggest_offer(&near, table->rows[i]->name);
    }
    const char *best = suggest_best(&near);
    return error_set(e, STATUS_USAGE, "%s %s is unknown%s%s%s; known: %s", what, name,
                     best ? "; did you mean " : "", best ? best : "", best ? "?" : "", known);
}
