/* What several stability maps have in common. */
#ifndef STUDY_MAP_INDEX_H
#define STUDY_MAP_INDEX_H

#include "study/products/products.h"

enum { MAPS_MAX = 64 };

/* Writes DIRECTORY/index.html, one page with all maps that asks for no other file, and summary.md, a table of what
 * became of their cells; at most MAPS_MAX maps. STATUS_OUTPUT, STATUS_RUN. */
enum status map_index(const struct study_results *all, size_t count, const char *directory,
                      struct error *e);

#endif
