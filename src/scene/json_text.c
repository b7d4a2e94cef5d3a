/* Decodes and encodes JSON strings, and finds members by name. */
#include "scene/json.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t hex4(const char *s)
{
    char digits[5] = {s[0], s[1], s[2], s[3], 0};
    return (uint32_t)strtoul(digits, NULL, 16);
}

static int utf8_encode(uint32_t code, char *out)
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    int n = code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (int i = n - 1; i > 0; i--, code >>= 6)
        out[i] = (char)(0x80 | (code & 0x3f));
    out[0] = (char)((n == 2 ? 0xc0 : n == 3 ? 0xe0 : 0xf0) | code);
    return n;
}

/* One character at s as UTF-8; returns bytes of text used. The text is known to be valid. */
static int decode_one(const char *s, char *out, int *bytes)
{
    static const char from[] = "bfnrt", to[] = "\b\f\n\r\t";
    *bytes = 1;
    if (s[0] != '\\') {
        unsigned char lead = (unsigned char)s[0];
        *bytes = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        memcpy(out, s, (size_t)*bytes);
        return *bytes;
    }
    if (s[1] != 'u') {
        const char *p = strchr(from, s[1]);
        out[0] = p ? to[p - from] : s[1];
        return 2;
    }
    uint32_t code = hex4(s + 2);
    int used = 6;
    if (code >= 0xd800 && code < 0xe000) {
        code = 0x10000 + ((code - 0xd800) << 10) + (hex4(s + 8) - 0xdc00);
        used = 12;
    }
    *bytes = utf8_encode(code, out);
    return used;
}

bool json_string(const struct json *doc, int node, char *out, size_t size)
{
    const char *s = doc->text + doc->nodes[node].start, *end = doc->text + doc->nodes[node].end;
    size_t length = 0;
    while (s < end) {
        char one[4];
        int bytes;
        s += decode_one(s, one, &bytes);
        if (length + (size_t)bytes >= size) {
            out[length] = '\0';
            return false;
        }
        memcpy(out + length, one, (size_t)bytes);
        length += (size_t)bytes;
    }
    out[length] = '\0';
    return true;
}

int json_member(const struct json *doc, int object, const char *key)
{
    const struct json_node *o = &doc->nodes[object];
    if (o->kind != JSON_OBJECT)
        return -1;
    for (int k = object + 1; k < o->next; k = doc->nodes[k].next) {
        char name[256];
        if (json_string(doc, k, name, sizeof name) && strcmp(name, key) == 0)
            return k + 1;
    }
    return -1;
}

const char *json_kind_name(enum json_kind kind)
{
    static const char *const names[] = {"an object", "an array", "a string", "a number",
                                        "true or false", "null"};
    return names[kind];
}
