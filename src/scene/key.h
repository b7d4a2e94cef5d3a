/* Scene-file keys as typed rows: the parser, --set, `list keys`, the JSON Schema and the
 * effective scene are all made from them. */
#ifndef SCENE_KEY_H
#define SCENE_KEY_H

#include "base/variant.h"

#include <stddef.h>

enum key_type {
    KEY_BOOL,   /* bool */
    KEY_INT,    /* int64_t */
    KEY_REAL,   /* double */
    KEY_TEXT,   /* char[KEY_TEXT_SIZE] */
    KEY_CHOICE, /* char[KEY_TEXT_SIZE], one of `choices` */
    KEY_VEC3,   /* double[3] */
    KEY_PAIR,   /* double[2] */
    KEY_SIZE,   /* int[2] */
    KEY_ENUM    /* int: place in `choices`, "box|sphere|cylinder" */
};

enum { KEY_TEXT_SIZE = 128 };

/* The key need not be a number: the JSON text "auto" is allowed and stored as NAN (both numbers of
 * a pair), and the program chooses. */
enum key_flag {
    KEY_AUTO = 1,
    KEY_ABOVE_MIN = 2, /* min itself is excluded */
    KEY_INSIDE = 4,    /* a point of the domain */
    KEY_SWITCH = 8     /* of an enum: false and true stand for its first and second word */
};

struct key {
    const char *path;     /* "time.end"; "fluids[].density" for elements of an array */
    enum key_type type;
    unsigned flags;       /* enum key_flag */
    const char *fallback; /* default as JSON text; NULL: required (in an array: per element) */
    double min, max;      /* range of numbers, per component; equal: no limit */
    const char *unit;     /* SI, "" for none */
    const char *choices;  /* KEY_CHOICE: name of a variant table, or words "a|b"; KEY_ENUM: words */
    const char *doc;
    size_t offset;        /* into struct scene, or into the element; KEY_OPTION: see scene_real */
};

/* Value kept by path: rows that belong to a variant. Not inside arrays, where a variant's rows have
 * places in the element. The key is accepted, and has a value, only while its variant is the one
 * chosen in its table (in an array: by the element); the variants of a table that no scene key
 * chooses from (forces, encoders) always take theirs. Two variants may share a path, in an array
 * with one type. */
#define KEY_OPTION ((size_t)-1)

/* Everything a scene file may name: the tables that choices refer to and whose variants may bring
 * keys of their own. Made by run/tables.h, so that scene/ knows no solver. */
struct vocabulary {
    const struct variant_table *const *tables;
    size_t count;
};

#endif
