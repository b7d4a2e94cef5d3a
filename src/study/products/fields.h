/* Fields of csv lines and members of JSON objects, as the files of studies have them. */
#ifndef STUDY_FIELDS_H
#define STUDY_FIELDS_H

#include <stdio.h>

/* In quotes; and nothing for what is not finite. Without commas. */
void csv_text(const char *text, FILE *out);
void csv_number(double number, FILE *out);

/* "KEY": VALUE with a comma behind; null for what is not finite. */
void json_text(const char *key, const char *text, FILE *out);
void json_number(const char *key, double number, FILE *out);

#endif
