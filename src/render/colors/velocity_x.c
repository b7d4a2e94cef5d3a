/* Colour by velocity along x. */
#include "render/colors/velocity_along.h"

VELOCITY_ALONG(x);
