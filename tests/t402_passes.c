/* Tests every pair pass of every instruction set, bit for bit against the scalar one, and that one
 * against plain sums in double precision over all pairs. */
#include "pairs_reference.h"

#include <omp.h>
#include <stdio.h>

static const struct isa_row *isas[8];
static size_t isa_count;

static const size_t counts[] = {1, 2, 15, 16, 17, 33, 150};
static const enum cloud_kind kinds[] = {CLOUD_FLOW, CLOUD_CROWD, CLOUD_COINCIDENT, CLOUD_SPARSE,
                                        CLOUD_AT_EDGE};

/* Calls check on clouds of every kind and size, closed and periodic. */
static void for_each_cloud(void (*check)(struct cloud *))
{
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (size_t n = 0; n < sizeof counts / sizeof *counts; n++)
            for (int periodic = 0; periodic < 2; periodic++) {
                struct cloud cloud;
                cloud_make(&cloud, kinds[k], counts[n], periodic, 10 * k + n);
                check(&cloud);
                cloud_free(&cloud);
            }
}

/* Neighbours of every particle are the same, in the same order; padding may differ. */
static void compare_rows(const struct cloud *c, const struct rows *a, const struct rows *b)
{
    for (size_t i = 0; i < c->count; i++) {
        size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
        assert_int_equal(a->count[i], b->count[i]);
        for (size_t k = 0; k < a->count[i]; k++)
            assert_int_equal(a->block[block].index[k * PARTICLE_BLOCK + lane],
                             b->block[block].index[k * PARTICLE_BLOCK + lane]);
    }
}

static void check_rows(struct cloud *c)
{
    for (size_t k = 0; k < isa_count; k++)
        for (int wall = 0; wall < 2; wall++) {
            struct rows rows;
            cloud_rows(c, isas[k], &rows, wall);
            compare_rows(c, wall ? &c->wall_rows : &c->rows, &rows);
            rows_free(&rows);
        }
}

/* Rows hold everybody within the list radius, ascending, and nobody else. */
static void check_rows_complete(struct cloud *c)
{
    const struct position *x = particles_position(&c->particles);
    for (size_t i = 0; i < c->count; i++) {
        uint32_t k = 0;
        for (uint32_t j = 0; j < c->count; j++) {
            double apart[3], q = reference_between(c, &x[i], &x[j], apart);
            if (j == i || q > CLOUD_REACH + 1e-6)
                continue;
            uint32_t entry = k < c->rows.count[i] ? c->rows.block[i / PARTICLE_BLOCK]
                                 .index[k * PARTICLE_BLOCK + i % PARTICLE_BLOCK] : UINT32_MAX;
            if (entry == 2 * j) /* an entry is twice the index */
                k++;
            else if (q < CLOUD_REACH - 1e-6)
                fail_msg("particle %zu misses %u", i, j);
        }
        assert_int_equal(k, c->rows.count[i]);
    }
}

static void check_density(struct cloud *c)
{
    static float scalar[200];
    for (unsigned flags = 0; flags < 3; flags++) {
        cloud_run(c, cloud_find(&isa_scalar, PAIR_PASS_DENSITY, flags, false));
        memcpy(scalar, c->number, c->count * sizeof *scalar);
        for (size_t i = 0; i < c->count; i++) {
            double exact = reference_number(c, flags, i);
            if (!(fabs(scalar[i] - exact) < 1e-6 * exact + 4e-7 * (c->rows.count[i] + c->wall_rows.count[i])))
                fail_msg("kernel %u: particle %zu has %.9g, not %.9g", flags, i, scalar[i], exact);
        }
        for (size_t k = 0; k < isa_count; k++) {
            memset(c->number, 0xff, c->count * sizeof *c->number);
            cloud_run(c, cloud_find(isas[k], PAIR_PASS_DENSITY, flags, false));
            if (memcmp(c->number, scalar, c->count * sizeof *scalar) != 0)
                fail_msg("density pass of %s, kernel %u differs", isas[k]->variant.name, flags);
        }
    }
}

/* Runs both passes of diffusion by gradients, on rates that are set. */
static void run_diffusion(struct cloud *c, const struct isa_row *isa, unsigned flags)
{
    struct rate *rate = particles_rate(&c->particles);
    memset(c->particles.now[FIELD_GRADIENT], 0xff, c->count * sizeof(struct gradient));
    for (size_t i = 0; i < c->count; i++)
        rate[i] = (struct rate){{1, 2, 3}, (float)i};
    cloud_run(c, cloud_find(isa, PAIR_PASS_GRADIENT, flags, false));
    cloud_run(c, cloud_find(isa, PAIR_PASS_DIFFUSION, flags, false));
}

static void check_diffusion(struct cloud *c)
{
    static const unsigned kernels[] = {0, 1, PAIR_MIXED, PAIR_MIXED | 1};
    static struct gradient gradient[200];
    static struct rate rate[200];
    for (size_t f = 0; f < sizeof kernels / sizeof *kernels; f++) {
        run_diffusion(c, &isa_scalar, kernels[f]);
        memcpy(gradient, c->particles.now[FIELD_GRADIENT], c->count * sizeof *gradient);
        memcpy(rate, particles_rate(&c->particles), c->count * sizeof *rate);
        for (size_t i = 0; i < c->count; i++)
            assert_true(isfinite(rate[i].density));
        for (size_t k = 0; k < isa_count; k++) {
            run_diffusion(c, isas[k], kernels[f]);
            if (memcmp(gradient, c->particles.now[FIELD_GRADIENT], c->count * sizeof *gradient) != 0 ||
                memcmp(rate, particles_rate(&c->particles), c->count * sizeof *rate) != 0)
                fail_msg("diffusion of %s, flags %u differs", isas[k]->variant.name, kernels[f]);
        }
    }
}

static void check_force_bits(struct cloud *c, unsigned flags, bool walls)
{
    static struct rate scalar[200];
    struct rate *rate = particles_rate(&c->particles);
    pair_function *pass = cloud_find(&isa_scalar, PAIR_PASS_FORCE, flags, walls);
    memset(rate, 0xff, c->count * sizeof *rate);
    cloud_run(c, pass);
    memcpy(scalar, rate, c->count * sizeof *rate);
    for (size_t k = 0; k < isa_count; k++) {
        memset(rate, 0xff, c->count * sizeof *rate);
        cloud_run(c, cloud_find(isas[k], PAIR_PASS_FORCE, flags, walls));
        if (memcmp(rate, scalar, c->count * sizeof *rate) != 0)
            fail_msg("force pass of %s, flags %u%s differs, %zu particles", isas[k]->variant.name,
                     flags, walls ? " with walls" : "", c->count);
    }
    memcpy(rate, scalar, c->count * sizeof *rate);
}

static void check_force_values(const struct cloud *c, unsigned flags, bool walls)
{
    for (size_t i = 0; i < c->count; i += 1 + c->count / 20) {
        struct reference exact = reference_rate(c, flags, walls, i);
        const struct rate *rate = &particles_rate(&c->particles)[i];
        for (int k = 0; k < 4; k++) {
            double value = k < 3 ? rate->acceleration[k] : rate->density;
            if (!(fabs(value - exact.rate[k]) < 3e-6 * exact.scale[k]))
                fail_msg("flags %u%s: particle %zu of %zu, rate %d is %.9g, not %.9g (terms %.3g)",
                         flags, walls ? " with walls" : "", i, c->count, k, value, exact.rate[k],
                         exact.scale[k]);
        }
    }
}

static void check_force(struct cloud *c)
{
    for (unsigned flags = 0; flags < PAIR_FLAGS_END; flags++)
        for (int walls = 0; walls < 2; walls++) {
            if (!cloud_find(&isa_scalar, PAIR_PASS_FORCE, flags, walls))
                continue;
            check_force_bits(c, flags, walls);
            check_force_values(c, flags, walls);
        }
}

static void rows_equal_scalar(void **state)
{
    (void)state;
    for_each_cloud(check_rows);
}
static void rows_are_complete(void **state)
{
    (void)state;
    for_each_cloud(check_rows_complete);
}
static void density_equals_scalar(void **state)
{
    (void)state;
    for_each_cloud(check_density);
}
static void force_equals_scalar(void **state)
{
    (void)state;
    for_each_cloud(check_force);
}

static void diffusion_equals_scalar(void **state)
{
    (void)state;
    for_each_cloud(check_diffusion);
}

/* Every combination that wcsph and muller can choose has a pass, in every instruction set. */
static void passes_exist(void **state)
{
    static const unsigned viscosity[] = {0, PAIR_VISCOUS, PAIR_OWN_VISCOSITY};
    static const unsigned density[] = {0, PAIR_CONTINUITY, PAIR_CONTINUITY | PAIR_DIFFUSION};
    (void)state;
    for (size_t k = 0; k < isa_count; k++)
        for (int walls = 0; walls < 2; walls++)
            for (int v = 0; v < 3; v++) {
                for (unsigned a = 0; a <= PAIR_ARTIFICIAL; a += PAIR_ARTIFICIAL) {
                    unsigned flags = PAIR_MULLER | viscosity[v] | a;
                    assert_non_null(cloud_find(isas[k], PAIR_PASS_FORCE, flags, walls));
                    if (viscosity[v] != PAIR_VISCOUS)
                        assert_non_null(cloud_find(isas[k], PAIR_PASS_FORCE, flags | PAIR_MIXED, walls));
                }
                for (unsigned rest = 0; rest < 24; rest++) {
                    unsigned flags = rest % 2 | (rest / 2 % 2) * PAIR_ARTIFICIAL |
                                     (rest / 4 % 2) * PAIR_SYMMETRIC | density[rest / 8] |
                                     viscosity[v];
                    if (!(flags & (PAIR_SYMMETRIC | PAIR_VISCOUS)))
                        assert_non_null(cloud_find(isas[k], PAIR_PASS_FORCE, flags | PAIR_MIXED, walls));
                    if (!cloud_find(isas[k], PAIR_PASS_FORCE, flags, walls))
                        fail_msg("%s has no pass for flags %u", isas[k]->variant.name, flags);
                }
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_exist),          cmocka_unit_test(rows_equal_scalar),
        cmocka_unit_test(rows_are_complete),     cmocka_unit_test(density_equals_scalar),
        cmocka_unit_test(force_equals_scalar),   cmocka_unit_test(diffusion_equals_scalar),
    };
    omp_set_num_threads(1); /* the clouds are small */
    for (size_t i = 0; i < isa_table.count; i++) {
        const struct isa_row *isa = (const struct isa_row *)isa_table.rows[i];
        if (isa->supported())
            isas[isa_count++] = isa;
        printf("# %s: %s\n", isa->variant.name, isa->supported() ? "tested" : "not on this machine");
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
