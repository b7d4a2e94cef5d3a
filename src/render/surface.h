/* The fluid's surface instead of spheres: fields over the picture's samples, smoothed and shaded.
 *
 * Larger spheres give the depth z of the surface. A filter of narrow range (Truong & Yuksel 2018) smooths
 * it, along rows and then columns: of the samples at -k and k both are left out where one is nearer than
 * z - far, and one beyond z + far counts as z + step, so that edges stay sharp and nothing bleeds over
 * them. The thickness is the sum of the spheres' chords, scaled to the fluid's volume. Fresnel's
 * reflectance is Schlick's; the light that comes through decays with thickness (Beer & Lambert). What is
 * behind, the background and the far side of the domain, is seen by bent rays. */
#ifndef RENDER_SURFACE_H
#define RENDER_SURFACE_H

#include "render/camera.h"
#include "render/splat.h"

enum { SURFACE_PAD = 32 }; /* samples around the picture, and the filter's largest reach */

struct surface {
    int width, height;
    size_t pitch;             /* of rows, samples */
    float *depth, *other;     /* INFINITY: nothing; each with SURFACE_PAD around the picture */
    float *thickness;         /* m */
    uint32_t *ball;           /* the sphere in front; UINT32_MAX: none */
    uint8_t (*behind)[4];     /* the picture without fluid */
    float reach;              /* samples of the filter's reach, times distance, m, unless parallel */
    bool parallel;            /* orthographic */
    float far, step;          /* m */
    float volume;             /* of a particle / that of its sphere */
    float clarity;            /* m in which light decays by a factor e for a colour that is 0 */
    bool opaque;              /* colours show a value: nothing shines through them */
    float axis[3][3], eye[3]; /* camera axes (z in front of the eye) in the domain's, and the eye, m */
    float side[3], half[2];   /* of the domain, m; samples from the picture's middle, as struct ball_view */
    const struct blend *back; /* what is behind, in order; none: the background alone, unbent */
    size_t back_count;
    float weight[SURFACE_PAD + 1][SURFACE_PAD + 1]; /* of reach and distance, samples */
};

/* The place of a sample in the padded fields. */
static inline size_t surface_at(const struct surface *f, int x, int y)
{
    return (size_t)(y + SURFACE_PAD) * f->pitch + (size_t)(x + SURFACE_PAD);
}

/* Room for a picture of width x height samples; false when memory is short. */
bool surface_open(struct surface *surface, int width, int height, bool opaque);
void surface_close(struct surface *surface);

/* Sets what rays are bent by. */
void surface_view(struct surface *surface, const struct camera *camera, const struct scene *scene);

/* Sets what depends on the spheres' radius, m, the distance of particles, m, and the samples that are
 * seen of 1 m at a distance of 1 m. */
void surface_scale(struct surface *surface, double radius, double spacing, double samples);

/* Loops of render/surface_loops.h, of each instruction set: */
struct surface_loops {
    /* Copies a tile's depths and spheres into the fields. */
    void (*keep)(struct surface *surface, const struct tile *tile);
    /* Thickness of a tile, from all its spheres. */
    void (*thicken)(const struct splat *splat, struct surface *surface, struct tile *tile,
                    const struct ball_list *list);
    /* Draws what is behind a tile's fluid; only where there is any. */
    void (*behind)(const struct splat *splat, struct surface *surface, struct tile *tile);
    /* Smooths row y of thickness likewise into other, over samples of about the same depth. */
    void (*soften)(struct surface *surface, int y, size_t step);
    /* Smooths row y from depth into other, along the row (step 1) or the columns (step pitch). */
    void (*smooth)(struct surface *surface, int y, size_t step);
    /* Colours and depths of a tile. */
    void (*shade)(const struct splat *splat, const struct surface *surface, struct tile *tile);
};

#endif
