/* Orders, fronts, limits, seeds and times, of made-up points whose errors are known. */
#include "study/crossing.h"
#include "study/ensemble.h"
#include "study/products/text.h"
#include "study/reference/norm.h"
#include "study/richardson.h"

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

/* A point that stopped early has fewer errors, in other places. */
static void errors_are_told_by_name(void **state)
{
    (void)state;
    for (int m = 0; m < METHODS; m++)
        study_error_add(&items[m * RUNGS + 3].errors, 7, "", NAN, "other");
    struct study_error swap = items[3].errors.items[0];
    items[3].errors.items[0] = items[3].errors.items[1];
    items[3].errors.items[1] = swap;
    near(study_order(&points, &items[3], "of something"), 2, 1e-9);
    assert_true(isnan(study_order(&points, &items[3], "other")));
    assert_int_equal(study_most_errors(&points, &ladder)->count, 2);
    assert_null(study_error(&items[0], "other"));
    assert_null(study_error(&items[0], NULL));
    near(study_error_known(&points, "other")->value, 7, 0);
    assert_null(study_error_known(&points, "nothing"));
}

static void disturbed_times_are_left_out(void **state)
{
    (void)state;
    struct study_point *p = &items[0];
    *p = (struct study_point){.repeats = 4, .threads = 1, .wall = {1, 1.05, 1.3, 1.02}, .cpu = {1, 1, 1, 1}};
    assert_false(study_is_disturbed(p, 0));
    assert_true(study_is_disturbed(p, 2)); /* 30 % longer than the least */
    assert_int_equal(study_calm(p), 3);
    near(study_wall_median(p), 1.02, 1e-12);
    near(study_wall(p), 1, 0);
    p->cpu[3] = 0.9; /* it waited for a processor: 1.02 s for 0.9 s of work */
    assert_true(study_is_disturbed(p, 3));
    near(study_wall_median(p), 1.025, 1e-12);
    *p = (struct study_point){.repeats = 1, .threads = 1, .wall = {2}, .cpu = {1}};
    assert_int_equal(study_calm(p), 0); /* one run tells, too */
    near(study_wall_median(p), 2, 0);   /* and is all there is */
    p->cpu[0] = 3.5; /* two threads */
    assert_int_equal(study_calm(p), 1);
}

static void seeds_are_joined(void **state)
{
    struct study_point members[4];
    struct study_point joint = {.members = members, .member_count = 4, .ladder = &ladder};
    static const double errors[] = {0.01, -0.03, 0.02, 0.04};
    char text[64];
    (void)state;
    for (int k = 0; k < 4; k++) {
        members[k] = (struct study_point){.ladder = &ladder, .outcome = OUTCOME_DONE, .repeats = 2,
                                          .wall = {1.0 + k, 1.1 + k}, .cpu = {1, 1}, .pairs = 100};
        study_error_add(&members[k].errors, errors[k], "%", 0.02, "of chance");
    }
    ensemble_join(&joint);
    const struct study_error *error = study_error(&joint, "of chance");
    assert_int_equal(joint.outcome, OUTCOME_DONE);
    assert_int_equal(error->runs, 4);
    near(error->value, 0.01, 1e-12);                        /* signs cancel */
    near(study_error_size(&joint, "of chance"), 0.025, 1e-12); /* sizes do not */
    near(error->deviation, sqrt((0 + 16 + 1 + 9) / 3.0) / 100, 1e-12);
    near(error->least, 0.01, 0);
    near(error->most, 0.04, 0);
    near(study_wall(&joint), 2.5, 1e-12);
    near(study_pairs(&joint), 100, 0);
    text_found(error, text, sizeof text);
    assert_string_equal(text, "1 ± 2.9 %");
    members[1].outcome = OUTCOME_LEFT_OUT;
    ensemble_join(&joint);
    assert_int_equal(joint.outcome, OUTCOME_DONE);
    assert_int_equal(study_error(&joint, "of chance")->runs, 3);
    text_found(study_error(&joint, "of chance"), text, sizeof text);
    assert_string_equal(text, "2.33 ± 1.5 % (3 of 4 seeds)");
    members[2].outcome = OUTCOME_STOPPED; /* one that failed is not outvoted */
    strcpy(members[2].cause, "too fast");
    ensemble_join(&joint);
    assert_int_equal(joint.outcome, OUTCOME_STOPPED);
    assert_string_equal(joint.cause, "seed 3 of 4: too fast");
    assert_true(isnan(study_error_size(&joint, "of chance")));
    for (int k = 0; k < 4; k++)
        members[k].outcome = OUTCOME_LEFT_OUT;
    ensemble_join(&joint);
    assert_int_equal(joint.outcome, OUTCOME_LEFT_OUT);
    assert_int_equal(joint.errors.count, 0);
}

/* value = 2 + 3 d^p, rungs not evenly far apart. */
static void limits_are_extrapolated(void **state)
{
    (void)state;
    static const double d[3] = {0.1, 0.06, 0.04};
    for (double p = 0.7; p < 4; p += 0.5) {
        double values[3];
        for (int k = 0; k < 3; k++)
            values[k] = 2 + 3 * pow(d[k], p);
        struct richardson r = richardson_of(d, values);
        assert_int_equal(r.kind, RICHARDSON_KNOWN);
        near(r.order, p, 1e-6);
        near(r.extrapolated, 2, 1e-9);
        near(r.factor, p > 3 ? 3 : 1.25, 0);
        near(r.gci, r.factor * 3 * pow(0.04, p), 1e-9);
    }
    assert_int_equal(richardson_of(d, (const double[]){1, 2, 1.5}).kind, RICHARDSON_OSCILLATES);
    assert_int_equal(richardson_of(d, (const double[]){1, 2, 4}).kind, RICHARDSON_DIVERGES);
    assert_int_equal(richardson_of(d, (const double[]){1, 1, 4}).kind, RICHARDSON_SAME);
}

static void limits_of_ladders(void **state)
{
    (void)state;
    struct study_asked asked = {.name = "of something", .kind = REFERENCE_RUN,
                                .norm = (const struct norm_row *)variant_find(&norm_table, "final")};
    assert_true(richardson_applies(&points, &ladder, &asked));
    struct richardson r = richardson_ladder(&points, &ladder, &methods[0], &asked);
    assert_int_equal(r.kind, RICHARDSON_KNOWN);
    near(r.order, 2, 1e-6);
    near(r.extrapolated, 0, 1e-9);
    items[1].outcome = OUTCOME_STOPPED; /* then with the coarsest: the law is the same */
    near(richardson_ladder(&points, &ladder, &methods[0], &asked).order, 2, 1e-6);
    items[2].errors.items[0].runs = items[3].errors.items[0].runs = 5;
    items[2].errors.items[0].deviation = items[3].errors.items[0].deviation = 1;
    assert_int_equal(richardson_ladder(&points, &ladder, &methods[0], &asked).kind, RICHARDSON_NOISE);
    items[0].outcome = OUTCOME_STOPPED;
    assert_int_equal(richardson_ladder(&points, &ladder, &methods[0], &asked).kind, RICHARDSON_FEW);
    asked.norm = (const struct norm_row *)variant_find(&norm_table, "l2");
    assert_int_equal(richardson_ladder(&points, &ladder, &methods[1], &asked).kind, RICHARDSON_NORM);
    asked.kind = REFERENCE_FORMULA; /* it has exact errors */
    assert_false(richardson_applies(&points, &ladder, &asked));
    asked.kind = REFERENCE_RUN;
    for (int r0 = 0; r0 < RUNGS; r0++)
        scenes[r0].particles.spacing = 0.1; /* a ladder of something else */
    assert_false(richardson_applies(&points, &ladder, &asked));
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
        cmocka_unit_test_setup(errors_are_told_by_name, make),
        cmocka_unit_test_setup(disturbed_times_are_left_out, make),
        cmocka_unit_test_setup(seeds_are_joined, make),
        cmocka_unit_test_setup(limits_are_extrapolated, make),
        cmocka_unit_test_setup(limits_of_ladders, make),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
