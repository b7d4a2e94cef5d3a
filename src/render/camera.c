/* Where the picture is taken from: camera keys of the scene, orbit, and automatic framing. */
#include "render/camera.h"

#include "base/portable_math.h"
#include "render/camera_path.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double margin = 1.06; /* free border around an automatically framed domain */
static const double legend_sizes = 6.5; /* width of the colour bar with its text, text sizes */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static bool finite3(const double a[3])
{
    return isfinite(a[0]) && isfinite(a[1]) && isfinite(a[2]);
}

/* Scales to length 1; false when there is no direction. */
static bool normalize(double a[3])
{
    double length = sqrt(dot(a, a));
    if (!(length > 0) || !isfinite(length))
        return false;
    for (int k = 0; k < 3; k++)
        a[k] /= length;
    return true;
}

/* Turns `a` about the unit vector `axis` (Rodrigues). */
static void rotate(double a[3], const double axis[3], double angle)
{
    double side[3], along = dot(a, axis), c = portable_cos(angle), s = portable_sin(angle);
    cross(axis, a, side);
    for (int k = 0; k < 3; k++)
        a[k] = a[k] * c + side[k] * s + axis[k] * along * (1 - c);
}

/* The unit vector along `wanted`, or y. */
static void up_axis(const double wanted[3], double up[3])
{
    memcpy(up, wanted, 3 * sizeof up[0]);
    if (!finite3(up) || !normalize(up)) {
        up[0] = up[2] = 0;
        up[1] = 1;
    }
}

/* Fills right and up from forward and the wished up vector. */
static void axes_make(struct camera *camera, const double up[3])
{
    cross(camera->forward, up, camera->right);
    if (dot(camera->right, camera->right) < 1e-12) { /* looking along up: any right will do */
        const double *f = camera->forward;
        double other[3] = {0, 0, 0};
        other[fabs(f[0]) < fabs(f[2]) ? 0 : 2] = fabs(f[0]) < fabs(f[2]) ? 1 : -1;
        cross(camera->forward, other, camera->right);
    }
    normalize(camera->right);
    cross(camera->right, camera->forward, camera->up);
}

/* How far the domain reaches along a direction, m. */
static double extent(const struct scene *scene, const double axis[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += fabs(axis[k]) * (scene->domain.max[k] - scene->domain.min[k]);
    return sum;
}

/* A direction to look along that shows three faces of a box standing on the ground: most of its
 * front, or of its side where the box is much deeper than wide. */
static void default_forward(const struct scene *scene, const double up[3], double forward[3])
{
    double back[3] = {0, 0, 0}, side[3];
    if (fabs(up[2]) > 0.9) /* z up: the front is at -y */
        back[1] = -1;
    else
        back[2] = 1;
    cross(up, back, side);
    normalize(side);
    cross(side, up, back);
    bool deep = extent(scene, back) > 1.5 * extent(scene, side);
    for (int k = 0; k < 3; k++)
        forward[k] = -((deep ? 0.48 : 0.80) * back[k] + (deep ? 0.80 : 0.48) * side[k] +
                       0.42 * up[k]);
    normalize(forward);
}

void camera_corner(const struct scene *scene, int i, double grow, double corner[3])
{
    for (int k = 0; k < 3; k++)
        corner[k] = i >> k & 1 ? scene->domain.max[k] - scene->domain.min[k] + grow : -grow;
}

void camera_view(const struct camera *camera, const double point[3], double view[3])
{
    double d[3] = {point[0] - camera->eye[0], point[1] - camera->eye[1],
                   point[2] - camera->eye[2]};
    view[0] = dot(d, camera->right);
    view[1] = dot(d, camera->up);
    view[2] = dot(d, camera->forward);
}

/* Pixels at the right edge that the colour bar takes. */
static double legend_pixels(const struct scene *scene)
{
    bool legend = scene->color.legend && strcmp(scene->color.by, "solid") != 0;
    return legend ? legend_sizes * camera_text_size(scene) : 0;
}

double camera_text_size(const struct scene *scene)
{
    double shorter = fmin(scene->movie.size[1], scene->movie.size[0] * 0.65);
    return shorter < 140 ? 0 : fmax(8, shorter * 0.026);
}

/* What an eye at distance d before the middle of the domain, shifted by x and y, must see: a corner
 * p is right enough when p.x - x <= right * (p.z + d), and so on for left, top and bottom. Linear
 * conditions on d, x and y, so their bounds over all corners (and angles) can be gathered.
 * Orthographic, the picture is right * d wide whatever the depth: p.z drops out. */
struct fit {
    double left, right, side; /* tangents of the usable picture; orthographic: per half height */
    double narrowing;         /* what a metre of depth counts: 1, or orthographic 0 */
    double most[4];           /* right, left, top, bottom, m */
    double nearest;           /* corner along the line of sight, m */
};

static struct fit fit_make(const struct camera *camera, const struct scene *scene)
{
    double bar = fmin(0.5, 2 * legend_pixels(scene) / camera->width);
    double aspect = (double)camera->width / camera->height;
    double x = (camera->orthographic ? aspect : camera->tan_x) / margin;
    return (struct fit){.left = x, .right = x * (1 - bar),
                        .side = (camera->orthographic ? 1 : camera->tan_y) / margin,
                        .narrowing = camera->orthographic ? 0 : 1, .nearest = INFINITY,
                        .most = {-INFINITY, -INFINITY, -INFINITY, -INFINITY}};
}

static void fit_add(struct fit *fit, const struct camera *camera, const struct scene *scene,
                    double radius, const double center[3])
{
    for (int i = 0; i < 8; i++) {
        double p[3], x, y, z;
        camera_corner(scene, i, radius, p);
        for (int k = 0; k < 3; k++)
            p[k] -= center[k];
        x = dot(p, camera->right);
        y = dot(p, camera->up);
        z = dot(p, camera->forward);
        fit->nearest = fmin(fit->nearest, z);
        z *= fit->narrowing;
        fit->most[0] = fmax(fit->most[0], x - fit->right * z);
        fit->most[1] = fmax(fit->most[1], -x - fit->left * z);
        fit->most[2] = fmax(fit->most[2], y - fit->side * z);
        fit->most[3] = fmax(fit->most[3], -y - fit->side * z);
    }
}

/* The least d that satisfies all. */
static double fit_solve(const struct fit *f)
{
    double d = fmax((f->most[0] + f->most[1]) / (f->left + f->right),
                    (f->most[2] + f->most[3]) / (2 * f->side));
    return f->narrowing > 0 ? fmax(d, -f->nearest * 1.01 + 1e-9) : d;
}

/* Sets the picture's size to `height` m, and goes back until the domain is in front. */
static void make_orthographic(struct camera *camera, const struct scene *scene, double radius,
                              double height)
{
    double nearest = INFINITY, corner[3], view[3];
    camera->half_y = height / 2;
    camera->half_x = camera->half_y * camera->width / camera->height;
    camera->tan_x = camera->tan_y = 0;
    for (int i = 0; i < 8; i++) {
        camera_corner(scene, i, radius, corner);
        camera_view(camera, corner, view);
        nearest = fmin(nearest, view[2]);
    }
    for (int k = 0; k < 3; k++)
        camera->eye[k] += fmin(0, nearest - 0.1 * height) * camera->forward[k];
}

/* Height of an orthographic picture, m; `automatic` unless the scene says it. */
static double picture_height(const struct scene *scene, double automatic)
{
    double height = scene->camera.height;
    return height > 0 && isfinite(height) ? height : automatic;
}

/* Places the eye so that the domain fills the picture; on an orbit, so that it does at any angle,
 * from one distance. */
static void frame_domain(struct camera *camera, const struct scene *scene, double radius,
                         const double up[3], bool orbit, double angle)
{
    double center[3], shift[2], start[3], d;
    struct fit fit = fit_make(camera, scene);
    for (int k = 0; k < 3; k++)
        center[k] = (scene->domain.max[k] - scene->domain.min[k]) / 2;
    default_forward(scene, up, start);
    for (int i = 0; i < (orbit ? 64 : 1); i++) {
        memcpy(camera->forward, start, sizeof start);
        rotate(camera->forward, up, i * 6.283185307179586 / 64);
        axes_make(camera, up);
        fit_add(&fit, camera, scene, radius, center);
    }
    d = fit_solve(&fit);
    if (camera->orthographic)
        d = picture_height(scene, 2 * d) / 2;
    shift[0] = (fit.most[0] - fit.most[1] + (fit.left - fit.right) * d) / 2;
    shift[1] = (fit.most[2] - fit.most[3]) / 2; /* equal room above and below */
    memcpy(camera->forward, start, sizeof start);
    rotate(camera->forward, up, angle);
    axes_make(camera, up);
    for (int k = 0; k < 3; k++)
        camera->eye[k] = center[k] - d * camera->forward[k] + shift[0] * camera->right[k] +
                         shift[1] * camera->up[k];
    if (camera->orthographic)
        make_orthographic(camera, scene, radius, 2 * d);
}

/* Looks from the eye to the target, turned about the target. */
static void look(struct camera *camera, const struct scene *scene,
                 const struct scene_keyframe *wish, const double up[3], double angle)
{
    double target[3];
    for (int k = 0; k < 3; k++) {
        target[k] = wish->target[k] - scene->domain.min[k];
        camera->eye[k] = wish->eye[k] - scene->domain.min[k] - target[k];
    }
    rotate(camera->eye, up, angle);
    for (int k = 0; k < 3; k++)
        camera->forward[k] = -camera->eye[k];
    if (!normalize(camera->forward))
        default_forward(scene, up, camera->forward);
    for (int k = 0; k < 3; k++)
        camera->eye[k] += target[k];
    axes_make(camera, up);
}

/* The eye's distance from its target, m; never 0. */
static double reach(const struct scene_keyframe *wish)
{
    double d[3] = {wish->target[0] - wish->eye[0], wish->target[1] - wish->eye[1],
                   wish->target[2] - wish->eye[2]};
    double length = sqrt(dot(d, d));
    return length > 0 ? length : 1;
}

void camera_make(struct camera *camera, const struct scene *scene, double radius, double time)
{
    struct scene_keyframe wish;
    double up[3], period = scene->camera.orbit_period;
    bool orbit = isfinite(period) && period != 0 && isfinite(time);
    double angle = orbit ? fmod(time / period, 1) * 6.283185307179586 : 0;
    camera_path(scene, time, &wish);
    if (!(wish.fov >= 1 && wish.fov <= 170))
        wish.fov = 40;
    *camera = (struct camera){.width = scene->movie.size[0], .height = scene->movie.size[1],
                              .orthographic = scene->camera.projection == PROJECTION_ORTHOGRAPHIC};
    camera->tan_y = portable_tan(wish.fov * 3.141592653589793 / 360);
    camera->tan_x = camera->tan_y * camera->width / camera->height;
    up_axis(wish.up, up);
    if (!finite3(wish.eye)) {
        frame_domain(camera, scene, radius, up, orbit, angle);
        return;
    }
    look(camera, scene, &wish, up, angle);
    if (camera->orthographic)
        make_orthographic(camera, scene, radius,
                          picture_height(scene, 2 * reach(&wish) * camera->tan_y));
}
