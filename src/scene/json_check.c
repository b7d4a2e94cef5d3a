/* Checks JSON grammar strictly and says what to do about the first fault. */
#include "scene/json.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct checker {
    const char *text;
    int at, length, depth;
    struct json_fault *fault;
};

static bool check_value(struct checker *c);

static bool __attribute__((format(printf, 3, 4)))
fault(struct checker *c, int offset, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    c->fault->offset = offset < c->length ? offset : c->length;
    vsnprintf(c->fault->text, sizeof c->fault->text, format, args);
    va_end(args);
    return false;
}

static int peek(const struct checker *c)
{
    return c->at < c->length ? (unsigned char)c->text[c->at] : -1;
}

static bool looking_at(const struct checker *c, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(c->length - c->at) >= n && memcmp(c->text + c->at, word, n) == 0;
}

static void skip_space(struct checker *c)
{
    while (c->at < c->length && strchr(" \t\r\n", c->text[c->at]) && c->text[c->at])
        c->at++;
}

/* What stands where something else was expected. */
static bool unexpected(struct checker *c, const char *expected)
{
    int byte = peek(c);
    if (byte < 0)
        return fault(c, c->at, "the text ends here but %s is still expected", expected);
    if (looking_at(c, "//") || looking_at(c, "/*") || byte == '#')
        return fault(c, c->at, "JSON has no comments; remove it");
    if (byte == '\'')
        return fault(c, c->at, "found ' where %s is expected; strings take double quotes",
                     expected);
    if (byte < 32 || byte >= 127)
        return fault(c, c->at, "found byte 0x%02x where %s is expected; remove it", byte, expected);
    return fault(c, c->at, "found '%c' where %s is expected", byte, expected);
}

/* Length of the UTF-8 sequence at s (RFC 3629), 0 if it is none. */
static int utf8_length(const unsigned char *s, int left)
{
    int n = s[0] < 0x80 ? 1 : s[0] >= 0xc2 && s[0] < 0xe0 ? 2 : (s[0] & 0xf0) == 0xe0 ? 3
            : s[0] >= 0xf0 && s[0] < 0xf5 ? 4 : 0;
    if (n == 0 || n > left)
        return 0;
    for (int i = 1; i < n; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0) ||
        (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] >= 0x90))
        return 0;
    return n;
}

/* The four digits after "\u", or -1. */
static int hex4(const struct checker *c, int at)
{
    int value = 0;
    for (int i = at; i < at + 4; i++) {
        if (i >= c->length || !isxdigit((unsigned char)c->text[i]))
            return -1;
        int digit = tolower((unsigned char)c->text[i]);
        value = value * 16 + (digit <= '9' ? digit - '0' : digit - 'a' + 10);
    }
    return value;
}

static bool check_unicode_escape(struct checker *c)
{
    int first = hex4(c, c->at + 2);
    if (first < 0)
        return fault(c, c->at, "\\u takes four hexadecimal digits");
    if (first == 0)
        return fault(c, c->at, "\\u0000 is not allowed in a string; remove it");
    if (first >= 0xd800 && first < 0xe000) {
        bool pair = first < 0xdc00 && c->at + 7 < c->length && c->text[c->at + 6] == '\\' &&
                    c->text[c->at + 7] == 'u';
        int second = pair ? hex4(c, c->at + 8) : -1;
        if (second < 0xdc00 || second >= 0xe000)
            return fault(c, c->at, "half of a surrogate pair; write the character itself");
        c->at += 6;
    }
    c->at += 6;
    return true;
}

static bool check_escape(struct checker *c)
{
    int byte = c->at + 1 < c->length ? (unsigned char)c->text[c->at + 1] : -1;
    if (byte == 'u')
        return check_unicode_escape(c);
    if (byte <= 0 || !strchr("\"\\/bfnrt", byte))
        return fault(c, c->at, "unknown escape in a string; write \\\\ for a backslash");
    c->at += 2;
    return true;
}

static bool check_string(struct checker *c)
{
    int open = c->at++;
    while (peek(c) != '"') {
        int byte = peek(c);
        if (byte < 0 || byte == '\n' || byte == '\r')
            return fault(c, open, "this string is not closed on its line; add '\"'");
        if (byte < 32)
            return fault(c, c->at, "control character 0x%02x in a string; write it as \\u%04x",
                         byte, byte);
        if (byte == '\\') {
            if (!check_escape(c))
                return false;
            continue;
        }
        int n = utf8_length((const unsigned char *)c->text + c->at, c->length - c->at);
        if (n == 0)
            return fault(c, c->at, "byte 0x%02x is not UTF-8; save the file as UTF-8", byte);
        c->at += n;
    }
    c->at++;
    return true;
}

static bool check_digits(struct checker *c, int start)
{
    if (!isdigit(peek(c)))
        return fault(c, start, "not a number: a digit is missing; write 0.5 rather than .5 or 5.");
    while (isdigit(peek(c)))
        c->at++;
    return true;
}

static bool check_number(struct checker *c)
{
    int start = c->at;
    if (peek(c) == '-')
        c->at++;
    if (looking_at(c, "Inf") || looking_at(c, "NaN"))
        return fault(c, start, "numbers are finite");
    if (peek(c) == '0' && c->at + 1 < c->length && isdigit((unsigned char)c->text[c->at + 1]))
        return fault(c, start, "not a number: remove the zeros in front");
    if (!check_digits(c, start))
        return false;
    if (peek(c) == '.') {
        c->at++;
        if (!check_digits(c, start))
            return false;
    }
    if (peek(c) == 'e' || peek(c) == 'E') {
        c->at++;
        if (peek(c) == '+' || peek(c) == '-')
            c->at++;
        if (!check_digits(c, start))
            return false;
    }
    if (isalpha(peek(c)) || peek(c) == '_' || peek(c) == '.')
        return fault(c, start, "not a number: units are fixed, remove what follows the digits");
    return true;
}

/* true, false, null, or a word that is none of them. */
static bool check_word(struct checker *c)
{
    int start = c->at;
    while (isalnum(peek(c)) || peek(c) == '_')
        c->at++;
    int n = c->at - start;
    const char *word = c->text + start;
    if ((n == 4 && memcmp(word, "true", 4) == 0) || (n == 5 && memcmp(word, "false", 5) == 0) ||
        (n == 4 && memcmp(word, "null", 4) == 0))
        return true;
    return fault(c, start, "'%.*s' is no JSON value; words take double quotes, and truth is "
                 "written true or false", n > 40 ? 40 : n, word);
}

static bool check_member(struct checker *c)
{
    if (peek(c) != '"') {
        if (isalpha(peek(c)) || peek(c) == '_')
            return fault(c, c->at, "a key takes double quotes");
        return unexpected(c, "a key in double quotes");
    }
    if (!check_string(c))
        return false;
    skip_space(c);
    if (peek(c) != ':')
        return unexpected(c, "':' after the key");
    c->at++;
    return check_value(c);
}

static bool never_closed(struct checker *c, int open, char close)
{
    return fault(c, open, "this '%c' is never closed; add '%c'", c->text[open], close);
}

/* An object or an array, from its opening to its closing bracket. */
static bool check_container(struct checker *c, char close)
{
    int open = c->at++;
    if (++c->depth > JSON_DEPTH_LIMIT)
        return fault(c, open, "more than %d values inside each other", JSON_DEPTH_LIMIT);
    skip_space(c);
    bool more = peek(c) != close;
    while (more) {
        skip_space(c);
        if (peek(c) < 0)
            return never_closed(c, open, close);
        if (!(close == '}' ? check_member(c) : check_value(c)))
            return false;
        skip_space(c);
        int comma = c->at;
        more = peek(c) == ',';
        if (more) {
            c->at++;
            skip_space(c);
            if (peek(c) == close)
                return fault(c, comma, "a comma before '%c'; remove it", close);
        } else if (peek(c) < 0) {
            return never_closed(c, open, close);
        } else if (peek(c) != close) {
            return unexpected(c, close == '}' ? "',' or '}'" : "',' or ']'");
        }
    }
    c->at++;
    c->depth--;
    return true;
}

static bool check_value(struct checker *c)
{
    skip_space(c);
    int byte = peek(c);
    if (byte == '{' || byte == '[')
        return check_container(c, byte == '{' ? '}' : ']');
    if (byte == '"')
        return check_string(c);
    if (byte == '-' || isdigit(byte))
        return check_number(c);
    if (byte == '+' || byte == '.')
        return fault(c, c->at, "not a number: write 0.5 rather than .5 or +0.5");
    if (isalpha(byte))
        return check_word(c);
    return unexpected(c, "a value");
}

bool json_check(const char *text, int length, struct json_fault *f)
{
    struct checker c = {.text = text, .length = length, .fault = f};
    if (looking_at(&c, "\xef\xbb\xbf"))
        return fault(&c, 0, "the file begins with a byte order mark; save it as UTF-8 without BOM");
    if (looking_at(&c, "\xff\xfe") || looking_at(&c, "\xfe\xff"))
        return fault(&c, 0, "the file is UTF-16; save it as UTF-8 without BOM");
    skip_space(&c);
    if (c.at == length)
        return fault(&c, 0, "the text is empty");
    if (!check_value(&c))
        return false;
    skip_space(&c);
    if (c.at < length)
        return fault(&c, c.at, "text after the end of the value; remove it or add the missing '{'");
    return true;
}
