/* Loads damaged copies of a scene: whatever is in the file, an answer and no crash.
 * Built by t112_fuzz.sh with sanitizers; usage: scene_fuzz SCENE... */
#include "scene_words.h"

static int count, failed;

static void try_text(const char *name, const char *text, size_t length)
{
    struct scene *scene;
    struct error e = {0};
    enum status status = load_text(&scene, text, length, NULL, &e);
    count++;
    if ((status == STATUS_OK) != (scene != NULL) ||
        (status && (status != STATUS_USAGE || !strstr(e.text, "/tmp/sph-scene-")))) {
        printf("# %s: status %d: %s\n", name, status, e.text);
        failed++;
    }
    scene_free(scene);
}

/* Words that mutations put in, so that they pass the grammar more often. */
static const char *const splices[] = {"1e999", "-1", "\"auto\"", "[]", "{}", "null", "0", "1e-300",
                                      "\"\"", "[0, 0, 0]", "true", "9007199254740993", "1e300",
                                      "[{}]", "\"\\ud83d\\ude00\""};

static unsigned next_random(unsigned *state)
{
    return *state = *state * 1664525u + 1013904223u;
}

/* Replaces a value (from a colon to the next comma or bracket) by another one. */
static size_t splice(const char *text, size_t length, char *out, unsigned *random)
{
    size_t from = next_random(random) / 7 % length;
    while (from < length && text[from] != ':' && text[from] != '[')
        from++;
    size_t to = from + (from < length);
    while (to < length && !strchr(",}]", text[to]))
        to++;
    const char *word = splices[next_random(random) / 11 % (sizeof splices / sizeof *splices)];
    size_t head = from + (from < length);
    memcpy(out, text, head);
    memcpy(out + head, word, strlen(word));
    memcpy(out + head + strlen(word), text + to, length - to);
    return head + strlen(word) + length - to;
}

/* Every word for keys of every kind. */
static void try_overrides(const char *text, size_t length)
{
    static const char *const paths[] = {
        "title", "gravity", "domain", "domain.min", "domain.walls", "domain.walls.+y", "particles",
        "particles.spacing", "fluids", "fluids.0", "fluids.0.density", "bodies", "bodies.0",
        "bodies.0.shape", "bodies.0.seed", "bodies.0.max", "solver.method", "solver.sound_speed",
        "time.end", "movie.size", "camera.eye", "color.range", "drag.wind", "", ".", "bodies.-1"};
    for (size_t p = 0; p < sizeof paths / sizeof *paths; p++) {
        for (size_t w = 0; w < sizeof splices / sizeof *splices; w++) {
            char item[128];
            const char *items[] = {item, "time.step=auto"};
            struct scene_overrides set = {.items = items, .count = 2};
            struct scene *scene;
            struct error e = {0};
            snprintf(item, sizeof item, "%s=%s", paths[p], splices[w]);
            enum status status = load_text(&scene, text, length, &set, &e);
            count++;
            failed += (status == STATUS_OK) != (scene != NULL) || (status && status != STATUS_USAGE);
            scene_free(scene);
        }
    }
}

static void fuzz(const char *name, const char *text, size_t length)
{
    char *copy = malloc(length + 64);
    unsigned random = 1;
    if (!copy)
        return;
    for (size_t n = 0; n <= length; n++)
        try_text(name, text, n);
    for (size_t i = 0; i < length; i++) {
        memcpy(copy, text, length);
        copy[i] ^= (char)(1 << (next_random(&random) >> 16) % 8);
        try_text(name, copy, length);
    }
    for (int i = 0; i < 3000; i++) {
        size_t size = splice(text, length, copy, &random);
        try_text(name, copy, size);
    }
    try_overrides(text, length);
    free(copy);
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        static char text[1 << 16];
        FILE *file = fopen(argv[i], "rb");
        if (!file)
            return 1;
        size_t length = fread(text, 1, sizeof text, file);
        fclose(file);
        count = failed = 0;
        fuzz(argv[i], text, length);
        printf("%s %d - %s: %d damaged copies\n", failed ? "not ok" : "ok", i, argv[i], count);
    }
    printf("1..%d\n", argc - 1);
    return 0;
}
