/* The kernels of the cuda renderer (draw.h), in the order of a frame: DRAW(name) is expanded for each. */
DRAW(clear)
DRAW(pack)
DRAW(place)
DRAW(splat)
DRAW(cull)
DRAW(shade)
DRAW(nearest)
