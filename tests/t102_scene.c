/* Tests loading of scenes: defaults, options of variants, overrides, every semantic error. */
#include "scene_words.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>

#define SPHERE "{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], \"radius\": 0.2}"
#define BODIES(list) SCENE_HEAD SCENE_FLUID " \"bodies\": [" list "],\n" SCENE_END
#define WITH(member) SCENE_HEAD SCENE_FLUID " " member ",\n" SCENE_END
#define OBSTACLES(list) WITH("\"obstacles\": [" list "]")
#define CUBE "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.2, 0.2, 0.2]}"
#define CUBES_4 CUBE ", " CUBE ", " CUBE ", " CUBE
#define CUBES_16 CUBES_4 ", " CUBES_4 ", " CUBES_4 ", " CUBES_4
#define DOMAIN(inside) \
    "{\"domain\": {" inside "}, \"particles\": {\"spacing\": 0.1},\n" SCENE_FLUID SCENE_END

/* `place` is ":LINE:COLUMN:" in the file, "" where only the text matters. */
static const struct { const char *text, *place, *says; } refused[] = {
    {"[]", ":1:1:", "must be an object"},
    {"3", ":1:1:", "must be an object"},
    {SCENE_HEAD SCENE_FLUID "}", ":2:31:", "remove it"},
    {SCENE_HEAD SCENE_END, ":1:1:", "\"fluids\" is missing"},
    {SCENE_HEAD "\"fluids\": [],\n" SCENE_END, ":2:11:", "\"fluids\" is empty"},
    {SCENE_HEAD "\"fluids\": {},\n" SCENE_END, ":2:11:", "array of objects"},
    {SCENE_HEAD "\"fluids\": [3],\n" SCENE_END, ":2:12:", "fluids.0 must be an object"},
    {SCENE_HEAD SCENE_FLUID "\"time\": {}}", ":3:9:", "\"time.end\" is missing"},
    {SCENE_HEAD SCENE_FLUID "\"title\": \"x\"}", ":1:1:", "\"time.end\" is missing"},
    {SCENE_HEAD "\"fluids\": [{\"name\": \"a\"}, {\"name\": \"a\"}],\n" SCENE_END, ":2:36:",
     "its own name"},
    {SCENE_HEAD "\"fluids\": [{\"name\": \"\"}],\n" SCENE_END, ":2:21:", "empty"},
    {SCENE_HEAD "\"fluids\": [{\"density\": 0}],\n" SCENE_END, ":2:24:", "above 0"},
    {SCENE_HEAD "\"fluids\": [{\"viscosity\": -1}],\n" SCENE_END, ":2:26:", "at least 0"},
    {SCENE_HEAD "\"fluids\": [{\"densty\": 1}],\n" SCENE_END, ":2:13:", "\"fluids.0.density\"?"},
    {WITH("\"gravty\": [0, 0, 0]"), ":3:2:", "did you mean \"gravity\"?"},
    {WITH("\"spacing\": 0.1"), ":3:2:", "\"particles.spacing\"?"},
    {WITH("\"zzz\": 1"), ":3:2:", "known here: title, gravity, central_force"},
    {WITH("\"title\": \"a\", \"title\": \"b\""), ":3:16:", "said twice"},
    {WITH("\"title\": 3"), ":3:11:", "title must be a string, not 3"},
    {WITH("\"gravity\": [0, 0]"), ":3:13:", "array of 3 numbers"},
    {WITH("\"gravity\": [0, 0, \"g\"]"), ":3:20:", "array of 3 numbers"},
    {WITH("\"gravity\": [0, 0, 1e999]"), ":3:20:", "not finite"},
    {WITH("\"gravity\": null"), ":3:13:", "not null"},
    {WITH("\"movie\": {\"size\": [8, 720]}"), ":3:21:", "from 16 to 16384"},
    {WITH("\"movie\": {\"size\": [1280.5, 720]}"), ":3:21:", "whole numbers"},
    {WITH("\"movie\": {\"fps\": 0}"), ":3:19:", "above 0 and up to 1000"},
    {WITH("\"movie\": {\"start\": 2}"), ":3:21:", "after time.end"},
    {WITH("\"movie\": {\"speed\": 1e-9}"), ":4:18:", "frames"},
    {WITH("\"movie\": 3"), ":3:11:", "movie must be an object"},
    {WITH("\"color\": {\"range\": [3, 1]}"), ":3:21:", "above the first"},
    {WITH("\"color\": {\"scale\": \"log\", \"range\": [0, 1]}"), ":3:37:", "log scale begins above 0"},
    {WITH("\"color\": {\"steps\": 1}"), ":3:21:", "one colour shows nothing"},
    {WITH("\"color\": {\"steps\": 300}"), ":3:21:", "from 0 to 256"},
    {WITH("\"color\": {\"scale\": \"logarithm\"}"), ":3:21:", "known: auto, linear, log, symmetric"},
    {WITH("\"color\": {\"percentiles\": [99, 1]}"), ":3:27:", "above the first"},
    {WITH("\"color\": {\"percentiles\": [1, 99], \"range\": [0, 1]}"), ":3:27:", "both given"},
    {WITH("\"color\": {\"map\": \"grey\", \"map_file\": \"a\"}"), ":3:39:", "both given"},
    {WITH("\"labels\": [{\"text\": \"a\", \"at\": \"middle\"}]"), ":3:33:", "known: top-left"},
    {WITH("\"labels\": [{\"at\": \"top\"}]"), ":3:13:", "labels.0.text\" is missing"},
    {WITH("\"color\": {\"legend\": 1}"), ":3:22:", "true or false, not 1"},
    {WITH("\"camera\": {\"up\": [0, 0, 0]}"), ":3:19:", "no direction"},
    {WITH("\"camera\": {\"eye\": [0.5, 0.5, 0.5]}"), ":3:20:", "is its target"},
    {WITH("\"camera\": {\"eye\": [0.5, 9, 0.5]}"), ":3:12:", "along the view"},
    {WITH("\"solver\": {\"method\": \"ipsh\"}"), ":3:23:", "did you mean \"isph\"?"},
    {WITH("\"solver\": {\"method\": \"auto\"}"), ":3:23:", "known: isph, muller, quantum"},
    {WITH("\"solver\": {\"method\": \"quantum\"}"), ":3:23:", "not in this build: make QUANTUM=1"},
    {WITH("\"solver\": {\"clamp\": true}"), ":3:22:", "\"muller\", and it is \"isph\""},
    {WITH("\"solver\": {\"eos\": \"tate\"}"), ":3:20:", "did you mean \"tait\"?"},
    {WITH("\"solver\": {\"delta\": 2}"), ":3:22:", "from 0 to 1"},
    {WITH("\"time\": {\"step\": \"fast\"}, \"title\": \"\""), "", "said twice"},
    {DOMAIN("\"min\": [0, 0, 0]"), ":1:12:", "\"domain.max\" is missing"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 0, 1]"), ":1:38:", "not above domain.min along y"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 0.05, 1]"), ":1:78:", "more than the domain's"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 1, 1e9]"), "", "a millionth"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 1, 1], \"walls\": \"open\""), ":1:58:",
     "known: closed, particles, periodic"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 1, 1], \"walls\": 3"), 
     ":1:58:", "domain.walls must be one of closed|particles|periodic"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 1, 1], \"walls\": {\"-z\": \"periodic\"}"), ":1:65:",
     "come in pairs"},
    {DOMAIN("\"min\": [0, 0, 0], \"max\": [1, 1, 1], \"walls\": {\"z\": \"periodic\"}"), ":1:59:",
     "unknown key \"domain.walls.z\""},
    {BODIES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5]}"), ":3:13:",
     "\"bodies.0.radius\" is missing"},
    {BODIES("{\"min\": [0, 0, 0]}"), ":3:13:", "\"bodies.0.shape\" is missing"},
    {BODIES("{\"shape\": \"sphre\"}"), ":3:23:", "did you mean \"sphere\"?"},
    {BODIES("{\"shape\": \"box\", \"min\": [0,0,0], \"max\": [1,1,1], \"radius\": 1}"), ":3:72:",
     "for shape sphere or cylinder only"},
    {BODIES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], \"radius\": 0}"), ":3:70:",
     "above 0"},
    {BODIES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.9], \"radius\": 0.2}"), ":3:43:",
     "outside the domain"},
    {BODIES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], \"radius\": 0.04}"), ":3:70:",
     "less than particles.spacing"},
    {BODIES("{\"shape\": \"box\", \"min\": [0,0,0], \"max\": [0.5,0,0.5]}"), ":3:53:",
     "not above bodies.0.min along y"},
    {BODIES("{\"shape\": \"box\", \"min\": [-1,0,0], \"max\": [1,1,1]}"), ":3:37:",
     "outside the domain"},
    {BODIES(SPHERE ", {\"shape\": \"box\", \"min\": [0,0,0], \"max\": [0.4,0.5,0.5]}"), "",
     "bodies.1 (box) overlaps bodies.0 (sphere)"},
    {OBSTACLES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5]}"), ":3:16:",
     "\"obstacles.0.radius\" is missing"},
    {OBSTACLES(CUBE ", {\"shape\": \"box\", \"min\": [0,0,0], \"max\": [1,1,1], \"axis\": \"x\"}"), "",
     "obstacles.1.axis is for shape cylinder only, and the shape here is box"},
    {OBSTACLES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.9], \"radius\": 0.2}"), ":3:46:",
     "obstacles.0: this sphere reaches z = 1.1 m, outside the domain"},
    {OBSTACLES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], \"radius\": 0.04}"), ":3:73:",
     "less than particles.spacing"},
    {OBSTACLES("{\"shape\": \"box\", \"min\": [0,0,0], \"max\": [0.5,0,0.5]}"), ":3:56:",
     "not above obstacles.0.min along y"},
    {OBSTACLES("{\"shape\": \"box\", \"min\": [0,0,0], \"max\": [1,1,1], \"fluid\": \"water\"}"), ":3:65:",
     "unknown key \"obstacles.0.fluid\""},
    {OBSTACLES(CUBES_16 ", " CUBES_16 ", " CUBES_16 ", " CUBES_16 ", " CUBE), ":3:15:",
     "there are 65, and at most 64 are supported"},
    {BODIES("{\"fluid\": \"watr\", \"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], "
            "\"radius\": 1}"), ":3:23:", "did you mean \"water\""},
    {BODIES("{\"shape\": \"sphere\", \"center\": [0.5, 0.5, 0.5], "
            "\"radius\": 0.2, \"seed\": 1.5}"), "",
     "whole number"},
};

static void refuses_with_place(void **state)
{
    int bad = 0;
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        struct scene *scene;
        struct error e = {0};
        enum status status = load_text(&scene, refused[i].text, strlen(refused[i].text), NULL, &e);
        assert_null(scene);
        if (status != STATUS_USAGE || !strstr(e.text, refused[i].says) ||
            !strstr(e.text, refused[i].place))
            print_error("%s\nwanted %s %s\ngot %d: %s\n", refused[i].text, refused[i].place,
                        refused[i].says, status, e.text), bad++;
    }
    assert_int_equal(bad, 0);
}

static struct scene *load_set(const char *text, const char *const *items, size_t count)
{
    struct scene *scene;
    struct error e = {0};
    struct scene_overrides set = {.items = items, .count = count};
    if (load_text(&scene, text, strlen(text), &set, &e))
        fail_msg("%s", e.text);
    return scene;
}

static void fills_defaults(void **state)
{
    (void)state;
    struct scene *s = load_set(BODIES(SPHERE), NULL, 0);
    assert_string_equal(s->solver.method, "isph");
    assert_string_equal(s->neighbours, "auto");
    assert_true(s->gravity[1] == -9.81);
    assert_true(isnan(s->time.step) && isnan(s->camera.eye[0]) && isnan(s->color.range[1]));
    assert_int_equal(s->movie.size[0], 1280);
    assert_true(s->color.legend && s->render.box && !s->render.boundary);
    assert_int_equal(s->fluid_count, 1);
    assert_true(s->fluids[0].density == 1000);
    assert_int_equal(s->body_count, 1);
    assert_int_equal(s->bodies[0].shape.kind, SHAPE_SPHERE);
    assert_string_equal(s->bodies[0].fluid_name, "water");
    scene_free(s);
}

static void keeps_options_of_the_chosen(void **state)
{
    (void)state;
    static const char *const items[] = {"solver.method=muller", "drag.wind=[1, 2, 3]"};
    struct scene *s = load_set(SCENE_PLAIN, NULL, 0);
    assert_true(scene_real(s, "solver.delta") == 0.1);
    assert_true(isnan(scene_real(s, "solver.sound_speed")));
    assert_string_equal(scene_text(s, "solver.eos"), "tait");
    assert_false(scene_flag(s, "solver.clamp"));
    assert_true(scene_vector(s, "drag.wind")[2] == 1);
    assert_int_equal(scene_integer(s, "drag.steps"), 4);
    scene_free(s);
    s = load_set(SCENE_PLAIN, items, 2);
    assert_true(isnan(scene_real(s, "solver.delta")));
    assert_true(scene_real(s, "solver.sound_speed") == 20); /* the path that both share */
    assert_true(scene_flag(s, "solver.clamp"));
    assert_true(scene_vector(s, "drag.wind")[1] == 2);
    scene_free(s);
}

static void applies_overrides(void **state)
{
    (void)state;
    static const char *const items[] = {
        "time.end=2", "time.end=3", "title=a \"b\"", "fluids.0.viscosity=1", "gravity=[0, 0, 0]",
        "domain.walls=particles", "domain.walls.-x=periodic", "domain.walls.+x=periodic",
        "bodies.0.radius=0.3", "time.step=auto", "color={\"range\": [1, 2], \"legend\": false}",
        "domain.max.=0"};
    struct scene *s = load_set(BODIES(SPHERE), items, 11);
    assert_true(s->time.end == 3 && s->fluids[0].viscosity == 1 && s->gravity[1] == 0);
    assert_string_equal(s->title, "a \"b\"");
    assert_int_equal(s->domain.walls[0], WALL_PERIODIC);
    assert_int_equal(s->domain.walls[2], WALL_PARTICLES);
    assert_true(s->bodies[0].shape.radius == 0.3 && s->color.range[1] == 2 && !s->color.legend);
    scene_free(s);
    static const char *const emptied[] = {"bodies=[]", "title=\"quoted\"", "title=7"};
    s = load_set(BODIES(SPHERE), emptied, 3);
    assert_int_equal(s->body_count, 0);
    assert_string_equal(s->title, "7");
    scene_free(s);
}

/* Of two keys that exclude each other the override's counts. */
static void forgets_excluded(void **state)
{
    static const char text[] = WITH("\"color\": {\"range\": [3, 5], \"map_file\": \"x\"}");
    static const char *const items[] = {"color.percentiles=[1, 99]", "color.map=viridis"};
    static const char *const usual[] = {"color.percentiles=auto", "color.map=auto"};
    (void)state;
    struct scene *s = load_set(text, items, 2);
    assert_true(isnan(s->color.range[0]) && s->color.percentiles[1] == 99 && !s->color.map_file[0]);
    scene_free(s);
    s = load_set(text, usual, 2);
    assert_true(s->color.range[0] == 3 && s->color.map_file[0] == 'x');
    scene_free(s);
}

/* Ranges are of the file's quantity, unless an override gives them or chooses the same one. */
static void forgets_ranges(void **state)
{
    (void)state;
    static const char text[] = WITH("\"color\": {\"range\": [3, 5]}, \"render\": {\"show_range\": [1, 2]}");
    static const char *const items[] = {"color.by=pressure", "color={\"by\": \"pressure\"}", "color.by=velocity"};
    for (size_t i = 0; i < 3; i++) {
        struct scene *s = load_set(text, items + i, 1);
        assert_true(isnan(s->color.range[0]) == (i < 2) && isnan(s->render.show_range[1]) == (i < 2));
        scene_free(s);
    }
    static const char *const back[] = {"color.by=pressure", "color.by=velocity"};
    struct scene *same = load_set(text, back, 2);
    assert_true(same->color.range[0] == 3);
    scene_free(same);
    static const char *const ranged[] = {"color.range=[7, 8]", "color.by=pressure", "render.show_range=[0, 1]"};
    struct scene *s = load_set(text, ranged, 3);
    assert_true(s->color.range[0] == 7 && s->render.show_range[1] == 1);
    scene_free(s);
}

static const struct { const char *item, *says; } bad_items[] = {
    {"time", "write key.path=value"},
    {"=3", "write key.path=value"},
    {"time.ned=3", "did you mean \"time.end\"?"},
    {"time.end=", "--set time.end=: the text is empty"},
    {"time.end=soon", "must be a number of at least 0, not \"soon\""},
    {"time.end=-1", "out of range"},
    {"time.end=1 2", "after the end"},
    {"time.end.x=1", "unknown key"},
    {"time=3", "time must be an object"},
    {"fluids.water.density=1", "addressed by number"},
    {"fluids.1.density=1", "there is no fluids.1"},
    {"fluids.0=3", "fluids.0 must be an object"},
    {"fluids=3", "array of objects"},
    {"domain.walls.-x=periodic", "its opposite +x is not"},
    {"domain.walls=open", "domain.walls: \"open\" is unknown"},
    {"gravity=[0,0", "never closed"},
    {"bodies.0.shape=ball", "known: box, sphere, cylinder"},
    {"bodies.0.min=[0,0,0]", "for shape box only"},
    {"..=1", "unknown key"},
    {"fluids.=1", "addressed by number"},
    {"fluids.0.=1", "must be an object"},
};

static void refuses_overrides(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof bad_items / sizeof *bad_items; i++) {
        struct scene *scene;
        struct error e = {0};
        struct scene_overrides set = {.items = &bad_items[i].item, .count = 1};
        const char *text = BODIES(SPHERE);
        enum status status = load_text(&scene, text, strlen(text), &set, &e);
        assert_null(scene);
        if (status != STATUS_USAGE || !strstr(e.text, bad_items[i].says) ||
            !strstr(e.text, "--set "))
            fail_msg("%s\nwanted %s\ngot %d: %s", bad_items[i].item, bad_items[i].says, status,
                     e.text);
    }
}

static char *written(const struct scene *s)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    scene_write(s, &words, out);
    fclose(out);
    return text;
}

static void round_trips(void **state)
{
    (void)state;
    static const char *const items[] = {
        "title=\"\\u00e9\\n\\\"\"", "gravity=[0.1, -9.80665, 1e-300]", "time.step=0.1",
        "domain.walls.-y=particles", "solver.sound_speed=34.5", "bodies.0.seed=9007199254740993",
        "drag.steps=9", "camera.eye=[3, 2, 1]"};
    static const char text[] =
        BODIES(SPHERE ", {\"shape\": \"cylinder\", \"center\": [0.2, 0.2, 0.2], "
               "\"radius\": 0.1, \"height\": 0.3, \"axis\": \"z\"}], \"obstacles\": [" CUBE ", " SPHERE);
    struct scene *a = load_set(text, items, 8);
    assert_int_equal(a->bodies[0].seed, 9007199254740993);
    char *first = written(a);
    struct scene *b = load_set(first, NULL, 0);
    char *second = written(b);
    assert_string_equal(first, second);
    for (size_t i = 0; i < a->body_count; i++)
        a->bodies[i].place = b->bodies[i].place = (struct scene_place){0};
    assert_memory_equal(a->bodies, b->bodies, a->body_count * sizeof *a->bodies);
    assert_memory_equal(a->gravity, b->gravity, sizeof a->gravity);
    assert_true(a->obstacle_count == 2 && b->obstacle_count == 2 && a->obstacles[1].visible);
    for (size_t i = 0; i < 2; i++)
        assert_memory_equal(&a->obstacles[i].shape, &b->obstacles[i].shape, sizeof a->obstacles->shape);
    free(first);
    free(second);
    scene_free(a);
    scene_free(b);
}

/* Both owners of a path shape its schema; words of tables become enums. */
static void schema_knows_options(void **state)
{
    (void)state;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    scene_write_schema(&words, out);
    fclose(out);
    assert_non_null(strstr(text, "\"anyOf\": [{\"const\": \"auto\"}, {\"type\": \"number\", "
                                 "\"minimum\": 0}, {\"type\": \"number\", \"minimum\": 0}]"));
    assert_non_null(strstr(text, "\"enum\": [\"isph\", \"muller\", \"quantum\"]"));
    assert_non_null(strstr(text, "an option (for drag)"));
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_with_place), cmocka_unit_test(fills_defaults),
        cmocka_unit_test(keeps_options_of_the_chosen), cmocka_unit_test(applies_overrides),
        cmocka_unit_test(forgets_ranges), cmocka_unit_test(forgets_excluded),
        cmocka_unit_test(refuses_overrides),
        cmocka_unit_test(round_trips), cmocka_unit_test(schema_knows_options)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
