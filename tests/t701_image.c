/* PNG files: round trip, every kind read as RGBA8, and failures that leave no mess. */
#include "base/image.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/sph-image-XXXXXX";

static const char *in_folder(const char *name)
{
    static char paths[4][200];
    static int next;
    char *path = paths[next++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static struct image noise(int width, int height)
{
    struct image image;
    struct error e;
    uint32_t state = 1;
    assert_int_equal(image_create(&image, width, height, &e), STATUS_OK);
    for (size_t i = 0; i < (size_t)width * (size_t)height * 4; i++)
        image.rgba[i] = (uint8_t)((state = state * 1664525U + 1013904223U) >> 24);
    return image;
}

static void assert_same(const struct image *a, const struct image *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_memory_equal(a->rgba, b->rgba, (size_t)a->width * (size_t)a->height * 4);
}

static void round_trip(void **state)
{
    static const int sizes[][2] = {{1, 1}, {3, 7}, {640, 1}, {321, 243}};
    struct error e;
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct image image = noise(sizes[i][0], sizes[i][1]), back;
        assert_int_equal(image_write_png(&image, in_folder("a.png"), &e), STATUS_OK);
        assert_int_equal(image_read_png(&back, in_folder("a.png"), &e), STATUS_OK);
        assert_same(&image, &back);
        assert_int_equal(access(in_folder("a.png.part"), F_OK), -1);
        image_free(&image);
        image_free(&back);
    }
}

static void write_kind(png_uint_32 format, const void *pixels, const void *colormap)
{
    png_image png = {.version = PNG_IMAGE_VERSION, .width = 2, .height = 1, .format = format,
                     .colormap_entries = colormap ? 2 : 0};
    assert_int_not_equal(png_image_write_to_file(&png, in_folder("kind.png"), 0, pixels, 0,
                                                 colormap), 0);
}

static void assert_reads(const uint8_t expected[8])
{
    struct image image;
    struct error e;
    assert_int_equal(image_read_png(&image, in_folder("kind.png"), &e), STATUS_OK);
    assert_int_equal(image.width, 2);
    assert_int_equal(image.height, 1);
    assert_memory_equal(image.rgba, expected, 8);
    image_free(&image);
}

static void other_kinds(void **state)
{
    static const uint8_t grey[] = {0, 200}, rgb[] = {1, 2, 3, 4, 5, 6}, index[] = {1, 0};
    static const uint8_t palette[] = {9, 8, 7, 10, 20, 30};
    static const png_uint_16 grey16[] = {0, 65535};
    (void)state;
    write_kind(PNG_FORMAT_GRAY, grey, NULL);
    assert_reads((const uint8_t[]){0, 0, 0, 255, 200, 200, 200, 255});
    write_kind(PNG_FORMAT_RGB, rgb, NULL);
    assert_reads((const uint8_t[]){1, 2, 3, 255, 4, 5, 6, 255});
    write_kind(PNG_FORMAT_RGB_COLORMAP, index, palette);
    assert_reads((const uint8_t[]){10, 20, 30, 255, 9, 8, 7, 255});
    write_kind(PNG_FORMAT_LINEAR_Y, grey16, NULL);
    assert_reads((const uint8_t[]){0, 0, 0, 255, 255, 255, 255, 255});
}

static void assert_unreadable(const char *name)
{
    struct image image;
    struct error e = {.text = ""};
    assert_int_equal(image_read_png(&image, in_folder(name), &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, name));
    assert_null(image.rgba);
}

static void bad_files(void **state)
{
    struct image image = noise(64, 64);
    struct error e;
    FILE *file;
    (void)state;
    assert_unreadable("missing.png");
    file = fopen(in_folder("text.png"), "w");
    fputs("this is no picture", file);
    fclose(file);
    assert_unreadable("text.png");
    assert_int_equal(image_write_png(&image, in_folder("cut.png"), &e), STATUS_OK);
    assert_int_equal(truncate(in_folder("cut.png"), 5000), 0);
    assert_unreadable("cut.png");
    assert_int_equal(truncate(in_folder("cut.png"), 0), 0);
    assert_unreadable("cut.png");
    image_free(&image);
}

static void no_folder(void **state)
{
    struct image image = noise(4, 4);
    struct error e = {.text = ""};
    (void)state;
    assert_int_equal(image_write_png(&image, in_folder("none/a.png"), &e), STATUS_OUTPUT);
    assert_non_null(strstr(e.text, "none/a.png"));
    image_free(&image);
}

/* A file size limit stands for the full disk. */
static void full_disk(void **state)
{
    struct image small = noise(8, 8), large = noise(300, 300), back;
    struct error e = {.text = ""};
    struct rlimit before, limit;
    (void)state;
    assert_int_equal(image_write_png(&small, in_folder("kept.png"), &e), STATUS_OK);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before);
    limit = before;
    limit.rlim_cur = 20000;
    setrlimit(RLIMIT_FSIZE, &limit);
    enum status status = image_write_png(&large, in_folder("kept.png"), &e);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_int_equal(status, STATUS_OUTPUT);
    assert_non_null(strstr(e.text, strerror(EFBIG)));
    assert_int_equal(access(in_folder("kept.png.part"), F_OK), -1);
    assert_int_equal(image_read_png(&back, in_folder("kept.png"), &e), STATUS_OK);
    assert_same(&small, &back);
    image_free(&small);
    image_free(&large);
    image_free(&back);
}

static void empty_image(void **state)
{
    struct image image;
    struct error e;
    (void)state;
    assert_int_equal(image_create(&image, 0, 5, &e), STATUS_RUN);
    assert_int_equal(image_create(&image, 5, -1, &e), STATUS_RUN);
    image_free(&image);
}

static int folder_make(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int folder_remove(void **state)
{
    static const char *const names[] = {"a.png", "kind.png", "text.png", "cut.png", "kept.png"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        remove(in_folder(names[i]));
    return rmdir(folder); /* fails when a test left something behind */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(round_trip), cmocka_unit_test(other_kinds), cmocka_unit_test(bad_files),
        cmocka_unit_test(no_folder),  cmocka_unit_test(full_disk),   cmocka_unit_test(empty_image),
    };
    return cmocka_run_group_tests(tests, folder_make, folder_remove);
}
