/* Reads variants' own keys out of a scene by path, and says where one does not fit. */
#include "scene/scene.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
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

static enum status fail(const struct scene *scene, struct scene_place place, struct error *e, const char *format,
                        va_list args)
{
    char text[1500];
    vsnprintf(text, sizeof text, format, args);
    if (!place.line)
        return error_set(e, STATUS_USAGE, "%.400s: %s", scene->source, text);
    return error_set(e, STATUS_USAGE, "%.400s:%d:%d: %s", scene->source, place.line, place.column, text);
}

enum status scene_fail(const struct scene *scene, const char *path, struct error *e,
                       const char *format, ...)
{
    const struct scene_option *option = option_find(scene, path);
    va_list args;
    va_start(args, format);
    fail(scene, option ? option->place : (struct scene_place){0}, e, format, args);
    va_end(args);
    return e->status;
}

enum status scene_fail_at(const struct scene *scene, struct scene_place place, struct error *e,
                          const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fail(scene, place, e, format, args);
    va_end(args);
    return e->status;
}
