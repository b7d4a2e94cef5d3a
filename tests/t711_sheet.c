/* Contact sheets: their size, where pictures go, and that these are not changed. */
#include "render/sheet.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void fill(struct image *image, uint8_t value)
{
    memset(image->rgba, value, (size_t)image->width * (size_t)image->height * 4);
}

static bool has_value(const struct image *image, int x, int y, uint8_t value)
{
    const uint8_t *p = image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
    return p[0] == value && p[1] == value && p[2] == value;
}

/* Every cell begins a gap after the one before, and holds its picture to the last pixel. */
static void cells_are_in_rows(void **state)
{
    static const int cells[2] = {3, 2};
    struct scene scene;
    struct sheet *sheet;
    struct image picture;
    struct error e;
    int size[2];
    (void)state;
    fixture_scene(&scene, 320, 180);
    struct render_setup setup = fixture_setup(&scene, "auto");
    sheet_size(&scene, cells, size);
    int gap = (size[0] - 3 * 320) / 4, band = (size[1] - gap - 2 * 180) / 2;
    assert_int_equal(size[0], gap + 3 * (320 + gap));
    assert_int_equal(size[1], gap + 2 * (180 + band));
    assert_true(gap >= 8 && band > 2 * gap);
    assert_int_equal(sheet_open(&sheet, &setup, cells, &e), STATUS_OK);
    image_create(&picture, 320, 180, &e);
    for (int i = 0; i < 7; i++) { /* the last has no cell */
        fill(&picture, (uint8_t)(100 + i));
        sheet_add(sheet, 0.25 * i, &picture);
    }
    const struct image *image = sheet_image(sheet);
    assert_int_equal(image->width, size[0]);
    assert_int_equal(image->height, size[1]);
    for (int i = 0; i < 6; i++) {
        int left = gap + i % 3 * (320 + gap), top = gap + i / 3 * (180 + band);
        for (int y = 0; y < 180; y++)
            for (int x = 0; x < 320; x++)
                assert_true(has_value(image, left + x, top + y, (uint8_t)(100 + i)));
        assert_true(has_value(image, left - 1, top + 90, 0) && has_value(image, left, top - 1, 0));
    }
    image_free(&picture);
    sheet_close(sheet);
}

#if HAVE_CAIRO
static void times_stand_under_pictures(void **state)
{
    static const int cells[2] = {2, 1};
    struct scene scene;
    struct sheet *sheet;
    struct image picture;
    struct error e;
    int lit[2] = {0, 0};
    (void)state;
    fixture_scene(&scene, 64, 48); /* too small for text of its own */
    struct render_setup setup = fixture_setup(&scene, "auto");
    assert_int_equal(sheet_open(&sheet, &setup, cells, &e), STATUS_OK);
    image_create(&picture, 64, 48, &e);
    sheet_add(sheet, 1.5, &picture);
    const struct image *image = sheet_image(sheet);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            lit[x > image->width / 2] += !has_value(image, x, y, 0);
    assert_true(lit[0] > 50 && lit[1] == 0); /* the second cell is empty */
    image_free(&picture);
    sheet_close(sheet);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_in_rows),
#if HAVE_CAIRO
        cmocka_unit_test(times_stand_under_pictures),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
