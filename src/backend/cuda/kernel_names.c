/* Names of kernels, for messages. */
#include "backend/cuda/device.h"

const char *kernel_name(enum kernel kernel)
{
    static const char *const names[KERNEL_COUNT] = {
#define STAGE(kind, name, terms) [KERNEL_stage_##name] = #name,
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) [KERNEL_pair_##name] = #name,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags)                                                                               \
    [KERNEL_pair_force_##flags] = "force " #flags,                                                 \
    [KERNEL_pair_force_walls_##flags] = "force with wall particles " #flags,
#include "backend/bodies/force_list.h"
#undef FORCE
#define ORDER(name) [KERNEL_order_##name] = #name,
#include "backend/cuda/order_list.h"
#undef ORDER
    };
    return kernel < KERNEL_COUNT ? names[kernel] : "none";
}
