/* What tests ask of the model of a GPU. */
#ifndef GPU_MODEL_H
#define GPU_MODEL_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum gpu_model_order { GPU_MODEL_FORWARD, GPU_MODEL_BACKWARD, GPU_MODEL_SHUFFLED };

/* In which order blocks come, and threads of a block. */
void gpu_model_order(enum gpu_model_order order);

/* Since the start: kernels run, of these within graphs, and meetings of warps and of blocks. */
struct gpu_model_counts {
    long kernels, in_graphs, warps, blocks;
    size_t device_bytes; /* that are allocated now */
};
struct gpu_model_counts gpu_model_counts(void);

#ifdef __cplusplus
}
#endif

#endif
