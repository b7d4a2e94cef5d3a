/* The rows of a table of kernels, in the order of enum kernel_id. */
#define STAGE(kind, name, terms) {#name, sizeof(struct work), run_##name},
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) {#name, sizeof(struct work), run_pair_##name},
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags)                                                                               \
    {"force " #flags, sizeof(struct work), run_pair_force_##flags},                                \
        {"force with wall particles " #flags, sizeof(struct work), run_pair_force_walls_##flags},
#include "backend/bodies/force_list.h"
#undef FORCE
#define ORDER(name) {#name, sizeof(struct order_work), run_order_##name},
#include "backend/cuda/order_list.h"
#undef ORDER
#define FRAME(name, type) {"frame: " #name, sizeof(type), run_frame_##name},
#include "backend/cuda/frame_list.h"
#undef FRAME
