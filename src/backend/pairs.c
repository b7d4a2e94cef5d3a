/* Chooses the body of a pair pass. */
#include "backend/pairs.h"

enum { MIXED_LOOKUP = PAIR_FLAGS_END };

static const struct {
    enum pair_body body;       /* the first: Wendland's kernel, fluids alike */
    unsigned by_kernel : 1; /* another for the cubic spline */
    unsigned others;        /* others with these flags; MIXED_LOOKUP where work has inverse densities */
} table[PAIR_PASS_COUNT] = {
    [PAIR_PASS_DENSITY] = {BODY_density_wendland, 1, 0},
    [PAIR_PASS_FORCE] = {BODY_COUNT, 0, 0},
    [PAIR_PASS_GRADIENT] = {BODY_gradient_wendland, 1, PAIR_MIXED},
    [PAIR_PASS_DIFFUSION] = {BODY_diffusion_wendland, 1, PAIR_MIXED},
    [PAIR_PASS_SHIFT] = {BODY_shift_wendland, 1, 0},
    [PAIR_PASS_NORMALS] = {BODY_normals, 0, 0},
    [PAIR_PASS_TENSION] = {BODY_tension, 0, 0},
    [PAIR_PASS_FACTOR] = {BODY_factor_wendland, 1, 0},
    [PAIR_PASS_PUSH] = {BODY_push_wendland, 1, 0},
    [PAIR_PASS_PROJECT] = {BODY_project_wendland, 1, 0},
    [PAIR_PASS_SWEEP] = {BODY_sweep_wendland, 1, 0},
    [PAIR_PASS_DRAG_DIAGONAL] = {BODY_drag_diagonal_wendland, 1, PAIR_CENTRAL},
    [PAIR_PASS_DRAG] = {BODY_drag_wendland, 1, PAIR_CENTRAL},
    [PAIR_PASS_STENCIL] = {BODY_stencil_wendland, 1, MIXED_LOOKUP},
    [PAIR_PASS_SURFACE] = {BODY_surface, 0, 0},
    [PAIR_PASS_JUMP] = {BODY_jump, 0, 0},
    [PAIR_PASS_FLOW] = {BODY_flow, 0, MIXED_LOOKUP},
    [PAIR_PASS_PRODUCT] = {BODY_product, 0, 0},
    [PAIR_PASS_SLOPES] = {BODY_slopes, 0, 0},
    [PAIR_PASS_CURL] = {BODY_curl, 0, 0},
};

static enum pair_body force_find(unsigned flags, bool walls)
{
    switch (flags) {
#define FORCE(f)                                                                                   \
    case f: return walls ? BODY_force_walls_##f : BODY_force_##f;
#include "backend/bodies/force_list.h"
#undef FORCE
    default: return BODY_COUNT;
    }
}

enum pair_body pair_find(enum pair_pass pass, const struct work *work, unsigned flags)
{
    unsigned cubic = flags & KERNEL_CUBIC ? 1 : 0, kernels = table[pass].by_kernel ? 2 : 1;
    unsigned has = flags | (work->inverse_density ? MIXED_LOOKUP : 0);
    bool other = has & table[pass].others;
    if (pass == PAIR_PASS_FORCE)
        return force_find(flags, work->wall != NULL);
    if (pass == PAIR_PASS_DENSITY && flags & PAIR_MULLER)
        return BODY_density_muller;
    return table[pass].body + (other ? kernels : 0) + (kernels == 2 ? cubic : 0);
}
