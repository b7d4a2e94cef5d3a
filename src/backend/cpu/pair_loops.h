/* The loops around the pair bodies, included once per instruction set after its lanes_*.h.
 *
 * Lane = particle: each lane adds its own neighbours one at a time, in the order of its row, so the
 * sum does not depend on how many lanes there are. */
#include "backend/cpu/isa.h"

#include "solver/pair_shift.h"

#include <math.h>

/* The flags are constants only in an inlined copy. */
#define FORCE_INLINE static inline __attribute__((always_inline))

/* 1/sqrt(x) to the last bit or two, in plain arithmetic, hence the same bits on every target and
 * several times faster than square root and division: the bit guess, one cubic (Halley-like) and
 * one Newton step. Finite at x = 0. */
FORCE_INLINE real real_rsqrt(real x)
{
    real y = real_rsqrt_guess(x);
    real e = (x * y) * y;
    y = y * real_fma(e, real_fma(e, real_set(0.375f), real_set(-1.25f)), real_set(1.875f));
    e = (x * y) * y;
    return y * real_fma(e, real_set(-0.5f), real_set(1.5f));
}

struct lane_point {
    real x, y, z; /* fixed-point bits */
    real sx, sy, sz;
};

FORCE_INLINE struct pair pair_between(const struct lane_point *i, const real other[4])
{
    struct pair p;
    p.x = real_difference(i->x, other[0]) * i->sx;
    p.y = real_difference(i->y, other[1]) * i->sy;
    p.z = real_difference(i->z, other[2]) * i->sz;
    p.q2 = real_fma(p.z, p.z, real_fma(p.y, p.y, p.x * p.x));
    p.inverse = real_rsqrt(p.q2);
    p.q = p.q2 * p.inverse;
    return p;
}

/* Row entries of consecutive particles. */
static const uint32_t lane_ramp[PARTICLE_BLOCK] = {0,  2,  4,  6,  8,  10, 12, 14,
                                                   16, 18, 20, 22, 24, 26, 28, 30};

static inline uint32_t longest(const uint32_t *count)
{
    uint32_t most = 0;
    for (int l = 0; l < LANES; l++)
        most = count[l] > most ? count[l] : most;
    return most;
}

FORCE_INLINE struct lane_point point_load(const struct pair_work *w, size_t first, real *volume)
{
    real record[4];
    const float *scale = w->constants.scale;
    records_load(w->position + first, lane_ramp, record);
    *volume = record[3];
    return (struct lane_point){record[0],          record[1],          record[2],
                               real_set(scale[0]), real_set(scale[1]), real_set(scale[2])};
}

/* Sum of w over row entries below the count of each lane: padded entries must not count. With
 * `weighted` each entry counts by its volume. */
FORCE_INLINE real density_row(const struct lane_point *point, const struct position *records,
                              const uint32_t *row, const uint32_t *count, bool weighted, real sum,
                              const unsigned flags)
{
    uint32_t length = longest(count);
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(records, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q2 = real_below(k, count, p.q2, far);
        p.q = real_below(k, count, p.q, far);
        pair_density(&sum, &p, weighted ? other[3] : real_set(1), flags);
    }
    return sum;
}

/* Density by summation: number[i] = w(0) + sum_j w(q_ij) + sum_b V_b w(q_ib). */
FORCE_INLINE void density_blocks(const struct pair_work *w, size_t first_block, size_t last_block,
                                 const unsigned flags)
{
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        const size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
        real volume;
        struct lane_point point = point_load(w, i, &volume);
        real sum = density_row(&point, w->position, w->rows[block].index + lane, w->row_count + i,
                               false, real_set(w->constants.self), flags);
        if (w->wall)
            sum = density_row(&point, w->wall, w->wall_rows[block].index + lane,
                              w->wall_row_count + i, true, sum, flags);
        real_store(w->number + i, sum);
    }
}

struct lane_particle {
    struct lane_point point;
    struct pair_state state;
    struct pair_lane_constants constants;
    struct pair_sums sums;
};

/* What i's pressure counts in its sums: p_i + p_j, and deep in shifting fluid p_j - p_i. */
FORCE_INLINE void pressure_load(const struct pair_work *w, size_t i, struct pair_state *state)
{
    state->own = state->pressure;
    state->wall = real_positive(state->pressure);
    if (!w->shift)
        return;
    real shift[4], one = real_set(1);
    records_load(w->shift + i, lane_ramp, shift);
    state->own = (one - real_set(2) * shift[3]) * state->pressure;
    state->wall = (one - shift[3]) * (state->pressure + state->wall) - state->own;
}

FORCE_INLINE struct lane_particle particle_load(const struct pair_work *w, size_t i,
                                                 const unsigned flags)
{
    struct lane_particle p;
    real motion[4];
    float rest[LANES], inverse[LANES];
    const float *head = w->constants.head;
    p.point = point_load(w, i, &p.state.volume);
    records_load(w->motion + i, lane_ramp, motion);
    p.state.vx = motion[0], p.state.vy = motion[1], p.state.vz = motion[2];
    p.state.pressure = motion[3];
    pressure_load(w, i, &p.state);
    p.state.viscosity = flags & PAIR_OWN_VISCOSITY ? real_load(w->viscosity + i) : real_set(0);
    for (int l = 0; l < LANES; l++) {
        rest[l] = w->rest_density[w->fluid ? w->fluid[i + (size_t)l] : 0];
        inverse[l] = flags & PAIR_SYMMETRIC ? 1 / w->position[i + (size_t)l].volume : 0;
    }
    real rho0 = real_load(rest), zero = real_set(0);
    p.state.inverse_volume = real_load(inverse);
    p.state.rest = rho0;
    p.constants = (struct pair_lane_constants){
        real_set(w->constants.viscosity), real_set(w->constants.inverse_h),
        real_set(w->constants.central),   real_set(w->constants.artificial), rho0 * real_set(head[0]),
        rho0 * real_set(head[1]),         rho0 * real_set(head[2])};
    p.sums = (struct pair_sums){{zero, zero, zero}, zero, zero};
    return p;
}

struct lane_neighbour {
    struct pair_state state;
    struct pair pair;
};

FORCE_INLINE struct lane_neighbour neighbour_load(const struct pair_work *w,
                                                  const struct lane_particle *self,
                                                  const uint32_t *index, const unsigned flags)
{
    struct lane_neighbour n;
    real other[4], motion[4];
    records_load(w->position, index, other);
    records_load(w->motion, index, motion);
    n.pair = pair_between(&self->point, other);
    n.state = (struct pair_state){.volume = other[3], .vx = motion[0], .vy = motion[1],
                                  .vz = motion[2], .pressure = motion[3]};
    n.state.viscosity = flags & PAIR_OWN_VISCOSITY ? lookup_load(w->viscosity, index)
                                                   : real_set(0);
    n.state.rest = flags & PAIR_MIXED ? lookup_load(w->rest, index) : real_set(0);
    return n;
}

/* A sum of rounding errors only; kept, its products would be denormal, and slow. */
static inline float settled(float sum)
{
    return fabsf(sum) < 1e-20f ? 0 : sum;
}

/* dv/dt = g + gradient/rho_i sums; drho/dt = gradient (rho_i divergence + diffusion). */
static inline void rate_store(const struct pair_work *w, size_t i, const struct pair_sums *s)
{
    const struct pair_constants *c = &w->constants;
    float sum[5][LANES];
    for (int a = 0; a < 3; a++)
        real_store(sum[a], s->a[a]);
    real_store(sum[3], s->divergence);
    real_store(sum[4], s->diffusion);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        struct rate *rate = &w->rate[i + l];
        int fluid = w->fluid ? w->fluid[i + l] : 0;
        float rest = w->rest_density[fluid];
        float diffusion = w->softness ? c->diffusion * w->softness[fluid] : c->diffusion;
        float density = w->density ? w->density[i + l] : rest, front = c->gradient / density;
        for (int a = 0; a < 3; a++)
            rate->acceleration[a] = c->gravity[a] + front * settled(sum[a][l]);
        rate->density = c->gradient * (density * settled(sum[3][l]) + diffusion * settled(sum[4][l]));
    }
}

FORCE_INLINE void force_blocks(const struct pair_work *w, size_t first_block, size_t last_block,
                                const unsigned flags, const bool walls)
{
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
        uint32_t length = longest(w->row_count + i);
        struct lane_particle self = particle_load(w, i, flags);
        uint32_t k = 0;
        for (; k + 1 < length; k += 2) {
            const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
            struct lane_neighbour a = neighbour_load(w, &self, index, flags);
            struct lane_neighbour b = neighbour_load(w, &self, index + PARTICLE_BLOCK, flags);
            pair_force(&self.sums, &self.state, &a.state, &a.pair, &self.constants, flags);
            pair_force(&self.sums, &self.state, &b.state, &b.pair, &self.constants, flags);
        }
        if (k < length) {
            const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
            struct lane_neighbour a = neighbour_load(w, &self, index, flags);
            pair_force(&self.sums, &self.state, &a.state, &a.pair, &self.constants, flags);
        }
        if (walls) {
            row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
            length = longest(w->wall_row_count + i);
            for (k = 0; k < length; k++) {
                real other[4], far = real_set(16);
                records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
                struct pair p = pair_between(&self.point, other);
                p.q = real_below(k, w->wall_row_count + i, p.q, far);
                pair_wall(&self.sums, &self.state, other[3], &p, &self.constants, flags);
            }
        }
        rate_store(w, i, &self.sums);
    }
}

/* One function per combination that a solver can ask for: kernel, viscosity, artificial viscosity,
 * density, pressure form; with and without wall particles. The flags are constants inside. */
#define FORCE(flags)                                                                               \
    static void force_##flags(const struct pair_work *w, size_t first, size_t last)                \
    {                                                                                              \
        force_blocks(w, first, last, flags, false);                                                \
    }                                                                                              \
    static void force_walls_##flags(const struct pair_work *w, size_t first, size_t last)          \
    {                                                                                              \
        force_blocks(w, first, last, flags, true);                                                 \
    }
#include "backend/cpu/pair_combinations.h"
#undef FORCE

#define FORCE(flags) [flags] = force_##flags,
static pair_function *const force_table[PAIR_FLAGS_END] = {
#include "backend/cpu/pair_combinations.h"
};
#undef FORCE

#define FORCE(flags) [flags] = force_walls_##flags,
static pair_function *const force_walls_table[PAIR_FLAGS_END] = {
#include "backend/cpu/pair_combinations.h"
};
#undef FORCE

static void density_wendland(const struct pair_work *w, size_t first, size_t last)
{
    density_blocks(w, first, last, 0);
}
static void density_cubic(const struct pair_work *w, size_t first, size_t last)
{
    density_blocks(w, first, last, KERNEL_CUBIC);
}
static void density_muller(const struct pair_work *w, size_t first, size_t last)
{
    density_blocks(w, first, last, PAIR_MULLER);
}

#include "backend/cpu/diffusion_loops.h"
#include "backend/cpu/curl_loops.h"
#include "backend/cpu/solve_loops.h"
#include "backend/cpu/drag_loops.h"
#include "backend/cpu/shift_loops.h"
#include "backend/cpu/tension_loops.h"
#include "backend/cpu/projection_loops.h"

static pair_function *loops_find(enum pair_pass pass, unsigned flags, bool walls)
{
    bool cubic = flags & KERNEL_CUBIC;
    switch (pass) {
    case PAIR_PASS_DENSITY:
        return flags & PAIR_MULLER ? density_muller : cubic ? density_cubic : density_wendland;
    case PAIR_PASS_NORMALS: return normals_blocks;
    case PAIR_PASS_TENSION: return tension_blocks;
    case PAIR_PASS_FACTOR: return cubic ? factor_cubic : factor_wendland;
    case PAIR_PASS_PUSH: return cubic ? push_cubic : push_wendland;
    case PAIR_PASS_PROJECT: return cubic ? project_cubic : project_wendland;
    case PAIR_PASS_SWEEP: return cubic ? sweep_cubic : sweep_wendland;
    case PAIR_PASS_DRAG_DIAGONAL:
    case PAIR_PASS_DRAG: return drag_find(pass == PAIR_PASS_DRAG_DIAGONAL, flags);
    case PAIR_PASS_GRADIENT:
    case PAIR_PASS_DIFFUSION: return diffusion_find(pass, flags);
    case PAIR_PASS_SHIFT: return cubic ? shift_cubic : shift_wendland;
    case PAIR_PASS_STENCIL: return cubic ? stencil_cubic : stencil_wendland;
    case PAIR_PASS_SURFACE: return surface_blocks;
    case PAIR_PASS_JUMP: return jump_blocks;
    case PAIR_PASS_FLOW: return flow_blocks;
    case PAIR_PASS_PRODUCT: return product_blocks;
    case PAIR_PASS_SLOPES: return slopes_blocks;
    case PAIR_PASS_CURL: return curl_blocks;
    case PAIR_PASS_FORCE: break;
    }
    return walls ? force_walls_table[flags] : force_table[flags];
}

/* Candidates of the cell that the last particle was in; the next one is often in it too. */
struct candidates {
    struct range range[RANGES_MAX];
    int ranges;
    size_t sum;
    uint32_t cell;
};

static void candidates_find(const struct row_build *b, const uint32_t point[3],
                            struct candidates *c)
{
    uint32_t cell = cells_index(b->cells, point);
    if (cell == c->cell)
        return;
    c->cell = cell;
    c->ranges = b->search->ranges(b->cells, point, b->candidate_count, c->range);
    c->sum = 0;
    for (int r = 0; r < c->ranges; r++)
        c->sum += c->range[r].last - c->range[r].first;
}

static size_t loops_build(const struct row_build *b, size_t block, struct row_scratch *scratch)
{
    struct candidates near = {.cell = UINT32_MAX};
    struct row_build work = *b; /* a copy that no store can alias */
    const float limit[2] = {b->limit, b->coincident};
    bool coincident = false;
    for (size_t l = 0; l < PARTICLE_BLOCK; l++) {
        size_t i = block * PARTICLE_BLOCK + l;
        uint32_t *list = scratch->list + l * scratch->room, *end = list;
        scratch->count[l] = 0;
        if (i >= work.point_count)
            continue;
        const uint32_t *point = work.points[i].count;
        candidates_find(&work, point, &near);
        if (near.sum + PARTICLE_BLOCK > scratch->room)
            return near.sum + PARTICLE_BLOCK;
        for (int r = 0; r < near.ranges; r++)
            end = rows_append(end, work.axis, point, work.scale, limit, near.range[r].first,
                              near.range[r].last, work.same ? (uint32_t)i : UINT32_MAX,
                              &coincident);
        scratch->count[l] = (uint32_t)(end - list);
    }
    scratch->coincident |= coincident;
    return 0;
}

/* Four lists at a time, four entries at a time. */
static void loops_interleave(const struct row_scratch *scratch, uint32_t length, uint32_t *rows)
{
    for (size_t l = 0; l < PARTICLE_BLOCK; l += 4) {
        const uint32_t *list = scratch->list + l * scratch->room;
        for (uint32_t k = 0; k < length; k += 4)
            rows_transpose(list + k, scratch->room, rows + (size_t)k * PARTICLE_BLOCK + l);
    }
}

/* Ten independent chains: enough to cover the latency of two FMA units. */
static double loops_peak(long rounds, float *sink)
{
    real a = real_set(0.999f), b = real_set(1e-3f);
    real c0 = a, c1 = b, c2 = a, c3 = b, c4 = a, c5 = b, c6 = a, c7 = b, c8 = a, c9 = b;
    float out[LANES];
    for (long r = 0; r < rounds; r++) {
        c0 = real_fma(c0, a, b), c1 = real_fma(c1, a, b), c2 = real_fma(c2, a, b);
        c3 = real_fma(c3, a, b), c4 = real_fma(c4, a, b), c5 = real_fma(c5, a, b);
        c6 = real_fma(c6, a, b), c7 = real_fma(c7, a, b), c8 = real_fma(c8, a, b);
        c9 = real_fma(c9, a, b);
    }
    real_store(out, ((c0 + c1) + (c2 + c3)) + ((c4 + c5) + (c6 + c7)) + (c8 + c9));
    *sink = out[0];
    return 20.0 * LANES * (double)rounds;
}
