/* What the files of the model of a GPU share. */
#ifndef GPU_MODEL_MODEL_H
#define GPU_MODEL_MODEL_H

#include "cuda_runtime.h"
#include "gpu_model.h"

#include <mutex>

extern std::recursive_mutex model_mutex; /* the whole GPU's: one thread of the host uses it at a time */
#define MODEL_LOCK std::lock_guard<std::recursive_mutex> lock(model_mutex)

extern struct gpu_model_counts model_counts;
extern bool model_in_graph; /* kernels that run are nodes of a graph */

/* Keeps an error for cudaGetLastError, and returns it. */
cudaError_t model_failed(cudaError_t error);

/* The GPU is lost with its kernel number GPU_MODEL_LOST: nothing runs any more, and every call fails. */
extern bool model_lost;
void model_lose();
cudaError_t model_state();

/* Runs all that streams have put off. */
void model_synchronize();

#endif
