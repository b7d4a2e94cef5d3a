/* Reads variants' own keys out of a scene by path. */
#include "scene/scene.h"

#include <math.h>
#include <string.h>

static const struct scene_option *option_find(const struct scene *scene, const char *path)
{
    for (size_t i = 0; i < scene->option_count; i++)
        if (strcmp(scene->options[i].path, path) == 0)
            return &scene->options[i];
    return NULL;
}

double scene_real(const struct scene *scene, const char *path)
{
    const struct scene_option *option = option_find(scene, path);
    return option ? option->value.real : (double)NAN;
}

bool scene_flag(const struct scene *scene, const char *path)
{
    const struct scene_option *option = option_find(scene, path);
    return option && option->value.flag;
}

int64_t scene_integer(const struct scene *scene, const char *path)
{
    const struct scene_option *option = option_find(scene, path);
    return option ? option->value.integer : 0;
}

const char *scene_text(const struct scene *scene, const char *path)
{
    const struct scene_option *option = option_find(scene, path);
    return option ? option->value.text : "";
}

const double *scene_vector(const struct scene *scene, const char *path)
{
    const struct scene_option *option = option_find(scene, path);
    return option ? option->value.vector : NULL;
}
