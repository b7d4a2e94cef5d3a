/* Devices: events between the queues of two threads, and buffers of OpenGL that a device writes to. On the
 * host, and on a GPU where there is one. */
#include "base/memory.h"
#include "device/device.h"
#include "render/context.h"
#include "render/shared_buffer.h"

#include <pthread.h>
#include <semaphore.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { WORDS = 1 << 14, ROUNDS = 60, WRITES = 3 };

static const struct device_row *const devices[] = {
    &device_host,
#if HAVE_CUDA
    &device_cuda,
#endif
};
enum { DEVICES = sizeof devices / sizeof *devices };

static const char *name_of(const struct device_row *row)
{
    return row == &device_host ? "host" : "cuda";
}

/* Device 0 of the kind; NULL where there is none. */
static struct device *device_of(const struct device_row *row)
{
    struct error e = {.text = ""};
    struct device *device = NULL;
    const char *why = "";
    if (row->count(&why) < 1)
        printf("# SKIP %s: %s\n", name_of(row), why);
    else if (row->open(&device, 0, &e))
        fail_msg("%s", e.text);
    return device;
}

static uint32_t word_of(size_t round, size_t k)
{
    return (uint32_t)(round * 2654435761U + k * 40503U + 1);
}

/* One thread fills a block of the device again and again, another reads it. */
struct relay {
    const struct device_row *row;
    struct device *writer, *reader;
    struct device_event *full, *empty;
    uint32_t *block, *host; /* on the device; of all rounds, pinned */
    sem_t filled, emptied;
};

static void *relay_write(void *context)
{
    struct relay *r = context;
    struct error e = {.text = ""};
    for (size_t round = 0; round < ROUNDS; round++) {
        sem_wait(&r->emptied);
        r->row->follow(r->writer, r->empty); /* at first it never was */
        r->row->upload(r->writer, r->block, r->host + round * WORDS, WORDS * sizeof *r->host);
        if (r->row->signal(r->writer, r->full, &e))
            printf("# %s\n", e.text);
        sem_post(&r->filled);
    }
    return NULL;
}

static size_t relay_read(struct relay *r)
{
    static uint32_t got[WORDS];
    struct error e = {.text = ""};
    size_t wrong = 0;
    for (size_t round = 0; round < ROUNDS; round++) {
        sem_wait(&r->filled);
        r->row->follow(r->reader, r->full);
        wrong += r->row->read(r->reader, got, r->block, sizeof got, &e) != STATUS_OK;
        wrong += r->row->signal(r->reader, r->empty, &e) != STATUS_OK;
        sem_post(&r->emptied);
        for (size_t k = 0; k < WORDS; k++)
            wrong += got[k] != word_of(round, k);
    }
    return wrong;
}

static bool relay_make(struct relay *r)
{
    struct error e = {.text = ""};
    r->writer = device_of(r->row);
    r->reader = r->writer ? device_of(r->row) : NULL;
    if (!r->reader)
        return false;
    r->full = r->row->event(r->writer, &e);
    r->empty = r->row->event(r->writer, &e);
    r->block = r->row->create(r->writer, "a block", WORDS * sizeof *r->block, &e);
    r->host = r->row->pin(r->writer, (size_t)ROUNDS * WORDS * sizeof *r->host, &e);
    if (!r->full || !r->empty || !r->block || !r->host)
        fail_msg("%s", e.text);
    for (size_t k = 0; k < (size_t)ROUNDS * WORDS; k++)
        r->host[k] = word_of(k / WORDS, k % WORDS);
    sem_init(&r->filled, 0, 0);
    sem_init(&r->emptied, 0, 1);
    return true;
}

static void relay_end(struct relay *r)
{
    struct error e = {.text = ""};
    assert_int_equal(r->row->wait(r->writer, &e), STATUS_OK);
    assert_int_equal(r->row->wait(r->reader, &e), STATUS_OK);
    r->row->drop(r->writer, r->full);
    r->row->drop(r->writer, r->empty);
    r->row->destroy(r->writer, r->block);
    r->row->unpin(r->writer, r->host);
    r->row->close(r->reader);
    r->row->close(r->writer);
    sem_destroy(&r->filled);
    sem_destroy(&r->emptied);
}

static void queues_wait_for_each_other(void **state)
{
    (void)state;
    for (size_t n = 0; n < DEVICES; n++) {
        struct relay relay = {.row = devices[n]};
        size_t before = memory_now();
        pthread_t thread;
        if (!relay_make(&relay))
            continue;
        assert_int_equal(pthread_create(&thread, NULL, relay_write, &relay), 0);
        size_t wrong = relay_read(&relay);
        pthread_join(thread, NULL);
        relay_end(&relay);
        assert_int_equal(wrong, 0);
        assert_int_equal(memory_now(), before);
    }
}

/* A recording with an event is none, and one without follows as if nothing had been. */
static void events_are_not_recorded(void **state)
{
    (void)state;
    for (size_t n = 0; n < DEVICES; n++) {
        const struct device_row *row = devices[n];
        struct error e = {.text = ""};
        struct device *d = device_of(row);
        if (!d)
            continue;
        struct device_event *event = row->event(d, &e);
        uint32_t *block = row->create(d, "a block", sizeof *block, &e), word = 0;
        if (!event || !block)
            fail_msg("%s", e.text);
        for (int follows = 0; follows < 2; follows++) {
            assert_true(row->record(d));
            if (follows)
                row->follow(d, event);
            else
                row->signal(d, event, &e);
            assert_null(row->recorded(d));
        }
        assert_int_equal(row->signal(d, event, &e), STATUS_OK);
        assert_true(row->record(d));
        row->clear(d, block, sizeof *block);
        struct device_graph *graph = row->recorded(d);
        assert_non_null(graph);
        row->replay(d, graph);
        assert_int_equal(row->read(d, &word, block, sizeof word, &e), STATUS_OK);
        row->forget(d, graph);
        row->destroy(d, block);
        row->drop(d, event);
        row->close(d);
    }
}

static void *no_map(void *context, unsigned name, size_t bytes)
{
    (void)name;
    (void)bytes;
    return context;
}

static bool no_unmap(void *context, unsigned name)
{
    (void)context;
    (void)name;
    return false;
}

static void host_says_what_fails(void **state)
{
    const struct device_row *row = &device_host;
    struct error e = {.text = ""};
    struct device_gl gl = {.name = 7, .bytes = 12};
    struct device *d = device_of(row);
    size_t before = memory_now();
    uint32_t block;
    (void)state;
    assert_null(row->attach(d, &gl, &e));
    assert_int_equal(e.status, STATUS_BACKEND);
    assert_non_null(strstr(e.text, "buffer 7 of OpenGL cannot be written to by the host"));
    gl.map = no_map;
    gl.unmap = no_unmap;
    struct device_buffer *none = row->attach(d, &gl, &e);
    assert_null(row->map(d, none, &e));
    assert_int_equal(e.status, STATUS_RUN);
    assert_non_null(strstr(e.text, "does not give its buffer 7 of 12 bytes"));
    gl.context = &block;
    struct device_buffer *lost = row->attach(d, &gl, &e);
    assert_ptr_equal(row->map(d, lost, &e), &block);
    assert_int_equal(row->unmap(d, lost, &e), STATUS_RUN);
    assert_non_null(strstr(e.text, "lost the contents of its buffer 7"));
    assert_true(row->record(d));
    assert_null(row->map(d, lost, &e));
    assert_non_null(strstr(e.text, "within a recording"));
    row->forget(d, row->recorded(d));
    row->detach(d, none);
    row->detach(d, lost);
    row->close(d);
    assert_int_equal(memory_now(), before);
}

/* An OpenGL context that is current, and a buffer that is bound for drawing. */
struct room {
    const struct gl_context_row *row;
    void *context;
    struct gl gl;
    GLuint buffer;
    void (*read)(GLenum target, GLintptr offset, GLsizeiptr size, void *data);
};

static bool room_make(struct room *room, const char *missing, int cuda)
{
    struct error e = {.text = ""};
    if (missing || room->row->open(&room->context, cuda, &e)) {
        printf("# SKIP %s: %s\n", room->row->name, missing ? missing : e.text);
        return false;
    }
    if (room->row->bind(room->context, &e) || gl_load(&room->gl, room->row->getproc, room->context, &e))
        fail_msg("%s", e.text);
    void *read = room->row->getproc(room->context, "glGetBufferSubData");
    memcpy(&room->read, &read, sizeof read);
    assert_non_null(read);
    room->gl.GenBuffers(1, &room->buffer);
    room->gl.BindBuffer(GL_ARRAY_BUFFER, room->buffer);
    room->gl.BufferData(GL_ARRAY_BUFFER, WORDS * sizeof(uint32_t), NULL, GL_STREAM_DRAW);
    return true;
}

static void room_end(struct room *room)
{
    room->gl.DeleteBuffers(1, &room->buffer);
    room->row->unbind(room->context);
    room->row->close(room->context);
}

/* How many words OpenGL finds wrong, which the device wrote. */
static size_t write_words(struct room *room, const struct device_row *row, struct device *d,
                          struct device_buffer *buffer, uint32_t *words, size_t round)
{
    static uint32_t got[WORDS];
    struct error e = {.text = ""};
    size_t wrong = 0;
    for (size_t k = 0; k < WORDS; k++)
        words[k] = word_of(round, k);
    void *block = row->map(d, buffer, &e);
    if (!block)
        fail_msg("%s", e.text);
    row->upload(d, block, words, sizeof got);
    if (row->unmap(d, buffer, &e))
        fail_msg("%s", e.text);
    room->read(GL_ARRAY_BUFFER, 0, sizeof got, got);
    for (size_t k = 0; k < WORDS; k++)
        wrong += got[k] != word_of(round, k);
    return wrong;
}

static void share(struct room *room, const struct device_row *row, struct device *d)
{
    struct error e = {.text = ""};
    const struct device_gl gl = shared_buffer_of(&room->gl, room->buffer, WORDS * sizeof(uint32_t));
    struct device_buffer *buffer = row->attach(d, &gl, &e);
    uint32_t *words = row->pin(d, WORDS * sizeof *words, &e);
    if (!buffer || !words)
        fail_msg("%s", e.text);
    for (size_t round = 0; round < WRITES; round++) {
        assert_int_equal(write_words(room, row, d, buffer, words, round), 0);
        if (row->wait(d, &e) || gl_check(&room->gl, "while sharing a buffer", &e))
            fail_msg("%s", e.text);
    }
    printf("# %s writes to %s\n", name_of(row), (const char *)room->gl.GetString(GL_RENDERER));
    row->unpin(d, words);
    row->detach(d, buffer);
}

static void opengl_reads_what_the_host_writes(void **state)
{
    struct room rooms[] = {{.row = &context_egl}, {.row = &context_osmesa}};
    static const char *const missing[] = {EGL_MISSING, OSMESA_MISSING};
    (void)state;
    for (size_t n = 0; n < sizeof rooms / sizeof *rooms; n++) {
        struct device *d = device_of(&device_host);
        if (room_make(&rooms[n], missing[n], -1)) {
            share(&rooms[n], &device_host, d);
            room_end(&rooms[n]);
        }
        device_host.close(d);
    }
}

/* A buffer that OpenGL does not have cannot be mapped, and is an error of OpenGL, too. */
static void mapping_what_is_not_there(void **state)
{
    struct room room = {.row = &context_egl};
    struct error e = {.text = ""};
    (void)state;
    if (!room_make(&room, EGL_MISSING, -1))
        return;
    const struct device_gl gl = shared_buffer_of(&room.gl, room.buffer, 2 * WORDS * sizeof(uint32_t));
    struct device *d = device_of(&device_host);
    struct device_buffer *buffer = device_host.attach(d, &gl, &e);
    assert_null(device_host.map(d, buffer, &e));
    assert_int_equal(e.status, STATUS_RUN);
    assert_int_equal(gl_check(&room.gl, "while mapping", &e), STATUS_BACKEND);
    device_host.detach(d, buffer);
    device_host.close(d);
    room_end(&room);
}

static void opengl_reads_what_the_gpu_writes(void **state)
{
    (void)state;
#if HAVE_CUDA
    struct room room = {.row = &context_egl};
    struct device *d = device_of(&device_cuda);
    if (d && room_make(&room, EGL_MISSING, 0)) {
        if (room.row->cuda(room.context) == 0)
            share(&room, &device_cuda, d);
        else
            printf("# SKIP cuda: OpenGL draws elsewhere, by %s\n",
                   (const char *)room.gl.GetString(GL_RENDERER));
        room_end(&room);
    }
    if (d)
        device_cuda.close(d);
#else
    printf("# SKIP cuda: not in this build\n");
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(queues_wait_for_each_other),
        cmocka_unit_test(events_are_not_recorded),
        cmocka_unit_test(host_says_what_fails),
        cmocka_unit_test(opengl_reads_what_the_host_writes),
        cmocka_unit_test(mapping_what_is_not_there),
        cmocka_unit_test(opengl_reads_what_the_gpu_writes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
