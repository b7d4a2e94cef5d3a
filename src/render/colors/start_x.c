/* Colour by where particles began along x. */
#include "render/colors/start_along.h"

START_ALONG(x, 0);
