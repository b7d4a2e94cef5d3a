/* The mean of samples by OpenGL against plain C: 1 to 16 samples of 8 and 16 bits, over every background. */
#include "render/context.h"
#include "render/resolve.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum { WIDTH = 37, HEIGHT = 23, MOST = 4, UNSIGNED_SHORT = 0x1403 };

static const struct gl_context_row *row_now; /* each of the build in turn */
static void *context_now;
static struct gl gl;

/* Rows from the bottom; colours are times alpha. */
static uint16_t drawn[HEIGHT * MOST * WIDTH * MOST][4];
static uint8_t found[HEIGHT * WIDTH][4];

static void samples_make(int samples, bool deep, bool opaque)
{
    uint64_t seed = 5;
    const int most = deep ? 65535 : 255;
    for (int i = 0; i < WIDTH * HEIGHT * samples * samples; i++) {
        double part = fixture_random(&seed) * 2 - 0.5; /* often nothing, often all */
        int alpha = opaque || part > 1 ? most : part < 0 ? 0 : (int)(part * most);
        for (int k = 0; k < 3; k++)
            drawn[i][k] = (uint16_t)(fixture_random(&seed) * (alpha + 1));
        drawn[i][3] = (uint16_t)alpha;
    }
}

static GLuint texture_make(int samples, bool deep)
{
    static uint8_t bytes[HEIGHT * MOST * WIDTH * MOST][4];
    GLuint texture;
    GLsizei width = WIDTH * samples, height = HEIGHT * samples;
    for (int i = 0; i < width * height; i++)
        for (int k = 0; k < 4; k++)
            bytes[i][k] = (uint8_t)drawn[i][k];
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, deep ? GL_RGBA16 : GL_RGBA8, width, height, 0, GL_RGBA,
                  deep ? UNSIGNED_SHORT : GL_UNSIGNED_BYTE, deep ? (void *)drawn : (void *)bytes);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/* Sums of a pixel's samples, each rounded to a byte; y counts from the top. */
static void sum_of(int x, int y, int samples, bool deep, int sum[4])
{
    memset(sum, 0, 4 * sizeof *sum);
    for (int j = 0; j < samples; j++)
        for (int i = 0; i < samples; i++) {
            const uint16_t *s = drawn[((HEIGHT - 1 - y) * samples + j) * WIDTH * samples + x * samples + i];
            for (int k = 0; k < 4; k++)
                sum[k] += deep ? (s[k] + 128) / 257 : s[k];
        }
}

/* Not rounded. */
static void expect(const struct scene *scene, int y, const int sum[4], int count, double out[4])
{
    const double *low = scene->render.background, *high = scene->render.background_top;
    double empty = 1 - sum[3] / (255.0 * count), hidden = scene->render.transparent ? 0 : 1;
    double alpha = 1 - empty * (1 - hidden), whole = alpha > 0 ? alpha : 1;
    for (int k = 0; k < 3; k++) {
        double back = isnan(high[k]) ? low[k] : high[k] + (y + 0.5) / HEIGHT * (low[k] - high[k]);
        out[k] = ((double)sum[k] / count + 255 * empty * back * hidden) / whole;
    }
    out[3] = 255 * alpha;
}

/* Exactly the rounded mean; with a background behind it, floats may round the other way near a half. */
static void check(const struct scene *scene, int samples, bool deep, bool over)
{
    int wrong = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        int sum[4];
        double out[4];
        sum_of(i % WIDTH, i / WIDTH, samples, deep, sum);
        expect(scene, i / WIDTH, sum, samples * samples, out);
        for (int k = 0; k < 4; k++) {
            double up = found[i][k] - out[k];
            wrong += over ? fabs(up) > 0.51 : up <= -0.5 || up > 0.5;
        }
    }
    printf("# %d x %d samples of %d bits%s%s: %d bytes are wrong\n", samples, samples, deep ? 16 : 8,
           scene->render.transparent ? ", transparent" : "",
           isnan(scene->render.background_top[0]) ? "" : ", gradient", wrong);
    assert_int_equal(wrong, 0);
}

static void run(struct scene *scene, int samples, bool deep)
{
    struct resolve resolve = {0};
    struct error e = {.text = ""};
    const bool over = scene->render.transparent || !isnan(scene->render.background_top[0]);
    samples_make(samples, deep, !over);
    GLuint texture = texture_make(samples, deep);
    if (resolve_open(&resolve, &gl, scene, WIDTH, HEIGHT, samples, deep, &e) != STATUS_OK)
        fail_msg("%s", e.text);
    for (int turn = 0; turn < 2; turn++) { /* the state that is left does no harm */
        memset(found, 99, sizeof found);
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_BLEND);
        if (resolve_read(&resolve, &gl, texture, found[0], &e) != STATUS_OK)
            fail_msg("%s", e.text);
        check(scene, samples, deep, over);
    }
    resolve_close(&resolve, &gl);
    resolve_close(&resolve, &gl); /* also when nothing is open */
    gl.DeleteTextures(1, &texture);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static void means(void **state)
{
    static const double low[3] = {0.9, 0.31, 0.02}, high[3] = {0.1, 0.2, 0.9};
    (void)state;
    for (int look = 0; look < 4; look++)
        for (int samples = 1; samples <= MOST; samples++)
            for (int deep = 0; deep < 2; deep++) {
                struct scene scene;
                fixture_scene(&scene, WIDTH, HEIGHT);
                memcpy(scene.render.background, low, sizeof low);
                if (look & 1)
                    memcpy(scene.render.background_top, high, sizeof high);
                scene.render.transparent = look & 2;
                run(&scene, samples, deep);
            }
}

static int context_open(void **state)
{
    struct error e = {.text = ""};
    (void)state;
    if (row_now->open(&context_now, -1, &e) == STATUS_OK && row_now->bind(context_now, &e) == STATUS_OK &&
        gl_load(&gl, row_now->getproc, context_now, &e) == STATUS_OK)
        return 0;
    printf("# %s\n", e.text);
    return 1;
}

static int context_close(void **state)
{
    (void)state;
    row_now->unbind(context_now);
    row_now->close(context_now);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(means)};
    const struct { const struct gl_context_row *row; const char *missing; } rows[] = {
        {&context_egl, EGL_MISSING}, {&context_osmesa, OSMESA_MISSING}};
    int failed = 0;
    for (size_t i = 0; i < 2; i++) {
        row_now = rows[i].row;
        printf("# %s%s\n", row_now->name, rows[i].missing ? " SKIP: not in this build" : "");
        failed += rows[i].missing ? 0 : cmocka_run_group_tests_name(row_now->name, tests, context_open,
                                                                     context_close);
    }
    return failed;
}
