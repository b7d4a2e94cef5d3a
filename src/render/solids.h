/* The scene's obstacles as opaque, shaded layers of the domain's picture. */
#ifndef RENDER_SOLIDS_H
#define RENDER_SOLIDS_H

#include "render/wire.h"

/* Whether the scene shows any. */
bool solids_wanted(const struct scene *scene);

/* Adds layers of the facets that face the camera, one for each shade; wire->mesh.failed when memory is short. */
void solids_make(struct wire *wire, const struct scene *scene, const struct mesh_view *view);

#endif
