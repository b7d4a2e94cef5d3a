/* sph-render compare: are two pictures the same, by how much not, and where. */
#ifndef TOOLS_COMPARE_H
#define TOOLS_COMPARE_H

#include "tools/tools.h"

/* Exit codes: 0 same, 1 different (also in size), 2 error (file or usage). */
extern const struct tool tool_compare;

#endif
