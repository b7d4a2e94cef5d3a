/* Metrics against published values and their own properties. */
#include "compare/metric.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { WIDTH = 128, HEIGHT = 96 };

static const struct metric_settings settings = {.levels = 2};

static struct image picture(void)
{
    struct image image;
    struct error e;
    assert_int_equal(image_create(&image, WIDTH, HEIGHT, &e), STATUS_OK);
    return image;
}

static void fill(struct image *image, int red, int green, int blue)
{
    for (size_t i = 0; i < metric_pixels(image); i++)
        memcpy(image->rgba + 4 * i, ((uint8_t[]){(uint8_t)red, (uint8_t)green, (uint8_t)blue, 255}), 4);
}

/* Ramps of red and green, squares of blue; bit by bit what the reference values were made with. */
static void pattern(struct image *image, int shift, int altered)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            uint8_t *p = image->rgba + 4 * (y * WIDTH + x);
            int from = (x - shift + WIDTH) % WIDTH, green = (y * 2 + from) % 256;
            p[0] = (uint8_t)(from * 2 % 256);
            p[1] = (uint8_t)(altered && green > 252 ? 255 : green + 3 * altered);
            p[2] = (uint8_t)((from / 16 + y / 16) % 2 * 180 + 20);
            p[3] = 255;
            if (altered && y >= 20 && y < 40 && x >= 30 && x < 60)
                p[0] = (uint8_t)(255 - p[0]);
        }
}

static double score(const struct image *a, const struct image *b, const char *name)
{
    double values[SCORES_MAX];
    struct error e;
    size_t i = 0;
    assert_int_equal(metric_measure(a, b, &settings, values, &e), STATUS_OK);
    while (strcmp(metric_score(i)->name, name) != 0)
        i++;
    return values[i];
}

static void near(const struct image *a, const struct image *b, const char *name, double wanted,
                 double error)
{
    double value = score(a, b, name), back = score(b, a, name);
    printf("# %-10s %.7g, reference %.7g\n", name, value, wanted);
    assert_true(fabs(value - wanted) <= error);
    assert_true(fabs(value - back) <= 1e-6); /* symmetric */
}

/* Made with flip-evaluator 1.7, the program of FLIP's authors, at its default of 67 pixels a degree.
 * For black and white it says 0.967457, for each pixel 0.967388; single pixels agree to 1e-5. */
static void flip_reference(void **state)
{
    struct image a = picture(), b = picture();
    (void)state;
    fill(&a, 0, 0, 0);
    fill(&b, 255, 255, 255);
    near(&a, &b, "flip", 0.967388, 1e-5);
    fill(&a, 0, 255, 0);
    fill(&b, 0, 0, 255);
    near(&a, &b, "flip", 1, 1e-6);
    pattern(&a, 0, 0);
    pattern(&b, 0, 1);
    near(&a, &b, "flip", 0.1200008, 1e-6);
    near(&a, &b, "flip-p99", 0.6686279, 1e-6);
    pattern(&b, 1, 0);
    near(&a, &b, "flip", 0.1578762, 2e-6);
    near(&a, &b, "flip-p99", 0.9125723, 1e-6);
    image_free(&a);
    image_free(&b);
}

/* Of uniform pictures SSIM has only its first factor, and PSNR is a logarithm. */
static void uniform(void **state)
{
    struct image a = picture(), b = picture();
    double c1 = 0.01 * 255 * 0.01 * 255;
    (void)state;
    fill(&a, 100, 100, 100);
    fill(&b, 110, 110, 110);
    near(&a, &b, "ssim", (2 * 100 * 110 + c1) / (100 * 100 + 110 * 110 + c1), 1e-5);
    near(&a, &b, "psnr", 20 * log10(255 / 10.0), 1e-9);
    near(&a, &b, "difference", 10, 0);
    near(&a, &b, "over", 1, 0);
    image_free(&a);
    image_free(&b);
}

static void equal(void **state)
{
    struct image a = picture(), b = picture();
    (void)state;
    pattern(&a, 0, 0);
    pattern(&b, 0, 0);
    for (size_t i = 0; i < metric_score_count(); i++)
        assert_true(score(&a, &b, metric_score(i)->name) == metric_score(i)->equal);
    a.rgba[3] = 254; /* the same colour at 8 bits, but not the same bits: every metric is measured */
    near(&a, &b, "flip", 0, 1e-3);
    near(&a, &b, "ssim-tile", 1, 1e-3);
    near(&a, &b, "changed", 1.0 / (WIDTH * HEIGHT), 0);
    image_free(&a);
    image_free(&b);
}

/* A defect of 12 x 12 pixels is a small part of a frame, and a large one of its tile. */
static void small_defect(void **state)
{
    struct image a = picture(), b = picture();
    (void)state;
    fill(&a, 90, 90, 90);
    fill(&b, 90, 90, 90);
    for (int i = 0; i < 144; i++)
        memset(b.rgba + 4 * ((70 + i / 12) * WIDTH + 100 + i % 12), 200, 3);
    assert_true(1 - score(&a, &b, "ssim-tile") > 2.5 * (1 - score(&a, &b, "ssim")));
    assert_true(score(&a, &b, "ssim-tile") < 0.95);
    image_free(&a);
    image_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flip_reference),
        cmocka_unit_test(uniform),
        cmocka_unit_test(equal),
        cmocka_unit_test(small_defect),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
