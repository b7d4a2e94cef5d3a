/* The loops around the implicit solver's pair bodies; part of pair_bodies.h. */

/* Sums over the row of LANES particles, two entries at a time; `body` adds entry `index` to them.
 */
#define ROW_LOOP(row, length, body)                                                                \
    do {                                                                                           \
        uint32_t row_k = 0;                                                                        \
        for (; row_k + 1 < (length); row_k += 2) {                                                 \
            const uint32_t *index = (row) + (size_t)row_k * PARTICLE_BLOCK;                        \
            body;                                                                                  \
            index += PARTICLE_BLOCK;                                                               \
            body;                                                                                  \
        }                                                                                          \
        if (row_k < (length)) {                                                                    \
            const uint32_t *index = (row) + (size_t)row_k * PARTICLE_BLOCK;                        \
            body;                                                                                  \
        }                                                                                          \
    } while (0)

/* Adds a row of particles or wall particles to the factors; entries beyond a count do not count. */
FORCE_INLINE void factor_row(const struct work *w, const struct lane_point *point,
                             const struct position *records, const uint32_t *row,
                             const uint32_t *count, bool wall, struct pair_factors *s,
                             const unsigned flags)
{
    const bool densities = !wall && w->inverse_density;
    real far = real_set(16), zero = real_set(0);
    real same = wall ? zero : real_set(1 / w->choice->each.rest_density[0]);
    uint32_t length = longest(count);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4];
        records_load(records, index, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, count, p.q, far);
        real inverse = densities ? lookup_load(w->inverse_density, index) : same;
        pair_factor(s, &p, other[3], inverse, flags);
    }
}

FORCE_INLINE void factor_store(const struct work *w, size_t i, const struct pair_factors *s)
{
    const struct solve_work *solve = &w->solve;
    float sum[5][LANES];
    real_store(sum[0], s->gx);
    real_store(sum[1], s->gy);
    real_store(sum[2], s->gz);
    real_store(sum[3], s->number);
    real_store(sum[4], s->squares);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        size_t k = i + l;
        int fluid = work_fluid(w, k);
        const struct position *x = &w->position[k];
        float gradient[3] = {sum[0][l], sum[1][l], sum[2][l]};
        implicit_factor(&w->choice->each, &w->choice->implicit, fluid, x, sum[3][l], gradient,
                        sum[4][l], &solve->factor[k], &solve->density[k]);
        solve->motion[k] = w->motion[k];
        solve->load[k] = *x;
    }
}

FORCE_INLINE void factor_sum(const struct work *w, size_t i, const unsigned flags)
{
    const size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
    real volume, zero = real_set(0);
    struct lane_point point = point_load(w, i, &volume);
    struct pair_factors s = {volume * real_set(w->constants.self), zero, zero, zero, zero};
    factor_row(w, &point, w->position, w->rows[block].index + lane, w->row_count + i, false, &s,
               flags);
    if (w->wall)
        factor_row(w, &point, w->wall, w->wall_rows[block].index + lane, w->wall_row_count + i,
                   true, &s, flags);
    factor_store(w, i, &s);
}

/* The trial velocity (or, in a shift, displacement / dt) of the particle at k; with `project` its
 * new velocity. */
FORCE_INLINE void push_store(const struct work *w, size_t k, const float sum[3], bool project)
{
    const struct solve_work *solve = &w->solve;
    int fluid = work_fluid(w, k);
    struct motion *motion = &solve->motion[k], *flux = &solve->flux[k];
    float a[3], volume = w->choice->implicit.volume[fluid];
    implicit_push(&w->choice->each, &w->choice->implicit, fluid, &solve->factor[k],
                  motion->pressure, sum, a);
    for (int d = 0; d < 3; d++) {
        float v = (w->solve_of == SOLVE_SHIFT ? 0 : motion->velocity[d]) + w->scalars->dt * a[d];
        if (project)
            motion->velocity[d] = v;
        else
            flux->velocity[d] = volume * solve->factor[k].along[d] * v;
    }
}

FORCE_INLINE void push_sum(const struct work *w, size_t i, bool project, const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    real volume, zero = real_set(0), sum[3] = {zero, zero, zero};
    struct lane_point point = point_load(w, i, &volume);
    ROW_LOOP(row, length, {
        real other[4];
        records_load(w->solve.load, index, other);
        struct pair p = pair_between(&point, other);
        pair_push(sum, &p, other[3], flags);
    });
    float out[3][LANES];
    for (int d = 0; d < 3; d++)
        real_store(out[d], sum[d]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float own[3] = {out[0][l], out[1][l], out[2][l]};
        push_store(w, i + l, own, project);
    }
}

/* Relaxes the pressure at k, and counts its error and its compression. */
FORCE_INLINE void sweep_store(const struct work *w, size_t k, float sum)
{
    const struct solve_work *solve = &w->solve;
    int fluid = work_fluid(w, k);
    float ratio = solve->factor[k].ratio;
    float base = implicit_base(&w->choice->implicit, w->solve_of, ratio, w->scalars->target), raw;
    float *pressure = &solve->motion[k].pressure, error;
    error = implicit_sweep(&w->choice->implicit, fluid, w->scalars->dt, base, w->scalars->offset,
                           &raw, &solve->factor[k], solve->flux[k].velocity, sum,
                           implicit_holds(&w->choice->implicit, w->solve_of, ratio),
                           w->scalars->relax, w->scalars->momentum, &solve->warm[k].last, pressure);
    solve->load[k].volume = w->choice->implicit.volume[fluid] * *pressure;
    residual_count(w, k, fixed_part(error), fixed_part(raw));
}

FORCE_INLINE void sweep_sum(const struct work *w, size_t i, const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    real volume, sum = real_set(0);
    struct lane_point point = point_load(w, i, &volume);
    ROW_LOOP(row, length, {
        real other[4];
        real flux[4];
        records_load(w->position, index, other);
        records_load(w->solve.flux, index, flux);
        struct pair p = pair_between(&point, other);
        pair_sweep(&sum, &p, flux, flags);
    });
    float out[LANES];
    real_store(out, sum);
    for (size_t l = 0; l < LANES && i + l < w->count; l++)
        sweep_store(w, i + l, out[l]);
}
#undef ROW_LOOP
