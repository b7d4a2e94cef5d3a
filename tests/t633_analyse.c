/* Orders, fronts and times to an error, of made-up points whose errors are known. */
#include "study/crossing.h"
#include "study/products/text.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define near(a, b, most) assert_true(fabs((a) - (b)) <= (most))

enum { RUNGS = 4, METHODS = 2 };

static struct study_ladder ladder = {.name = "resolution", .key = "particles.spacing", .count = RUNGS};
static struct study_method methods[METHODS] = {{.name = "second"}, {.name = "first"}};
static struct scene scenes[RUNGS];
static struct study_point items[METHODS * RUNGS];
static struct study_points points = {items, METHODS * RUNGS};

/* error = C d^p at d = 0.1, 0.05 ..., time = T / d^3. */
static int make(void **state)
{
    static const double factors[METHODS] = {4, 1}, orders[METHODS] = {2, 1}, times[METHODS] = {1e-3, 1e-3};
    (void)state;
    memset(items, 0, sizeof items);
    for (int r = 0; r < RUNGS; r++)
        scenes[r].particles.spacing = 0.1 / (1 << r);
    for (int m = 0; m < METHODS; m++)
        for (int r = 0; r < RUNGS; r++) {
            struct study_point *p = &items[m * RUNGS + r];
            double d = scenes[r].particles.spacing;
            *p = (struct study_point){.ladder = &ladder, .method = &methods[m], .rung = (size_t)r,
                                      .scene = &scenes[r], .outcome = OUTCOME_DONE, .repeats = 3,
                                      .pairs = pow(d, -3)};
            p->wall[0] = 1.5 * times[m] * pow(d, -3);
            p->wall[1] = times[m] * pow(d, -3);
            p->wall[2] = 1.08 * times[m] * pow(d, -3);
            study_error_add(&p->errors, -factors[m] * pow(d, orders[m]), "%", NAN, "of %s", "something");
        }
    return 0;
}

static void orders_are_found(void **state)
{
    (void)state;
    for (size_t k = 0; k < points.count; k++) {
        double order = study_order(&points, &items[k], "of something");
        if (items[k].rung == 0)
            assert_true(isnan(order));
        else
            near(order, items[k].method == &methods[0] ? 2 : 1, 1e-9);
    }
    near(study_wall_median(&items[0]), 1.04, 1e-9); /* the first was disturbed */
    near(study_wall(&items[0]), 1, 1e-9);
}

static void orders_need_two_rungs(void **state)
{
    (void)state;
    items[1].outcome = OUTCOME_STOPPED;
    items[5].errors.items[0].value = 0;
    assert_true(isnan(study_order(&points, &items[1], "of something")));
    assert_true(isnan(study_order(&points, &items[2], "of something")));
    assert_true(isnan(study_order(&points, &items[5], "of something"))); /* of an error of 0 */
    assert_true(isnan(study_order(&points, &items[6], "of something")));
    assert_true(isnan(study_order(&points, &items[2], "of nothing"))); /* no such error */
    assert_true(isfinite(study_order(&points, &items[3], "of something")));
    scenes[3].particles.spacing = scenes[2].particles.spacing; /* a ladder of something else */
    assert_true(isnan(study_order(&points, &items[3], "of something")));
}

/* 4 d^2 < d below d = 0.25 at equal time: the second method is beaten everywhere. */
static void front_is_found(void **state)
{
    (void)state;
    for (size_t k = 0; k < points.count; k++) {
        assert_int_equal(study_is_front(&points, &items[k], "of something", study_wall), k < RUNGS);
        assert_int_equal(study_is_front(&points, &items[k], "of something", study_pairs), k < RUNGS);
    }
}

static void front_with_ties_and_failures(void **state)
{
    (void)state;
    items[4] = items[0]; /* the same error in the same time: both are on it */
    items[4].method = &methods[1];
    assert_true(study_is_front(&points, &items[0], "of something", study_wall));
    assert_true(study_is_front(&points, &items[4], "of something", study_wall));
    items[0].wall[0] = items[0].wall[1] = items[0].wall[2] = 0.9; /* now one is faster */
    assert_true(study_is_front(&points, &items[0], "of something", study_wall));
    assert_false(study_is_front(&points, &items[4], "of something", study_wall));
    items[0].outcome = OUTCOME_CRASHED; /* what failed beats nothing and is not on it */
    assert_false(study_is_front(&points, &items[0], "of something", study_wall));
    assert_true(study_is_front(&points, &items[4], "of something", study_wall));
    items[1].errors.items[0].value = NAN;
    assert_false(study_is_front(&points, &items[1], "of something", study_wall));
    items[5].errors.items[0].value = -0.03; /* less than what is faster, and what is not known */
    assert_true(study_is_front(&points, &items[5], "of something", study_wall));
    items[5].repeats = 0; /* no time */
    assert_false(study_is_front(&points, &items[5], "of something", study_wall));
}

static void time_to_an_error(void **state)
{
    (void)state;
    const struct curve second = {&points, &ladder, &methods[0], "of something"};
    const struct curve first = {&points, &ladder, &methods[1], "of something"};
    struct crossing c = crossing_time(&second, 0.01 / 2); /* 4 d^2 = 0.005 */
    assert_int_equal(c.kind, CROSSING_AT);
    near(c.value, 1e-3 * pow(sqrt(0.005 / 4), -3), 1e-6);
    c = crossing_time(&second, 0.01); /* a rung's own error */
    near(c.value, 1e-3 * pow(0.05, -3), 1e-6);
    c = crossing_time(&second, 0.5);
    assert_int_equal(c.kind, CROSSING_BELOW);
    near(c.value, 1, 1e-9);
    c = crossing_time(&first, 0.01);
    assert_int_equal(c.kind, CROSSING_NEVER);
    near(c.value, 0.0125, 1e-9);
    char text[100];
    crossing_time_text(&c, "%", text, sizeof text);
    assert_string_equal(text, "not reached, least 1.25 %");
    items[1].outcome = OUTCOME_LATE; /* then between its neighbours: the law is the same line */
    c = crossing_time(&second, 0.005);
    near(c.value, 1e-3 * pow(sqrt(0.005 / 4), -3), 1e-6);
    items[3].errors.items[0].value = 0;
    c = crossing_time(&second, 1e-9);
    assert_int_equal(c.kind, CROSSING_BELOW);
    for (size_t k = 0; k < points.count; k++)
        items[k].outcome = OUTCOME_LEFT_OUT;
    assert_int_equal(crossing_time(&second, 0.01).kind, CROSSING_NONE);
    assert_int_equal(crossing_error(&second, 10).kind, CROSSING_NONE);
}

static void error_after_a_time(void **state)
{
    (void)state;
    const struct curve second = {&points, &ladder, &methods[0], "of something"};
    struct crossing c = crossing_error(&second, 10); /* 1e-3 / d^3 = 10 */
    assert_int_equal(c.kind, CROSSING_AT);
    near(c.value, 4 * pow(1e-4, 2.0 / 3), 1e-9);
    c = crossing_error(&second, 1e6);
    assert_int_equal(c.kind, CROSSING_BELOW);
    near(c.value, 4 * 0.0125 * 0.0125, 1e-12);
    c = crossing_error(&second, 0.1);
    assert_int_equal(c.kind, CROSSING_ABOVE);
    near(c.value, 0.04, 1e-12);
    items[3].errors.items[0].value = 0.02; /* worse than the one before: nobody would take it */
    c = crossing_error(&second, 1e6);
    near(c.value, 4 * 0.025 * 0.025, 1e-12);
    char text[100];
    crossing_error_text(&c, "%", text, sizeof text);
    assert_string_equal(text, "< 0.25 %");
}

static void spread_is_the_last_errors(void **state)
{
    struct study_errors errors = {.count = 0};
    (void)state;
    study_error_spread(&errors, 1);
    study_error_add(&errors, 1, "%", NAN, "a");
    study_error_add(&errors, 1, "%", NAN, "b");
    study_error_spread(&errors, 0.027);
    assert_true(isnan(errors.items[0].spread));
    near(errors.items[1].spread, 0.027, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(orders_are_found, make),
        cmocka_unit_test_setup(orders_need_two_rungs, make),
        cmocka_unit_test_setup(front_is_found, make),
        cmocka_unit_test_setup(front_with_ties_and_failures, make),
        cmocka_unit_test_setup(time_to_an_error, make),
        cmocka_unit_test_setup(error_after_a_time, make),
        cmocka_unit_test_setup(spread_is_the_last_errors, make),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
