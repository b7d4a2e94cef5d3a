/* Tests the state hash: independent of the order in memory, sensitive to any one bit. */
#include "particles/particles.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

enum { COUNT = 333, FIELDS = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) |
                             FIELD_BIT(FIELD_DENSITY) | FIELD_BIT(FIELD_ID) };

static struct particles make(void)
{
    struct particles p;
    struct error e;
    uint64_t seed = 9;
    assert_int_equal(particles_create(&p, COUNT, FIELDS, &e), STATUS_OK);
    for (uint32_t i = 0; i < COUNT; i++) {
        for (int a = 0; a < 3; a++) {
            particles_position(&p)[i].count[a] = random_bits(&seed);
            particles_motion(&p)[i].velocity[a] = (float)random_between(&seed, -3, 3);
        }
        particles_density(&p)[i] = (float)random_between(&seed, 900, 1100);
        particles_id(&p)[i] = i;
    }
    return p;
}

static void ignores_order(void **state)
{
    (void)state;
    struct particles p = make(), q = make();
    uint32_t order[COUNT];
    uint64_t seed = 2;
    random_order(&seed, order, COUNT);
    for (uint32_t i = 0; i < COUNT; i++) {
        particles_position(&q)[i] = particles_position(&p)[order[i]];
        particles_motion(&q)[i] = particles_motion(&p)[order[i]];
        particles_density(&q)[i] = particles_density(&p)[order[i]];
        particles_id(&q)[i] = order[i];
    }
    assert_true(particles_hash(&p) == particles_hash(&q));
    particles_id(&q)[7] = order[8]; /* two particles change names */
    particles_id(&q)[8] = order[7];
    assert_false(particles_hash(&p) == particles_hash(&q));
    particles_free(&p);
    particles_free(&q);
}

/* Flips every bit of one word of each kind. */
static void sees_one_bit(void **state)
{
    (void)state;
    struct particles p = make();
    uint64_t hash = particles_hash(&p);
    void *words[] = {&particles_position(&p)[5].count[2], &particles_motion(&p)[COUNT - 1].velocity[0],
                     &particles_density(&p)[0], &particles_id(&p)[16]};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        for (int bit = 0; bit < 32; bit++) {
            uint32_t word, flipped;
            memcpy(&word, words[k], 4);
            flipped = word ^ 1u << bit;
            memcpy(words[k], &flipped, 4);
            if (particles_hash(&p) == hash)
                fail_msg("word %zu, bit %d does not show", k, bit);
            memcpy(words[k], &word, 4);
        }
    assert_true(particles_hash(&p) == hash);
    particles_free(&p);
}

static void counts_particles(void **state)
{
    (void)state;
    struct particles p = make();
    uint64_t hash = particles_hash(&p);
    p.count = COUNT - 1;
    assert_false(particles_hash(&p) == hash);
    p.count = 0;
    assert_false(particles_hash(&p) == hash);
    p.count = COUNT;
    particles_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ignores_order),
                                       cmocka_unit_test(sees_one_bit),
                                       cmocka_unit_test(counts_particles)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
