/* Colour by where particles began along y. */
#include "render/colors/start_along.h"

START_ALONG(y, 1);
