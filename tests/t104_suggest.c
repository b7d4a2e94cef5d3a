/* Tests "did you mean". */
#include "base/suggest.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void measures_edits(void **state)
{
    (void)state;
    assert_int_equal(suggest_distance("", ""), 0);
    assert_int_equal(suggest_distance("abc", ""), 3);
    assert_int_equal(suggest_distance("", "abc"), 3);
    assert_int_equal(suggest_distance("kitten", "sitting"), 3);
    assert_int_equal(suggest_distance("wscph", "wcsph"), 1); /* two letters swapped */
    assert_int_equal(suggest_distance("Color", "colour"), 1);
}

static const char *best(struct suggest *s, const char *word)
{
    static const char *const known[] = {"velocity", "pressure", "density", "solid", "x", "egl"};
    suggest_start(s, word);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        suggest_offer(s, known[i]);
    return suggest_best(s);
}

static void suggests_what_is_near(void **state)
{
    struct suggest s;
    (void)state;
    assert_string_equal(best(&s, "velocty"), "velocity");
    assert_string_equal(best(&s, "PRESSURE"), "pressure");
    assert_string_equal(best(&s, "press"), "pressure");
    assert_string_equal(best(&s, "egll"), "egl");
    assert_null(best(&s, "temperature"));
    assert_null(best(&s, ""));
    suggest_start(&s, "word");
    assert_null(suggest_best(&s));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(measures_edits),
                                       cmocka_unit_test(suggests_what_is_near)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
