/* sph-render compare: exit codes, limits, and the difference picture. */
#include "base/image.h"
#include "tools/compare.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/sph-compare-XXXXXX";
static char paths[4][64]; /* base, changed, smaller, difference */

/* Runs it with up to six arguments; its stdout is not part of the TAP. */
static int run(const char *a, const char *b, const char *c, const char *d, const char *f,
               const char *g)
{
    char *argv[] = {(char *)"compare", (char *)a, (char *)b, (char *)c, (char *)d, (char *)f,
                    (char *)g, NULL};
    int argc = 1, result, kept = dup(1);
    while (argv[argc])
        argc++;
    fflush(stdout);
    assert_non_null(freopen("/dev/null", "w", stdout));
    result = tool_compare.run(argc, argv);
    fflush(stdout);
    dup2(kept, 1);
    close(kept);
    return result;
}

static void same_and_different(void **state)
{
    (void)state;
    assert_int_equal(run(paths[0], paths[0], NULL, NULL, NULL, NULL), 0);
    assert_int_equal(run(paths[0], paths[1], NULL, NULL, NULL, NULL), 1);
    assert_int_equal(run(paths[0], paths[2], NULL, NULL, NULL, NULL), 1);
}

/* The changed picture has 4 of 400 pixels off by 9 in one channel. */
static void limits(void **state)
{
    (void)state;
    assert_int_equal(run(paths[0], paths[1], "--max-channel", "8", NULL, NULL), 1);
    assert_int_equal(run(paths[0], paths[1], "--max-channel", "9", NULL, NULL), 0);
    assert_int_equal(run(paths[0], paths[1], "--max-fraction", "0.0099", NULL, NULL), 1);
    assert_int_equal(run("--max-fraction=0.01", paths[0], paths[1], NULL, NULL, NULL), 0);
}

/* 396 of 400 pixels are equal, and 4 differ by 9. */
static void gates(void **state)
{
    (void)state;
    assert_int_equal(run(paths[0], paths[0], "--gate", "exact", NULL, NULL), 0);
    assert_int_equal(run(paths[0], paths[1], "--gate", "exact", NULL, NULL), 1);
    assert_int_equal(run(paths[0], paths[1], "--gate", "exact", "--max-changed", "0.01"), 0);
    assert_int_equal(run(paths[0], paths[1], "--max-channel=9", "--max-difference", "8", NULL), 1);
    assert_int_equal(run(paths[0], paths[1], "--max-channel=9", "--max-difference", "9", NULL), 0);
    assert_int_equal(run(paths[0], paths[1], "--max-channel=9", "--min-psnr", "54", NULL), 1);
    assert_int_equal(run(paths[0], paths[1], "--max-channel=9", "--min-psnr", "53", NULL), 0);
}

/* Any accepted version will do. */
static void versions(void **state)
{
    (void)state;
    assert_int_equal(run(paths[1], paths[0], paths[1], NULL, NULL, NULL), 0);
    assert_int_equal(run(paths[1], paths[2], paths[1], NULL, NULL, NULL), 0);
    assert_int_equal(run(paths[1], paths[0], paths[2], NULL, NULL, NULL), 1);
}

static void usage(void **state)
{
    (void)state;
    assert_int_equal(run(NULL, NULL, NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(paths[0], NULL, NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(paths[0], "/nonexistent.png", NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(paths[0], "/dev/null", NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--max-channel", "x", NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--max-fraction", "1.5", NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--nonsense", NULL, NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--gate", "exat", NULL, NULL), 2);
    assert_int_equal(run(paths[0], folder, NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(folder, "/nonexistent/*.png", NULL, NULL, NULL, NULL), 2);
    assert_int_equal(run(folder, folder, "--diff", paths[3], NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--json", "/nonexistent/j.json", NULL, NULL), 2);
    assert_int_equal(run(paths[0], paths[0], "--diff", "/nonexistent/d.png", NULL, NULL), 2);
    assert_int_equal(run("--help", NULL, NULL, NULL, NULL, NULL), 0);
}

static void difference_picture(void **state)
{
    struct image diff;
    struct error e;
    (void)state;
    assert_int_equal(run(paths[0], paths[1], "--diff", paths[3], NULL, NULL), 1);
    assert_int_equal(image_read_png(&diff, paths[3], &e), STATUS_OK);
    assert_memory_equal(diff.rgba, ((const uint8_t[]){0, 144, 0, 255}), 4);
    assert_memory_equal(diff.rgba + 40, ((const uint8_t[]){0, 0, 0, 255}), 4);
    image_free(&diff);
}

static int pictures_make(void **state)
{
    static const char *const names[] = {"base", "changed", "smaller", "difference"};
    struct image image;
    struct error e;
    int failed = 0;
    (void)state;
    if (!mkdtemp(folder) || image_create(&image, 20, 20, &e) != STATUS_OK)
        return -1;
    for (int i = 0; i < 4; i++)
        snprintf(paths[i], sizeof paths[i], "%s/%s.png", folder, names[i]);
    memset(image.rgba, 100, 20 * 20 * 4);
    failed |= image_write_png(&image, paths[0], &e);
    for (int i = 0; i < 4; i++)
        image.rgba[i * 4 + 1] += 9;
    failed |= image_write_png(&image, paths[1], &e);
    image.height = 19;
    failed |= image_write_png(&image, paths[2], &e);
    image_free(&image);
    return failed ? -1 : 0;
}

/* Both frames and the differences beside each other. */
static void side_by_side(void **state)
{
    struct image side;
    struct error e;
    (void)state;
    assert_int_equal(run(paths[0], paths[1], "--side-by-side", paths[3], NULL, NULL), 1);
    assert_int_equal(image_read_png(&side, paths[3], &e), STATUS_OK);
    assert_int_equal(side.width, 60);
    assert_int_equal(side.rgba[1] + 9, side.rgba[4 * 20 + 1]);
    assert_int_equal(side.rgba[4 * 40 + 1], 144);
    image_free(&side);
}

static int pictures_remove(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++)
        remove(paths[i]);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_and_different),
        cmocka_unit_test(limits),
        cmocka_unit_test(gates),
        cmocka_unit_test(versions),
        cmocka_unit_test(usage),
        cmocka_unit_test(difference_picture),
        cmocka_unit_test(side_by_side),
    };
    return cmocka_run_group_tests(tests, pictures_make, pictures_remove);
}
