/* Converts colours for FLIP (Andersson et al. 2020, sections 4.1.1 and 4.1.2). */
#include "compare/flip_color.h"

#include "compare/metric.h"

#include <math.h>
#include <string.h>

/* Linear sRGB to CIE XYZ, each row divided by the white point's (IEC 61966-2-1, D65): white is 1. */
static const float to_xyz[3][3] = {
    {0.41238656f / 0.95042854f, 0.35759149f / 0.95042854f, 0.18045049f / 0.95042854f},
    {0.21263682f, 0.71518298f, 0.07218020f},
    {0.01933062f / 1.08890037f, 0.11919716f / 1.08890037f, 0.95037259f / 1.08890037f},
};

/* The inverse of to_xyz. */
static void inverse(float out[3][3])
{
    double m[3][3], determinant = 0;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            m[r][c] = (double)to_xyz[r][c];
    for (int c = 0; c < 3; c++)
        determinant += m[0][c] * (m[1][(c + 1) % 3] * m[2][(c + 2) % 3] -
                                  m[1][(c + 2) % 3] * m[2][(c + 1) % 3]);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            out[c][r] = (float)((m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3] -
                                 m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3]) /
                                determinant);
}

static inline void transform(const float (*m)[3], const float in[3], float out[3])
{
    for (int r = 0; r < 3; r++)
        out[r] = m[r][0] * in[0] + m[r][1] * in[1] + m[r][2] * in[2];
}

static void linear_table(float table[256])
{
    for (int i = 0; i < 256; i++) {
        double v = i / 255.0;
        table[i] = (float)(v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
    }
}

void flip_opponent(float *const out[3], const struct image *image)
{
    float linear[256];
    linear_table(linear);
    for (size_t i = 0; i < metric_pixels(image); i++) {
        const uint8_t *p = image->rgba + 4 * i;
        float rgb[3], xyz[3];
        for (int k = 0; k < 3; k++)
            rgb[k] = linear[p[3] == 255 ? p[k] : p[k] * p[3] / 255];
        transform(to_xyz, rgb, xyz);
        out[0][i] = 116 * xyz[1] - 16;
        out[1][i] = 500 * (xyz[0] - xyz[1]);
        out[2][i] = 200 * (xyz[1] - xyz[2]);
    }
}

/* Of 0.008 to 1: a guess within 4 % from the exponent, and Newton's steps to the last bits. */
static inline float cube_root(float x)
{
    uint32_t bits;
    float y;
    memcpy(&bits, &x, sizeof bits);
    bits = bits / 3 + 0x2a514067u;
    memcpy(&y, &bits, sizeof y);
    for (int k = 0; k < 3; k++)
        y -= (y * y * y - x) / (3 * y * y);
    return y;
}

/* CIE 1976 L*a*b*: the cube root, and a line near black. */
static inline float lab_curve(float t)
{
    const float edge = 6.0f / 29;
    float root = cube_root(t > edge * edge * edge ? t : 1), line = t / (3 * edge * edge) + 4.0f / 29;
    return t > edge * edge * edge ? root : line;
}

static inline void lab_of_linear(const float rgb[3], float lab[3])
{
    float xyz[3];
    transform(to_xyz, rgb, xyz);
    float x = lab_curve(xyz[0]), y = lab_curve(xyz[1]), z = lab_curve(xyz[2]);
    lab[0] = 116 * y - 16;
    lab[1] = 0.01f * lab[0] * (500 * (x - y));
    lab[2] = 0.01f * lab[0] * (200 * (y - z));
}

void flip_lab(float *const planes[3], size_t count)
{
    float *const p0 = planes[0], *const p1 = planes[1], *const p2 = planes[2];
    float to_rgb[3][3];
    inverse(to_rgb);
    for (size_t i = 0; i < count; i++) {
        float y = (p0[i] + 16) / 116, rgb[3], lab[3];
        float xyz[3] = {y + p1[i] / 500, y, y - p2[i] / 200};
        transform((const float (*)[3])to_rgb, xyz, rgb);
        for (int k = 0; k < 3; k++) /* filtered colours may leave the cube */
            rgb[k] = rgb[k] < 0 ? 0 : rgb[k] > 1 ? 1 : rgb[k];
        lab_of_linear(rgb, lab);
        p0[i] = lab[0];
        p1[i] = lab[1];
        p2[i] = lab[2];
    }
}

float flip_largest_distance(void)
{
    float green[3], blue[3];
    lab_of_linear((const float[3]){0, 1, 0}, green);
    lab_of_linear((const float[3]){0, 0, 1}, blue);
    return flip_distance(green, blue);
}
