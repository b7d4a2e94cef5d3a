/* Colour by velocity along y. */
#include "render/colors/velocity_along.h"

VELOCITY_ALONG(y);
