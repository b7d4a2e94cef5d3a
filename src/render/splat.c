/* Chooses the instruction set of the cpu renderer's loops. */
#include "render/splat.h"

#include <string.h>

const struct splat_isa *splat_isa_find(const char *name)
{
    static const struct splat_isa *const rows[] = {&splat_avx512, &splat_avx2, &splat_scalar};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (name && strcmp(name, rows[i]->name) == 0)
            return rows[i];
    for (size_t i = 0;; i++)
        if (rows[i]->supported())
            return rows[i];
}
