/* The look of spheres: light and material, one description for every renderer. */
#ifndef RENDER_LOOK_H
#define RENDER_LOOK_H

/* Faces turned to the viewer and the light keep the colour of the colour bar; others darken:
 *   light = (base + sky (1 + n_y)/2 + diffuse max(n.key, 0)) (1 - facing + facing max(-n.ray, 0))
 *   pixel = colour min(light, 1) + shine max(reflect(ray, n).key, 0)^24
 * but at the rim, where max(-n.ray, 0)^2 < rim: a quarter of colour min(light, 1)
 * in camera axes: x right, y up, z towards the viewer. */
struct look {
    float base, sky, diffuse, facing, shine, rim;
    float key[3]; /* unit vector towards the key light */
};

/* The key light stands over the viewer's left shoulder, so it turns with an orbiting camera and
 * colours read alike all round; the sky is up in the picture. `outline` is the rim's width / radius. */
struct look look_make(double outline);

#endif
