/* No start flow: a body has its own velocity alone. */
#include "particles/flows.h"

const struct flow_row flow_none = {
    .variant = {.name = "none", .doc = "bodies[].velocity alone"},
};
