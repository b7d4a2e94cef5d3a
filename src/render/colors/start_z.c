/* Colour by where particles began along z. */
#include "render/colors/start_along.h"

START_ALONG(z, 2);
