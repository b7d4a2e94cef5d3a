/* The sub-commands: sph-render NAME ... */
#ifndef TOOLS_TOOLS_H
#define TOOLS_TOOLS_H

#include "base/variant.h"

struct tool {
    struct variant variant;
    /* argv[0] is the sub-command's name; returns the exit code, enum status unless it says so. */
    int (*run)(int argc, char **argv);
};

extern const struct variant_table tool_table; /* "commands" */

#endif
