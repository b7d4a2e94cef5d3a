/* Tests neighbour searches against brute force: complete, ascending and disjoint ranges. */
#include "grid/search.h"
#include "random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

enum { COUNT = 700 };

struct cloud {
    struct space space;
    struct cells cells;
    struct position position[COUNT]; /* sorted */
};

/* Random particles, some of them on faces and on cell edges. */
static void scatter(struct cloud *c, struct position *out, uint64_t *seed)
{
    for (size_t i = 0; i < COUNT; i++)
        for (int a = 0; a < 3; a++) {
            uint32_t top = c->space.periodic[a] ? 0xffffffffu : 0x80000000u, x = random_bits(seed);
            x = c->space.periodic[a] ? x : x >> 1;
            if (i % 7 == 0) /* an edge of a cell, or one count beside it */
                x = (uint32_t)((uint64_t)top * (x % 7) / 6) - (i % 2 && x % 7);
            out[i].count[a] = x;
        }
}

static void cloud_make(struct cloud *c, const double length[3], const bool periodic[3],
                       uint64_t *seed)
{
    static struct position unsorted[COUNT];
    static uint32_t id[COUNT], order[COUNT], scratch[COUNT];
    struct error e = {0};
    for (int a = 0; a < 3; a++) {
        c->space.length[a] = length[a];
        c->space.periodic[a] = periodic[a];
        c->space.unit[a] = length[a] * (periodic[a] ? 0x1p-32 : 0x1p-31);
    }
    scatter(c, unsorted, seed);
    for (uint32_t i = 0; i < COUNT; i++)
        id[i] = i;
    cells_resize(&c->cells, &c->space, 1, COUNT);
    assert_int_equal(cells_sort(&c->cells, unsorted, id, COUNT, order, scratch, &e), STATUS_OK);
    for (size_t i = 0; i < COUNT; i++)
        c->position[i] = unsorted[order[i]];
}

static bool near(const struct cloud *c, const struct position *p, const struct position *q)
{
    double r2 = 0;
    for (int a = 0; a < 3; a++) {
        double d = (int32_t)(p->count[a] - q->count[a]) * c->space.unit[a];
        r2 += d * d;
    }
    return r2 < 1;
}

/* Every particle within distance 1 is in a range; returns candidates over all particles. */
static size_t search(const struct cloud *c, const struct search_row *row)
{
    size_t candidates = 0;
    for (size_t i = 0; i < COUNT; i++) {
        struct range r[RANGES_MAX];
        bool offered[COUNT] = {false};
        int n = row->ranges(&c->cells, c->position[i].count, COUNT, r);
        assert_in_range(n, 1, RANGES_MAX);
        for (int k = 0; k < n; k++) {
            assert_true(r[k].first < r[k].last && r[k].last <= COUNT);
            assert_true(k == 0 || r[k - 1].last <= r[k].first);
            for (uint32_t j = r[k].first; j < r[k].last; j++)
                offered[j] = true;
            candidates += r[k].last - r[k].first;
        }
        for (size_t j = 0; j < COUNT; j++)
            if (near(c, &c->position[i], &c->position[j]) && !offered[j])
                fail_msg("%s: particle %zu does not find %zu", row->variant.name, i, j);
    }
    return candidates;
}

/* Cells of 1 m: domains that are 1 to 6 cells long, each axis periodic or not. */
static void finds_all_neighbours(void **state)
{
    static const double lengths[][3] = {{1, 2, 3},     {3, 3, 3},       {2, 2, 2},
                                        {4, 1.9, 2.9}, {5.7, 6.3, 4.1}, {0.4, 0.7, 9}};
    static struct cloud cloud;
    uint64_t seed = 4;
    (void)state;
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++)
        for (int mask = 0; mask < 8; mask++) {
            const bool periodic[3] = {mask & 1, mask & 2, mask & 4};
            cloud_make(&cloud, lengths[k], periodic, &seed);
            size_t sorted = search(&cloud, &search_index_sort);
            size_t all = search(&cloud, &search_all_pairs);
            assert_int_equal(all, (size_t)COUNT * COUNT);
            assert_true(sorted <= all);
            if (lengths[k][0] > 5)
                assert_true(sorted < all / 2); /* it does save work */
        }
    cells_free(&cloud.cells);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(finds_all_neighbours)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
