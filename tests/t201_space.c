/* Tests fixed-point positions: round trips near and far, periodic wrap, exact differences. */
#include "particles/space.h"
#include "random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/* A domain from `low`, `size` long, with these walls on every face. */
static struct scene domain(double low, double size, enum wall_kind walls)
{
    struct scene scene = {0};
    for (int a = 0; a < 3; a++) {
        scene.domain.min[a] = low;
        scene.domain.max[a] = low + size * (a + 1);
        scene.domain.walls[2 * a] = scene.domain.walls[2 * a + 1] = walls;
    }
    return scene;
}

static const struct { double low, size; } domains[] = {
    {0, 1}, {-0.5, 1}, {1e4, 1}, {-1e4, 2e4}, {0, 1e4}, {3e-4, 1e-3},
};

/* Half a count, and what doubles lose at that distance from the origin. */
static double tolerance(const struct space *s, int axis, double metres)
{
    return 0.5 * s->unit[axis] * 1.000001 + 4e-16 * (fabs(metres) + s->length[axis]);
}

static void round_trips(enum wall_kind walls, double margin)
{
    uint64_t seed = 1;
    for (size_t k = 0; k < sizeof domains / sizeof *domains; k++) {
        struct scene scene = domain(domains[k].low, domains[k].size, walls);
        struct space s = space_create(&scene, margin * domains[k].size);
        for (int n = 0; n < 3000; n++) {
            int a = n % 3;
            double x = random_between(&seed, scene.domain.min[a], scene.domain.max[a]);
            uint32_t count = space_count(&s, a, x);
            double back = space_metres(&s, a, count);
            if (walls == WALL_PERIODIC && x - back > s.length[a] / 2)
                back += s.length[a]; /* the far face is the near one */
            if (!(fabs(back - x) <= tolerance(&s, a, x)))
                fail_msg("domain %zu axis %d: %.17g came back as %.17g", k, a, x, back);
            if (walls != WALL_PERIODIC && (count < s.low[a] || count > s.high[a]))
                fail_msg("domain %zu axis %d: %.17g lies outside its planes", k, a, x);
        }
    }
}

static void comes_back_closed(void **state)
{
    (void)state;
    round_trips(WALL_CLOSED, 0);
}
static void comes_back_with_margin(void **state)
{
    (void)state;
    round_trips(WALL_PARTICLES, 0.1);
}
static void comes_back_periodic(void **state)
{
    (void)state;
    round_trips(WALL_PERIODIC, 0);
}

/* A double at 1e4 m resolves 1.8e-12 m; fixed point does not add to that for a domain of 1 mm. */
static void resolves_finely_far_away(void **state)
{
    (void)state;
    struct scene scene = domain(1e4, 1e-3, WALL_CLOSED);
    struct space s = space_create(&scene, 0);
    assert_true(s.unit[0] < 1e-12);
    uint32_t a = space_count(&s, 0, 1e4 + 2e-4), b = space_count(&s, 0, 1e4 + 5e-4);
    assert_true(fabs((int32_t)(b - a) * s.unit[0] - 3e-4) < 8e-12);
}

static void places_planes(void **state)
{
    (void)state;
    struct scene scene = domain(1, 2, WALL_CLOSED);
    struct space s = space_create(&scene, 0.5);
    assert_int_equal(s.low[0], 0);
    assert_true(s.high[0] == 0x80000000u);
    scene.domain.walls[0] = WALL_PARTICLES; /* margin on this face only */
    s = space_create(&scene, 0.5);
    assert_true(s.length[0] == 2.5 && s.origin[0] == 0.5);
    assert_true(fabs(space_metres(&s, 0, s.low[0]) - 1) <= s.unit[0]);
    assert_true(fabs(space_metres(&s, 0, s.high[0]) - 3) <= s.unit[0]);
}

/* Both faces of a periodic axis are one place, and differences take the nearest image. */
static void wraps_periodic(void **state)
{
    (void)state;
    struct scene scene = domain(-1, 4, WALL_PERIODIC);
    struct space s = space_create(&scene, 0);
    assert_true(s.unit[0] * 0x1p32 == s.length[0]);
    assert_int_equal(space_count(&s, 0, -1), space_count(&s, 0, 3));
    uint32_t left = space_count(&s, 0, -0.9), right = space_count(&s, 0, 2.9);
    double apart = (int32_t)(left - right) * s.unit[0];
    assert_true(fabs(apart - 0.2) < 2 * s.unit[0]);
    assert_true((int32_t)(right - left) == -(int32_t)(left - right));
}

/* The same scene elsewhere gives the same counts, when the shift is exact in binary. */
static void does_not_depend_on_place(void **state)
{
    (void)state;
    uint64_t seed = 5;
    struct scene here = domain(0, 1, WALL_CLOSED), there = domain(8192, 1, WALL_CLOSED);
    struct space a = space_create(&here, 0), b = space_create(&there, 0);
    for (int n = 0; n < 1000; n++) {
        double x = random_bits(&seed) % 65536 * 0x1p-16;
        assert_int_equal(space_count(&a, 0, x), space_count(&b, 0, 8192 + x));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(comes_back_closed),    cmocka_unit_test(comes_back_with_margin),
        cmocka_unit_test(comes_back_periodic),  cmocka_unit_test(resolves_finely_far_away),
        cmocka_unit_test(places_planes),        cmocka_unit_test(wraps_periodic),
        cmocka_unit_test(does_not_depend_on_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
