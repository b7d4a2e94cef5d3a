/* Of the model of a GPU: see cooperative_groups.h. */
#include "cooperative_groups.h"
