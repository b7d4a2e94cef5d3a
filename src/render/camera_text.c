/* Writes the camera as the text of a scene file. */
#include "render/camera.h"

#include <math.h>

/* In scene coordinates, so ten digits do for domains that are not far from the origin. */
static void write_point(const char *name, const double point[3], FILE *out)
{
    fprintf(out, "\"%s\": [%.10g, %.10g, %.10g]", name, point[0], point[1], point[2]);
}

/* Distance along the line of sight of the middle of the domain, where the target is put. */
static double target_distance(const struct camera *camera, const struct scene *scene)
{
    double middle[3], view[3];
    for (int k = 0; k < 3; k++)
        middle[k] = (scene->domain.max[k] - scene->domain.min[k]) / 2;
    camera_view(camera, middle, view);
    return view[2] > 0 ? view[2] : 1;
}

/* Eye, target, up, and the angle where it counts. */
static void write_view(const struct camera *camera, const struct scene *scene, FILE *out)
{
    double eye[3], target[3], distance = target_distance(camera, scene);
    for (int k = 0; k < 3; k++) {
        eye[k] = camera->eye[k] + scene->domain.min[k];
        target[k] = eye[k] + distance * camera->forward[k];
    }
    write_point("eye", eye, out);
    fputs(", ", out);
    write_point("target", target, out);
    fputs(", ", out);
    write_point("up", camera->up, out);
    if (!camera->orthographic)
        fprintf(out, ", \"fov\": %.10g", atan(camera->tan_y) * 360 / 3.141592653589793);
}

void camera_write(const struct scene *scene, double radius, const double *times, size_t count,
                  FILE *out)
{
    struct camera camera;
    camera_make(&camera, scene, radius, times[0]);
    fputs("\"camera\": {", out);
    if (camera.orthographic)
        fprintf(out, "\"projection\": \"orthographic\", \"height\": %.10g, ", 2 * camera.half_y);
    if (count == 1) {
        write_view(&camera, scene, out);
    } else {
        fputs("\"keyframes\": [", out);
        for (size_t i = 0; i < count; i++) {
            camera_make(&camera, scene, radius, times[i]);
            fprintf(out, "%s\n  {\"time\": %.10g, ", i ? "," : "", times[i]);
            write_view(&camera, scene, out);
            fputs("}", out);
        }
        fputs("]", out);
    }
    fputs("}\n", out);
}
