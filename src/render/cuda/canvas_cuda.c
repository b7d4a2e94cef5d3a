/* The renderer of machines with a GPU but without OpenGL on it, or little: spheres by CUDA kernels. */
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

/* GPUs of data centres from Hopper on draw by OpenGL with a small part of themselves: an H100 has 24 raster units, an
 * RTX 3070 has 96. */
static bool canvas_leads(const struct render_setup *setup)
{
    struct device_info info;
    struct error ignored;
    if (!setup->on_device || device_cuda.info(setup->device, &info, &ignored))
        return false;
    return info.compute == 90 || info.compute == 100 || info.compute == 103;
}

const struct canvas_row canvas_cuda = {
    .variant = {.name = NAME, .doc = DOC},
    .leads = canvas_leads,
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
