/* The loop around particle shifting's pair body; part of pair_loops.h. */

FORCE_INLINE void shift_wall_row(const struct pair_work *w, const struct lane_point *point,
                                 const struct pair_shift_self *self, const uint32_t *row,
                                 const uint32_t *count, struct pair_shift *s, const unsigned flags)
{
    uint32_t length = longest(count);
    real still[4] = {self->vx, self->vy, self->vz, self->pressure};
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, count, p.q, far);
        pair_shift(s, self, other[3], still, &p, flags);
    }
}

FORCE_INLINE void shift_store(const struct pair_work *w, size_t i, const struct pair_shift *s)
{
    const struct shift_work *shift = w->shift;
    float sum[10][LANES];
    real_store(sum[0], s->cx), real_store(sum[1], s->cy), real_store(sum[2], s->cz);
    real_store(sum[3], s->place), real_store(sum[4], s->fast), real_store(sum[5], s->ax);
    real_store(sum[6], s->ay), real_store(sum[7], s->az), real_store(sum[8], s->pressure), real_store(sum[9], s->number);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        size_t k = i + l;
        struct shift_sums sums = {.place = sum[3][l], .number = sum[9][l], .fast = sum[4][l], .pressure = sum[8][l]};
        for (int a = 0; a < 3; a++)
            sums.crowd[a] = sum[a][l], sums.along[a] = sum[5 + a][l];
        shift_rate(shift->each, w->fluid ? w->fluid[k] : 0, w->constants.gradient, shift->dt,
                   &w->position[k], w->density[k], &sums, shift->id[k], &w->rate[k], &shift->now[k]);
    }
}

FORCE_INLINE void shift_blocks(const struct pair_work *w, size_t first_block, size_t last_block,
                               const unsigned flags)
{
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        const size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
        const uint32_t *row = w->rows[block].index + lane;
        uint32_t length = longest(w->row_count + i);
        real volume, motion[4], shift[4], zero = real_set(0);
        struct lane_point point = point_load(w, i, &volume);
        records_load(w->motion + i, lane_ramp, motion);
        records_load(w->shift->before + i, lane_ramp, shift);
        struct pair_shift_self self = {motion[0], motion[1], motion[2], motion[3], shift[0],
                                       shift[1],  shift[2],  real_set(w->shift->crowd)};
        struct pair_shift s = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
        for (uint32_t k = 0; k < length; k++) {
            const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
            real other[4], moving[4];
            records_load(w->position, index, other);
            records_load(w->motion, index, moving);
            struct pair p = pair_between(&point, other);
            p.q = real_below(k, w->row_count + i, p.q, real_set(16));
            pair_shift(&s, &self, other[3], moving, &p, flags);
        }
        if (w->wall)
            shift_wall_row(w, &point, &self, w->wall_rows[block].index + lane,
                           w->wall_row_count + i, &s, flags);
        shift_store(w, i, &s);
    }
}

static void shift_wendland(const struct pair_work *w, size_t first, size_t last)
{
    shift_blocks(w, first, last, 0);
}
static void shift_cubic(const struct pair_work *w, size_t first, size_t last)
{
    shift_blocks(w, first, last, KERNEL_CUBIC);
}
