/* Colour by velocity along z. */
#include "render/colors/velocity_along.h"

VELOCITY_ALONG(z);
