/* The kernels of the cuda back end, made from the lists of bodies. */
#ifndef BACKEND_CUDA_KERNELS_H
#define BACKEND_CUDA_KERNELS_H

#include "backend/cuda/frame_work.h"
#include "backend/cuda/order_work.h"
#include "backend/stages.h"
#include "device/device.h"

/* Kernels in one numbering: stages, pair bodies, and what sorts and builds rows. */
enum kernel_id {
#define STAGE(kind, name, terms) KERNEL_stage_##name,
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) KERNEL_pair_##name,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags) KERNEL_pair_force_##flags, KERNEL_pair_force_walls_##flags,
#include "backend/bodies/force_list.h"
#undef FORCE
#define ORDER(name) KERNEL_order_##name,
#include "backend/cuda/order_list.h"
#undef ORDER
#define FRAME(name, type) KERNEL_frame_##name,
#include "backend/cuda/frame_list.h"
#undef FRAME
    KERNEL_COUNT
};

/* By enum kernel_id; those of stages and pair bodies take struct work, of sorting and rows struct order_work,
 * of frames what their list says. */
extern const struct kernel kernels_host[KERNEL_COUNT];
extern const struct kernel kernels_cuda[KERNEL_COUNT]; /* only with CUDA=1 */

/* Whether a GPU can run them, else why not. */
bool kernels_cuda_load(int device, const char **why);

#endif
