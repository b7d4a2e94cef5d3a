/* The loops around implicit viscosity's pair body; part of pair_bodies.h. */

/* Entries that repeat the particle itself, or lie beyond the support, add nothing to the sums; with
 * `diagonal`, the weights count too, and entries beyond a count must not. */
FORCE_INLINE void drag_row(const struct work *w, const struct lane_point *point,
                           const real self[4], const uint32_t *row, const uint32_t *count,
                           bool diagonal, struct pair_drags *s, const unsigned flags)
{
    uint32_t length = longest(count);
    real far = real_set(16);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4], search[4];
        records_load(w->position, index, other);
        records_load(w->solve.search, index, search);
        struct pair p = pair_between(point, other);
        if (diagonal)
            p.q = real_below(k, count, p.q, far);
        pair_drag(s, &p, other[3], self, search, real_set(w->constants.central), diagonal, flags);
    }
}

/* Wall particles stand still and drag with i's viscosity, as in the force pass. */
FORCE_INLINE void drag_wall_row(const struct work *w, const struct lane_point *point,
                                const real self[4], const uint32_t *row, const uint32_t *count,
                                bool diagonal, struct pair_drags *s, const unsigned flags)
{
    uint32_t length = longest(count);
    real far = real_set(16), zero = real_set(0), wall[4] = {zero, zero, zero, self[3]};
    for (uint32_t k = 0; k < length; k++) {
        real other[4];
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, count, p.q, far);
        pair_drag(s, &p, other[3], self, wall, real_set(w->constants.central), diagonal, flags);
    }
}

FORCE_INLINE void drag_store(const struct work *w, size_t i, const struct pair_drags *s,
                             bool diagonal)
{
    const struct solve_work *solve = &w->solve;
    const struct pair_constants *c = &w->constants;
    float sum[3][LANES], weight[6][LANES];
    for (int a = 0; a < 3; a++)
        real_store(sum[a], s->along[a]);
    for (int m = 0; m < 6 && diagonal; m++)
        real_store(weight[m], s->weight[m]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        size_t k = i + l;
        float front = c->gradient * c->inverse_h / w->choice->each.rest_density[work_fluid(w, k)];
        float own[3] = {sum[0][l], sum[1][l], sum[2][l]}, weights[6];
        const struct drag *remainder = &solve->remainder[k];
        struct drag_block *block = solve->block ? &solve->block[k] : NULL;
        drag_product(w->scalars->dt, front, &solve->search[k], remainder, block, own,
                     &solve->product[k]);
        for (int m = 0; m < 6 && diagonal; m++)
            weights[m] = weight[m][l];
        if (diagonal)
            drag_diagonal(w->scalars->dt, front, weights, remainder, block, &solve->product[k]);
    }
}

FORCE_INLINE void drag_sum(const struct work *w, size_t i, bool diagonal, const unsigned flags)
{
    const size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
    real volume, self[4], zero = real_set(0);
    struct lane_point point = point_load(w, i, &volume);
    struct pair_drags s = {{zero, zero, zero}, {zero, zero, zero, zero, zero, zero}};
    records_own(w->solve.search + i, self);
    drag_row(w, &point, self, w->rows[block].index + lane, w->row_count + i, diagonal, &s,
             flags);
    if (w->wall)
        drag_wall_row(w, &point, self, w->wall_rows[block].index + lane,
                      w->wall_row_count + i, diagonal, &s, flags);
    drag_store(w, i, &s, diagonal);
}
