/* The renderer of machines with a GPU but without OpenGL on it: spheres by CUDA kernels. */
#include "render/cuda/canvas_device.h"

#define NAME "cuda"
#define DOC "spheres by a GPU, without OpenGL; the same bits as cpu"

#if HAVE_CUDA
#include "render/cuda/draw_kernels.h"

static enum status canvas_open(void **canvas, const struct canvas_row *row,
                               const struct render_setup *setup, struct error *e)
{
    (void)row;
    return canvas_device_open(canvas, &device_cuda, draw_kernels_cuda, setup, e);
}

static bool canvas_software(const void *canvas)
{
    (void)canvas;
    return false;
}

const struct canvas_row canvas_cuda = {
    .variant = {.name = NAME, .doc = DOC},
    .open = canvas_open,
    .share = canvas_device_share,
    .draw = canvas_device_draw,
    .name = canvas_device_name,
    .software = canvas_software,
    .close = canvas_device_close,
};
#else
const struct canvas_row canvas_cuda = {
    .variant = {.name = NAME, .doc = DOC, .missing = "build with make CUDA=1 (the CUDA toolkit, for nvcc)"},
};
#endif
