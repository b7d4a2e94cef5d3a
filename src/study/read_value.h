/* Members of objects in a study file, each read with its checks. */
#ifndef STUDY_READ_VALUE_H
#define STUDY_READ_VALUE_H

#include "base/variant.h"
#include "scene/json.h"

/* Each gives STATUS_USAGE with the place and what to do; a member that is not there leaves *out as it
 * is, unless `needed`. */

/* The node of the member, which has that kind; -1 in *node when it is not there. */
enum status read_member(const struct json *doc, int object, const char *key, enum json_kind kind,
                        bool needed, int *node, struct error *e);
enum status read_text(const struct json *doc, int object, const char *key, bool needed, char *out,
                      size_t size, struct error *e);
/* malloc. */
enum status read_long_text(const struct json *doc, int object, const char *key, char **out,
                           struct error *e);
/* A number from min to max. */
enum status read_number(const struct json *doc, int object, const char *key, double min, double max,
                        double *out, struct error *e);
/* A row of the table. */
enum status read_variant(const struct json *doc, int object, const char *key,
                         const struct variant_table *table, const struct variant **out,
                         struct error *e);

/* Refuses members that are not among the words "a|b|c", with the nearest one. */
enum status read_only(const struct json *doc, int object, const char *words, struct error *e);

#endif
