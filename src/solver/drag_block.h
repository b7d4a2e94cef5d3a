/* Blocks of 3 x 3 on the diagonal of implicit viscosity along the line of centres, which precondition
 * its conjugate gradients (Weiler et al. 2018). In the common subset of C and CUDA. */
#ifndef SOLVER_DRAG_BLOCK_H
#define SOLVER_DRAG_BLOCK_H

struct drag_block {
    float wall[3];    /* drag of the closed planes along each axis, 1/s */
    float lower[3];   /* the block is L D L^T: L below its diagonal, 10 20 21 */
    float inverse[3]; /* 1 / D */
};

/* Factors 1 + dt (wall - front sum), sum = xx yy zz xy xz yz of something negative. No pivot is below 1
 * but by rounding, without which the preconditioner stays positive definite however thick the fluid. */
static inline void drag_block_factor(float dt, float front, const float sum[6], struct drag_block *b)
{
    double m[6], scale = -(double)dt * (double)front;
    for (int k = 0; k < 6; k++)
        m[k] = scale * (double)sum[k] + (k < 3 ? 1 + (double)dt * (double)b->wall[k] : 0);
    double d0 = m[0] > 1 ? m[0] : 1, l10 = m[3] / d0, l20 = m[4] / d0;
    double d1 = m[1] - l10 * m[3];
    d1 = d1 > 1 ? d1 : 1;
    double l21 = (m[5] - l20 * m[3]) / d1;
    double d2 = m[2] - l20 * m[4] - l21 * l21 * d1;
    d2 = d2 > 1 ? d2 : 1;
    b->lower[0] = (float)l10;
    b->lower[1] = (float)l20;
    b->lower[2] = (float)l21;
    b->inverse[0] = (float)(1 / d0);
    b->inverse[1] = (float)(1 / d1);
    b->inverse[2] = (float)(1 / d2);
}

/* z = r / block */
static inline void drag_block_solve(const struct drag_block *b, const float r[3], float z[3])
{
    float y1 = r[1] - b->lower[0] * r[0], y2 = r[2] - b->lower[1] * r[0] - b->lower[2] * y1;
    z[2] = b->inverse[2] * y2;
    z[1] = b->inverse[1] * y1 - b->lower[2] * z[2];
    z[0] = b->inverse[0] * r[0] - b->lower[0] * z[1] - b->lower[1] * z[2];
}

#endif
