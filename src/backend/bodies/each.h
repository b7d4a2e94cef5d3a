/* All bodies of stage_list.h. */
#ifndef BACKEND_BODIES_EACH_H
#define BACKEND_BODIES_EACH_H

#include "backend/bodies/each_drag.h"
#include "backend/bodies/each_explicit.h"
#include "backend/bodies/each_implicit.h"
#include "backend/bodies/each_obstacle.h"
#include "backend/bodies/each_part.h"
#include "backend/bodies/each_projection.h"

#endif
