/* What is seen through the fluid's surface; part of surface_loops.h. */

/* Draws what is behind the fluid in a tile, and keeps it. */
static void surface_behind(const struct splat *s, struct surface *f, struct tile *tile)
{
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < TILE; x++) {
            tile->depth[y][x] = INFINITY;
            for (int k = 0; k < 4; k++)
                tile->color[k][y][x] = back_of(s, k, tile->top + y);
        }
    for (size_t i = 0; i < f->back_count; i++)
        tile_blend(&f->back[i], tile, 4);
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++) {
            uint8_t *rgb = f->behind[surface_at(f, tile->left + x, tile->top + y)];
            for (int k = 0; k < 4; k++)
                rgb[k] = (uint8_t)(int)(255 * tile->color[k][y][x] + 0.5F);
        }
}

/* The way from a place along a direction, both in camera axes, until it leaves the domain; 0 outside. */
static inline float surface_exit(const struct surface *f, const float at[3], const float along[3])
{
    float least = INFINITY;
    for (int a = 0; a < 3; a++) {
        float place = f->eye[a], step = 0;
        for (int k = 0; k < 3; k++) {
            place += f->axis[k][a] * at[k];
            step += f->axis[k][a] * along[k];
        }
        float way = fabsf(step) < 1e-6F ? INFINITY : ((step > 0 ? f->side[a] : 0) - place) / step;
        least = way < least ? way : least;
    }
    return least > 0 && least < INFINITY ? least : 0;
}

/* Between the four samples about a place in the picture; the nearest ones outside. */
static inline void surface_look_up(const struct surface *f, float x, float y, float out[4])
{
    x = x > 0 ? x < (float)(f->width - 1) ? x : (float)(f->width - 1) : 0;
    y = y > 0 ? y < (float)(f->height - 1) ? y : (float)(f->height - 1) : 0;
    int column = (int)x, row = (int)y;
    size_t right = column + 1 < f->width, below = row + 1 < f->height ? f->pitch : 0;
    const uint8_t (*rgb)[4] = (const uint8_t (*)[4])f->behind + surface_at(f, column, row);
    float u = x - (float)column, v = y - (float)row;
    for (int k = 0; k < 4; k++) {
        float upper = (float)rgb[0][k] + u * ((float)rgb[right][k] - (float)rgb[0][k]);
        float lower = (float)rgb[below][k] + u * ((float)rgb[below + right][k] - (float)rgb[below][k]);
        out[k] = (upper + v * (lower - upper)) * (1 / 255.0F);
    }
}

/* The ray is bent where it enters (Snell's law), runs as far as the fluid is thick, but not out of the domain,
 * leaves as it came, and meets the domain's far side: the picture of that is seen. `n` and `facing` as in
 * surface_sample. */
static inline void surface_refract(const struct splat *s, const struct surface *f, int x, int y,
                                   const float n[3], float facing, float out[4])
{
    const float eta = 1 / 1.333F, lens = s->lens, z = f->depth[surface_at(f, x, y)];
    float rx = lens * s->ray_x[x], ry = lens * s->ray_y[y], unit = 1 / sqrtf(rx * rx + ry * ry + 1);
    float scale = lens * z + (1 - lens), turn = eta * facing - sqrtf(1 - eta * eta * (1 - facing * facing));
    float at[3] = {scale * s->ray_x[x], scale * s->ray_y[y], z}, ray[3] = {rx * unit, ry * unit, unit};
    float bent[3] = {eta * ray[0] + turn * n[0], eta * ray[1] + turn * n[1], eta * ray[2] - turn * n[2]};
    float way = surface_exit(f, at, bent), thick = f->thickness[surface_at(f, x, y)];
    way = thick < way ? thick : way;
    for (int k = 0; k < 3; k++)
        at[k] += way * bent[k];
    way = surface_exit(f, at, ray);
    for (int k = 0; k < 3; k++)
        at[k] += way * ray[k];
    float shrink = 1 / (lens * at[2] + (1 - lens));
    surface_look_up(f, at[0] * shrink * f->half[0] + 0.5F * (float)f->width - 0.5F,
                    at[1] * shrink * f->half[1] + 0.5F * (float)f->height - 0.5F, out);
}
