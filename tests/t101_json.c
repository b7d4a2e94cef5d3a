/* Tests JSON documents: strict grammar, places of faults, strings. */
#include "base/quote.h"
#include "scene/json.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static const struct { const char *text; int offset; const char *says; } faults[] = {
    {"", 0, "empty"},
    {"  \n ", 0, "empty"},
    {"{", 0, "never closed"},
    {"[1, 2", 0, "never closed"},
    {"{\"a\": 1,}", 7, "remove it"},
    {"[1,]", 2, "remove it"},
    {"[1 2]", 3, "','"},
    {"{\"a\" 1}", 5, "':'"},
    {"{\"a\": }", 6, "a value"},
    {"{a: 1}", 1, "double quotes"},
    {"{'a': 1}", 1, "double quotes"},
    {"{\"a\": 1} x", 9, "after the end"},
    {"{\"a\": 1}}", 8, "after the end"},
    {"{\"a\": 01}", 6, "zeros"},
    {"{\"a\": .5}", 6, "0.5"},
    {"{\"a\": +5}", 6, "0.5"},
    {"{\"a\": 5.}", 6, "digit is missing"},
    {"{\"a\": 1e}", 6, "digit is missing"},
    {"{\"a\": -}", 6, "digit is missing"},
    {"{\"a\": 1.5m}", 6, "units"},
    {"{\"a\": 0x10}", 6, "units"},
    {"{\"a\": -Infinity}", 6, "finite"},
    {"{\"a\": NaN}", 6, "no JSON value"},
    {"{\"a\": True}", 6, "true or false"},
    {"{\"a\": \"b\nc\"}", 6, "not closed"},
    {"{\"a\": \"b", 6, "not closed"},
    {"{\"a\": \"\t\"}", 7, "control character"},
    {"{\"a\": \"\\x\"}", 7, "escape"},
    {"{\"a\": \"\\u12\"}", 7, "hexadecimal"},
    {"{\"a\": \"\\u0000\"}", 7, "not allowed"},
    {"{\"a\": \"\\ud800\"}", 7, "surrogate"},
    {"{\"a\": \"\\udc00\\ud800\"}", 7, "surrogate"},
    {"{\"a\": \"\xff\"}", 7, "UTF-8"},
    {"{\"a\": \"\xc0\xaf\"}", 7, "UTF-8"},
    {"{\"a\": \"\xed\xa0\x80\"}", 7, "UTF-8"},
    {"\xef\xbb\xbf{}", 0, "byte order mark"},
    {"\xff\xfe{", 0, "UTF-16"},
    {"// hello\n{}", 0, "comments"},
    {"{ # hello\n}", 2, "comments"},
    {"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", 32, "inside each other"},
};

static void refuses_with_place(void **state)
{
    int bad = 0;
    (void)state;
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        struct json_fault fault = {0};
        assert_false(json_check(faults[i].text, (int)strlen(faults[i].text), &fault));
        if (fault.offset != faults[i].offset || !strstr(fault.text, faults[i].says))
            print_error("%s: byte %d: %s\n", faults[i].text, fault.offset, fault.text), bad++;
    }
    assert_int_equal(bad, 0);
}

static void accepts_json(void **state)
{
    static const char *const texts[] = {"0", "-0.5e-3", "[]", "{}", " null ",
                                        "\"\\u00e9\\ud83d\\ude00\"",
                                        "[1,2 , [true,false]]", "{\"a\":{\"b\":[{}]}}", "1E+5"};
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct json doc;
        struct error e;
        assert_int_equal(json_read_text(&doc, "test", texts[i], &e), STATUS_OK);
        json_free(&doc);
    }
}

static void decodes_strings(void **state)
{
    struct json doc;
    struct error e;
    char text[64], small[4];
    (void)state;
    assert_int_equal(json_read_text(&doc, "t",
                                    "[\"a\\n\\\"\\u00e9\\ud83d\\ude00\\/\", \"ab\xc3\xa9\"]",
                                    &e), STATUS_OK);
    assert_true(json_string(&doc, 1, text, sizeof text));
    assert_string_equal(text, "a\n\"\xc3\xa9\xf0\x9f\x98\x80/");
    assert_false(json_string(&doc, 2, small, sizeof small)); /* never half a character */
    assert_string_equal(small, "ab");
    json_free(&doc);
}

static void finds_members_and_places(void **state)
{
    struct json doc;
    struct error e;
    int line, column;
    (void)state;
    assert_int_equal(json_read_text(&doc, "t", "{\"a\": [1, {\"x\": 2}],\n  \"\xc3\xa9\": 3}", &e),
                     STATUS_OK);
    int node = json_member(&doc, 0, "\xc3\xa9");
    assert_true(node > 0);
    json_position(&doc, doc.nodes[node].start, &line, &column);
    assert_int_equal(line, 2);
    assert_int_equal(column, 8); /* characters, not bytes */
    assert_int_equal(json_member(&doc, 0, "x"), -1);
    assert_int_equal(doc.nodes[json_member(&doc, 0, "a")].size, 2);
    json_free(&doc);
}

static void quotes_round_trip(void **state)
{
    char quoted[64], text[64];
    struct json doc;
    struct error e;
    (void)state;
    assert_true(json_quote("a\"\\\n\x01\xc3\xa9", quoted, sizeof quoted));
    assert_int_equal(json_read_text(&doc, "t", quoted, &e), STATUS_OK);
    assert_true(json_string(&doc, 0, text, sizeof text));
    assert_string_equal(text, "a\"\\\n\x01\xc3\xa9");
    json_free(&doc);
    assert_false(json_quote("too long", quoted, 6));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_with_place), cmocka_unit_test(accepts_json),
        cmocka_unit_test(decodes_strings), cmocka_unit_test(finds_members_and_places),
        cmocka_unit_test(quotes_round_trip)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
