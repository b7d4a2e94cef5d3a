/* Tests the cell sort: canonical order, starts of cells, crowds, none and one particle. */
#include "grid/cells.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct space cube(double length, bool periodic)
{
    struct space s = {0};
    for (int a = 0; a < 3; a++) {
        s.length[a] = length;
        s.periodic[a] = periodic;
        s.unit[a] = length * (periodic ? 0x1p-32 : 0x1p-31);
    }
    return s;
}

static size_t cell_of(const struct cells *c, const struct position *p)
{
    size_t x = cells_axis(c, 0, p->count[0]), y = cells_axis(c, 1, p->count[1]);
    return (cells_axis(c, 2, p->count[2]) * (size_t)c->size[1] + y) * c->size[0] + x;
}

/* Sorts `count` particles, of coordinates below `most` (0: all), and checks the order. */
static void check(size_t count, bool periodic, double radius, uint32_t most)
{
    struct space space = cube(1, periodic);
    struct cells cells = {0};
    struct error e = {0};
    uint64_t seed = count + periodic;
    struct position *position = calloc(count + 1, sizeof *position);
    uint32_t *id = calloc(count + 1, 4), *order = calloc(count + 1, 4);
    uint32_t *scratch = calloc(count + 1, 4), *seen = calloc(count + 1, 4);
    random_order(&seed, id, (uint32_t)count);
    for (size_t i = 0; i < count; i++)
        for (int a = 0; a < 3; a++) {
            uint32_t x = periodic ? random_bits(&seed) : random_bits(&seed) >> 1;
            position[i].count[a] = most ? x % most : x;
        }
    cells_resize(&cells, &space, radius, count);
    assert_int_equal(cells_sort(&cells, position, id, count, order, scratch, &e), STATUS_OK);
    assert_int_equal(cells.start[0], 0);
    assert_int_equal(cells.start[cells.count], count);
    for (size_t c = 0; c < cells.count; c++)
        for (uint32_t k = cells.start[c]; k < cells.start[c + 1]; k++) {
            if (cell_of(&cells, &position[order[k]]) != c)
                fail_msg("particle %u is not in cell %zu", order[k], c);
            if (k > cells.start[c] && id[order[k - 1]] >= id[order[k]])
                fail_msg("cell %zu is not in order of id", c);
            seen[order[k]]++;
        }
    for (size_t i = 0; i < count; i++)
        assert_int_equal(seen[i], 1);
    cells_free(&cells);
    free(position), free(id), free(order), free(scratch), free(seen);
}

static void sorts_any_number(void **state)
{
    static const size_t counts[] = {0, 1, 2, 15, 16, 17, 1000, 30000};
    (void)state;
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        for (int periodic = 0; periodic < 2; periodic++) {
            check(counts[k], periodic, 0.05, 0);
            check(counts[k], periodic, 0.4, 0);
            check(counts[k], periodic, 2, 0); /* one cell */
        }
}

/* Cells of 97 particles and more take another way of sorting. */
static void sorts_crowds(void **state)
{
    (void)state;
    check(96, false, 0.1, 1000);
    check(97, false, 0.1, 1000);
    check(20000, false, 0.1, 1000);
    check(20000, true, 0.1, 0xffffffffu / 9);
}

/* More cells than one thread scans. */
static void sorts_into_many_cells(void **state)
{
    (void)state;
    check(20000, false, 0.02, 0);
}

/* Cells are never smaller than the radius, and stay in proportion to the particles. */
static void sizes_cells(void **state)
{
    struct cells cells = {0};
    (void)state;
    for (double radius = 0.003; radius < 3; radius *= 1.37)
        for (size_t count = 0; count < 3000000; count = 10 * count + 1) {
            struct space space = cube(1, count % 2);
            cells_resize(&cells, &space, radius, count);
            assert_true(cells.size[0] == 1 || 1.0 / cells.size[0] >= radius * (1 - 1e-12));
            assert_true((double)cells.count <= 8.0 * (double)count + 4096);
            assert_int_equal(cells.count, (size_t)cells.size[0] * cells.size[1] * cells.size[2]);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sorts_any_number),
                                       cmocka_unit_test(sorts_crowds),
                                       cmocka_unit_test(sorts_into_many_cells),
                                       cmocka_unit_test(sizes_cells)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
