/* What a sub-command is: a row with a name, a doc line, and a main function of its own. */
#ifndef TOOLS_TOOLS_H
#define TOOLS_TOOLS_H

#include "base/variant.h"

struct tool {
    struct variant variant;
    int (*run)(int argc, char **argv); /* argv[0] is the sub-command; returns an exit code */
};

#endif
