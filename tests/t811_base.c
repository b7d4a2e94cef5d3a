/* Labelled memory, messages and progress, and queues between threads. */
#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/queue.h"

#include <pty.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static bool is_zero(const char *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++)
        if (bytes[i])
            return false;
    return true;
}

static void blocks_are_aligned_and_zeroed(void **state)
{
    const size_t sizes[] = {0, 1, 63, 64, 65, 1000, (1 << 20) - 1, (1 << 20) + 1, 5000001};
    struct error e;
    (void)state;
    for (int round = 0; round < 2; round++)
        for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            char *block = memory_create("test", sizes[i], 1, &e);
            assert_non_null(block);
            assert_int_equal((uintptr_t)block % 64, 0);
            assert_true(is_zero(block, sizes[i]));
            memset(block, 0xff, sizes[i]);
            memory_free(block);
        }
    memory_free(NULL);
    assert_int_equal(memory_now(), 0);
}

static void sum_label(void *context, const char *label, size_t bytes)
{
    if (strcmp(label, "a") == 0)
        ((size_t *)context)[0] += bytes;
    else
        ((size_t *)context)[1] += bytes;
    ((size_t *)context)[2]++;
}

static void labels_are_summed(void **state)
{
    char other_a[] = "a";
    size_t sums[3] = {0, 0, 0}, after[3] = {0, 0, 0};
    struct error e;
    (void)state;
    void *one = memory_create("a", 10, 10, &e), *two = memory_create(other_a, 1, 1, &e),
         *three = memory_create("b", 3, 8, &e);
    memory_each(sum_label, sums);
    assert_int_equal(sums[0], 101);
    assert_int_equal(sums[1], 24);
    assert_int_equal(sums[2], 2);
    assert_int_equal(memory_now(), 125);
    assert_true(memory_peak() >= 125);
    memory_free(one);
    memory_free(three);
    memory_each(sum_label, after);
    assert_int_equal(after[0], 1);
    assert_int_equal(after[2], 1);
    memory_free(two);
    assert_int_equal(memory_now(), 0);
}

static void too_much_is_an_error(void **state)
{
    struct error e = {STATUS_OK, ""};
    (void)state;
    assert_null(memory_create("positions", SIZE_MAX / 2, 3, &e));
    assert_int_equal(e.status, STATUS_RUN);
    assert_non_null(strstr(e.text, "positions"));
    e.status = STATUS_OK;
    assert_null(memory_create("positions", SIZE_MAX / 8, 4, &e));
    assert_int_equal(e.status, STATUS_RUN);
    assert_int_equal(memory_now(), 0);
}

/* Runs talk() with stderr as a pipe or a terminal, and returns what came out. */
static const char *heard(void (*talk)(void), bool terminal)
{
    static char text[8000];
    int ends[2], saved = dup(STDERR_FILENO);
    fflush(stderr);
    if (terminal)
        assert_int_equal(openpty(&ends[0], &ends[1], NULL, NULL, NULL), 0);
    else
        assert_int_equal(pipe(ends), 0);
    dup2(ends[1], STDERR_FILENO);
    talk();
    fflush(stderr);
    dup2(saved, STDERR_FILENO);
    close(saved);
    close(ends[1]); /* so that reading ends */
    size_t size = 0;
    for (ssize_t more; (more = read(ends[0], text + size, sizeof text - 1 - size)) > 0;)
        size += (size_t)more;
    text[size] = 0;
    close(ends[0]);
    return text;
}

static void talk_all(void)
{
    log_error("bad %d", 1);
    log_info("news");
    log_detail("detail");
}

static void talk_progress(void)
{
    log_progress(0, 10, "frame 0");
    nanosleep(&(struct timespec){0, 150000000}, NULL);
    log_progress(4, 10, "frame 4");
    log_info("news");
    log_progress(5, 10, "frame 5");
    log_progress_end();
}

static void levels_choose_messages(void **state)
{
    (void)state;
    log_set_level(LOG_ERROR);
    assert_string_equal(heard(talk_all, false), "sph-render: error: bad 1\n");
    log_set_level(LOG_DETAIL);
    assert_string_equal(heard(talk_all, false), "sph-render: error: bad 1\nnews\ndetail\n");
    log_set_level(LOG_INFO);
    assert_string_equal(heard(talk_all, false), "sph-render: error: bad 1\nnews\n");
}

static void colour_only_on_a_terminal(void **state)
{
    (void)state;
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
    assert_non_null(strstr(heard(talk_all, true), "\033[1;31m"));
    assert_null(strstr(heard(talk_all, false), "\033"));
    setenv("NO_COLOR", "1", 1);
    assert_null(strstr(heard(talk_all, true), "\033"));
    unsetenv("NO_COLOR");
}

static void progress_only_on_a_terminal(void **state)
{
    (void)state;
    assert_string_equal(heard(talk_progress, false), "news\n");
    log_set_level(LOG_ERROR);
    assert_string_equal(heard(talk_progress, true), "");
    log_set_level(LOG_INFO);
    setenv("TERM", "dumb", 1);
    assert_string_equal(heard(talk_progress, true), "news\r\n");
    setenv("TERM", "xterm", 1);
    const char *text = heard(talk_progress, true);
    assert_non_null(strstr(text, "\r  0% ["));
    assert_non_null(strstr(text, "--:-- left"));
    assert_non_null(strstr(text, "\r 40% ["));
    assert_non_null(strstr(text, "0:00 left  frame 4"));
    assert_non_null(strstr(text, "\r\033[Knews\r\n")); /* the message takes the line's place */
    assert_string_equal(text + strlen(text) - 4, "\r\033[K");
}

enum { ITEMS = 20000 };

static struct queue forth, back;

static void *echo(void *argument)
{
    (void)argument;
    for (void *item; (item = queue_pop(&forth));)
        queue_push(&back, item);
    queue_close(&back);
    return NULL;
}

/* A few items go round many times; each comes back in order, and the end is noticed. */
static void queues_keep_order(void **state)
{
    static int items[4];
    pthread_t thread;
    (void)state;
    queue_init(&forth);
    queue_init(&back);
    pthread_create(&thread, NULL, echo, NULL);
    for (int i = 0; i < 4; i++)
        queue_push(&forth, &items[i]);
    for (int i = 0; i < ITEMS; i++) {
        int *item = queue_pop(&back);
        assert_ptr_equal(item, &items[i % 4]);
        assert_int_equal((*item)++, i / 4);
        queue_push(&forth, item);
    }
    queue_close(&forth);
    for (int i = 0; i < 4; i++)
        assert_ptr_equal(queue_pop(&back), &items[i]);
    assert_null(queue_pop(&back));
    pthread_join(thread, NULL);
    queue_destroy(&forth);
    queue_destroy(&back);
}

/* A claim is exclusive, whoever else holds it and however it is spelt, and leaves nothing behind. */
static void claims_are_exclusive(void **state)
{
    char directory[] = "/tmp/claim-XXXXXX", path[64], other[64];
    struct output_claim first, second;
    struct error e;
    (void)state;
    assert_non_null(mkdtemp(directory));
    snprintf(path, sizeof path, "%s/film.mp4", directory);
    snprintf(other, sizeof other, "%s/./film.mp4", directory);
    for (int k = 0; k < 2; k++) {
        assert_int_equal(output_claim(&first, path, &e), STATUS_OK);
        assert_int_equal(output_claim(&second, other, &e), STATUS_OUTPUT);
        assert_non_null(strstr(e.text, "is being written already"));
        output_release(&second); /* of nothing: harmless */
        output_release(&first);
    }
    assert_int_equal(rmdir(directory), 0);
    assert_int_equal(output_claim(&first, path, &e), STATUS_OUTPUT);
    assert_int_equal(output_check(path, &e), STATUS_OUTPUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_are_aligned_and_zeroed),
        cmocka_unit_test(labels_are_summed),
        cmocka_unit_test(too_much_is_an_error),
        cmocka_unit_test(levels_choose_messages),
        cmocka_unit_test(colour_only_on_a_terminal),
        cmocka_unit_test(progress_only_on_a_terminal),
        cmocka_unit_test(queues_keep_order),
        cmocka_unit_test(claims_are_exclusive),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
