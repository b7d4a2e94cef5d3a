/* Looks up rows of variant tables. */
#include "base/variant.h"

#include <string.h>

const struct variant *variant_find(const struct variant_table *table, const char *name)
{
    for (size_t i = 0; i < table->count; i++)
        if (strcmp(table->rows[i]->name, name) == 0)
            return table->rows[i];
    return NULL;
}

const struct variant *variant_first(const struct variant_table *table)
{
    for (size_t i = 0; i < table->count; i++)
        if (!table->rows[i]->missing)
            return table->rows[i];
    return NULL;
}
