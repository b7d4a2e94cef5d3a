/* Tests the vorticity that frames show: exact for linear flow, up to faces, edges and corners of a
 * disordered block, with every solver; the same bits in every way to run; the state stays as it is. */
#include "world.h"

#include "particles/particles.h"

enum { MOST = 4000 };

#define SCENE "{\"gravity\": [0, 0, 0], \"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 9},\n" \
              "\"domain\": {\"min\": [-0.5, -0.5, -0.5], \"max\": [0.5, 0.5, 0.5]},\n" \
              "\"fluids\": [{\"density\": 1000}], \"solver\": {\"method\": \"%s\"},\n" \
              "\"neighbours\": \"%s\", \"color\": {\"by\": \"vorticity\"}, \"bodies\": [%s]}"
#define BLOCK "{\"shape\": \"box\", \"min\": [-0.3, -0.3, -0.3], \"max\": [0.3, 0.3, 0.3], " \
              "\"jitter\": 0.1, %s}"
#define ROTATION "\"flow\": \"rotation\", \"flow_speed\": 3"
#define SHEAR "\"flow\": \"shear\", \"flow_speed\": 5, \"flow_length\": 2"

struct way {
    const char *method, *search, *isa;
    int threads;
};

/* Opens a world that draws; `body` is JSON. */
static void open(struct world *w, const struct way *way, const char *body)
{
    static const char *const outputs[] = {"hash"};
    static char text[4096];
    struct error *e = &w->error;
    int length = snprintf(text, sizeof text, SCENE, way->method, way->search, body);
    memset(w, 0, sizeof *w);
    w->options = (struct run_options){.threads = way->threads, .isa = way->isa,
                                      .outputs = outputs, .output_count = 1};
    if (scene_from_text(&w->scene, text, (size_t)length, NULL, &run_vocabulary, e) ||
        plan_make(&w->plan, w->scene, &w->options, e) ||
        simulation_open(&w->simulation, &w->plan, &w->options, e))
        fail_msg("%s", e->text);
}

static void curl(struct world *w)
{
    struct step step = {.list_radius = w->plan.choice.support};
    assert_true(w->plan.frame_pass == &pass_table[PASS_CURL]);
    if (w->simulation.row->run(w->simulation.backend, PASS_CURL, &step, &w->error))
        fail_msg("%s", w->error.text);
}

/* The largest error of vorticity relative to what it should be. */
static double worst(const char *method, const char *flow, double expected)
{
    struct way way = {method, "index-sort", "auto", 1};
    char body[400];
    struct world w;
    double most = 0;
    snprintf(body, sizeof body, BLOCK, flow);
    open(&w, &way, body);
    curl(&w);
    assert_in_range(world_state(&w)->count, 1000, MOST);
    for (size_t i = 0; i < world_state(&w)->count; i++)
        most = fmax(most, fabs((double)particles_vorticity(world_state(&w))[i] / expected - 1));
    world_close(&w);
    printf("# %s, %.20s: error %.2g\n", method, flow, most);
    return most;
}

static void linear_flow(void **state)
{
    static const char *const methods[] = {"isph", "wcsph", "dfsph", "muller"};
    (void)state;
    for (size_t m = 0; m < sizeof methods / sizeof *methods; m++) {
        assert_true(worst(methods[m], ROTATION, 6) < 2e-6);
        assert_true(worst(methods[m], SHEAR, 2.5) < 2e-6);
    }
}

/* One particle, and a single layer, have no gradient. */
static void flat(void **state)
{
    struct way way = {"isph", "index-sort", "auto", 1};
    struct world w;
    (void)state;
    open(&w, &way, "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.05, 0.05, 0.05], " ROTATION
                   "}, {\"shape\": \"box\", \"min\": [-0.4, -0.4, -0.4], \"max\": [0.4, -0.35, 0.4], "
                   ROTATION "}");
    curl(&w);
    for (size_t i = 0; i < world_state(&w)->count; i++)
        assert_true(particles_vorticity(world_state(&w))[i] == 0);
    world_close(&w);
}

/* Vorticity by id after some steps. */
static size_t vorticity(const struct way *way, float *out)
{
    struct world w;
    char body[400];
    snprintf(body, sizeof body, BLOCK, ROTATION);
    open(&w, way, body);
    for (int k = 0; k < 5; k++)
        assert_int_equal(simulation_step(&w.simulation, INFINITY, &w.error), STATUS_OK);
    uint64_t before = particles_hash(world_state(&w));
    curl(&w);
    assert_true(particles_hash(world_state(&w)) == before);
    size_t count = world_state(&w)->count;
    for (size_t i = 0; i < count; i++)
        out[particles_id(world_state(&w))[i]] = particles_vorticity(world_state(&w))[i];
    world_close(&w);
    return count;
}

static void same_bits(void **state)
{
    static const struct way ways[] = {
        {"isph", "index-sort", "scalar", 1}, {"isph", "index-sort", "auto", 1},
        {"isph", "index-sort", "auto", 3},   {"isph", "all-pairs", "auto", 2},
    };
    static float first[MOST], next[MOST];
    size_t count = vorticity(&ways[0], first);
    (void)state;
    for (size_t k = 1; k < sizeof ways / sizeof *ways; k++) {
        assert_int_equal(vorticity(&ways[k], next), count);
        assert_memory_equal(first, next, count * sizeof *first);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_flow),
        cmocka_unit_test(flat),
        cmocka_unit_test(same_bits),
    };
    log_set_level(LOG_ERROR);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
