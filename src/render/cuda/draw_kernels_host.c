/* The cuda renderer's kernels on the host: one thread after the other, from the last to the first, as any
 * order must do. */
#include "render/cuda/draw_kernels.h"

static inline void draw_least(uint64_t *least, uint64_t key)
{
    *least = key < *least ? key : *least;
}
static inline int draw_lowest(uint32_t bits)
{
    return __builtin_ctz(bits);
}

#include "render/cuda/draw.h"

#define DRAW(name)                                                                                 \
    static void run_##name(size_t threads, const void *args, void *stream)                         \
    {                                                                                              \
        const struct draw_work *w = args;                                                          \
        (void)stream;                                                                              \
        for (size_t i = threads; i-- > 0;)                                                         \
            draw_##name(w, i);                                                                     \
    }
#include "render/cuda/draw_list.h"
#undef DRAW

#define DRAW(name) {"draw: " #name, sizeof(struct draw_work), run_##name},
const struct kernel draw_kernels_host[DRAW_COUNT] = {
#include "render/cuda/draw_list.h"
};
