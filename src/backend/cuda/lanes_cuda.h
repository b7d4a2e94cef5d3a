/* One lane, a CUDA thread: the operations of cpu/lanes_scalar.h with the loads that a GPU likes. Included
 * by nvcc, where `inline` functions are made for host and device (cuda/subset.h). */
#ifndef BACKEND_CUDA_LANES_CUDA_H
#define BACKEND_CUDA_LANES_CUDA_H

enum { LANES = 1 };
typedef float real;

static inline real real_set(float x)
{
    return x;
}
static inline real real_load(const float *p)
{
    return *p;
}
static inline void real_store(float *p, real x)
{
    *p = x;
}
static inline real real_fma(real a, real b, real c)
{
    return fmaf(a, b, c);
}
static inline real real_positive(real x)
{
    return x > 0 ? x : 0;
}
static inline real real_rsqrt_guess(real x)
{
    return __uint_as_float(0x5f375a86u - (__float_as_uint(x) >> 1));
}
static inline real real_difference(real a, real b)
{
    return (float)(int32_t)(__float_as_uint(a) - __float_as_uint(b));
}
static inline real real_below(uint32_t k, const uint32_t *count, real x, real y)
{
    return k < *count ? x : y;
}

/* The four words of a 16-byte record, in one load. */
static inline void record_load(const void *record, real out[4])
{
    float4 r = *(const float4 *)record;
    out[0] = r.x, out[1] = r.y, out[2] = r.z, out[3] = r.w;
}
static inline void records_load(const void *records, const uint32_t *index, real out[4])
{
    record_load((const char *)records + 8 * (size_t)*index, out);
}
static inline void records_own(const void *records, real out[4])
{
    record_load(records, out);
}
static inline void rows_prefetch(const void *entry) /* other threads hide the latency */
{
    (void)entry;
}
static inline real lookup_load(const float *values, const uint32_t *index)
{
    return values[*index / 2];
}

#endif
