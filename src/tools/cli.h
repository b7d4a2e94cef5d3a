/* The command line: options to settings, then a film, a plan, a check or a sub-command. */
#ifndef TOOLS_CLI_H
#define TOOLS_CLI_H

#include "base/error.h"
#include "base/variant.h"
#include "encode/encode.h"
#include "run/run.h"

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

/* Does everything; returns the exit code (enum status). */
int cli_main(int argc, char **argv);

/* What the options of a film said. */
struct cli {
    struct run_options run;
    struct scene_overrides set;
    const char *scene;      /* file */
    bool check, plan, quiet, print_camera;
    struct encode_reference reference;
    struct error error;     /* of the option being read */
    /* Owned: vectors with room for what all arguments can say, and the strings made for them. */
    const char **outputs, **items, **labels, **references;
    double *times;
    char **made;
    size_t made_count;
};

/* A row per option feeds parsing, help and "did you mean". */
struct cli_option {
    const char *name, *arg;
    int key;             /* the letter, or any number above 255 */
    int group;
    const char *doc;
    const char *table;   /* variant table that the value is from, or NULL */
    const char *path;    /* scene key that the option sets, or NULL */
};
extern const struct cli_option cli_options[];
extern const size_t cli_option_count;

enum cli_key { CLI_AT = 256, CLI_SHEET, CLI_CAMERA, CLI_PRINT_CAMERA, CLI_SET, CLI_SIZE, CLI_FPS,
               CLI_END, CLI_SOLVER, CLI_STRICT, CLI_COLOR, CLI_THREADS, CLI_BACKEND, CLI_RENDERER,
               CLI_ISA, CLI_CHECK, CLI_PLAN, CLI_REPORT, CLI_WRITE_SCENE, CLI_REFERENCE,
               CLI_UPDATE, CLI_GATE, CLI_HTML };

/* Reads the options of a film; prints help and version itself. STATUS_USAGE in cli->error. */
enum status cli_parse(struct cli *cli, int argc, char **argv);
void cli_free(struct cli *cli);

/* Fills argp options (zero-terminated, room for cli_option_count + groups + 1) from the table, and
 * gives a row's help text with its choices (malloc), or NULL to keep the text. */
enum { CLI_GROUPS = 5 };
void cli_argp_options(struct argp_option *out);
char *cli_help(int key, const char *text);

/* STATUS_USAGE with "did you mean" when an argument is an option that the table lacks. */
enum status cli_check_names(int argc, char **argv, struct error *e);

/* STATUS_USAGE unless the name is "auto" or a row of the table that is in this build; `what` is how
 * messages call the option. A table that is not in the vocabulary takes any name. */
enum status cli_check_variant(const char *what, const char *table, const char *name,
                              struct error *e);

#endif
