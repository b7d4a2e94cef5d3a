/* Tests overlap, volume and bounds of all shapes. */
#include "scene/shape.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define BOX(...) {.kind = SHAPE_BOX, .min = {0, 0, 0}, .max = {__VA_ARGS__}}
#define BALL(r, ...) {.kind = SHAPE_SPHERE, .center = {__VA_ARGS__}, .radius = r}
#define ROD(along, r, h, ...) \
    {.kind = SHAPE_CYLINDER, .center = {__VA_ARGS__}, .radius = r, .height = h, .axis = along}

/* Near the corner (1, 1, 1) of the unit box along its diagonal. */
#define CORNER(gap) 1 + (0.5 + (gap)) / 1.7320508075688772
#define DIAGONAL(gap) (1.0 + (gap)) / 1.4142135623730951

static const struct { struct shape a, b; bool overlap; } pairs[] = {
    {BOX(1, 1, 1), {.kind = SHAPE_BOX, .min = {1, 0, 0}, .max = {2, 1, 1}}, false},
    {BOX(1, 1, 1), {.kind = SHAPE_BOX, .min = {0.98, 0, 0}, .max = {2, 1, 1}}, true},
    {BOX(1, 1, 1), {.kind = SHAPE_BOX, .min = {0.2, 0.2, 0.2}, .max = {0.4, 0.4, 0.4}}, true},
    {BOX(1, 1, 1), BALL(0.5, 1.5, 0.5, 0.5), false},
    {BOX(1, 1, 1), BALL(0.5, 1.48, 0.5, 0.5), true},
    {BOX(1, 1, 1), BALL(0.5, CORNER(0.001), CORNER(0.001), CORNER(0.001)), false},
    {BOX(1, 1, 1), BALL(0.5, CORNER(-0.03), CORNER(-0.03), CORNER(-0.03)), true},
    {BALL(1, 0, 0, 0), BALL(0.5, 1.5, 0, 0), false},
    {BALL(1, 0, 0, 0), BALL(0.5, 1.47, 0, 0), true},
    {BALL(1, 0, 0, 0), BALL(0.1, 0.1, 0, 0), true},
    {ROD(1, 0.5, 1, 0, 0, 0), ROD(1, 0.5, 1, DIAGONAL(0.001), 0, DIAGONAL(0.001)), false},
    {ROD(1, 0.5, 1, 0, 0, 0), ROD(1, 0.5, 1, DIAGONAL(-0.03), 0, DIAGONAL(-0.03)), true},
    {ROD(1, 0.5, 1, 0, 0, 0), ROD(1, 0.5, 1, 0, 1, 0), false},
    {ROD(1, 0.5, 1, 0, 0, 0), ROD(0, 0.5, 1, 0, 1, 0), false},
    {ROD(1, 0.5, 1, 0, 0, 0), ROD(0, 0.5, 1, 0, 0.97, 0), true},
    {ROD(1, 0.5, 1, 0, 0, 0), BALL(0.5, 0, 1, 0), false},
    {ROD(1, 0.5, 1, 0, 0, 0), BALL(0.5, 0.3, 0.9, 0), true},
    {ROD(2, 0.5, 3, 0, 0, 0), BALL(0.5, 0.71, 0.71, 1), false},
};

static void finds_overlaps(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        if (shape_overlap(&pairs[i].a, &pairs[i].b, 0.01) != pairs[i].overlap ||
            shape_overlap(&pairs[i].b, &pairs[i].a, 0.01) != pairs[i].overlap)
            fail_msg("pair %zu", i);
    }
}

static void measures(void **state)
{
    (void)state;
    struct shape box = BOX(1, 2, 3), ball = BALL(2, 0, 0, 0), rod = ROD(0, 2, 3, 0, 0, 0);
    double min[3], max[3];
    assert_true(shape_volume(&box) == 6);
    assert_true(fabs(shape_volume(&ball) - 33.510321638) < 1e-6);
    assert_true(fabs(shape_volume(&rod) - 37.699111843) < 1e-6);
    shape_bounds(&rod, min, max);
    assert_true(min[0] == -1.5 && max[1] == 2 && max[2] == 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(finds_overlaps),
                                       cmocka_unit_test(measures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
