/* A scene from text, for tests. */
#ifndef TESTS_SCENE_FILE_H
#define TESTS_SCENE_FILE_H

#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Loads a scene from text by way of a temporary file. */
static inline enum status scene_from_text(struct scene **scene, const char *text, size_t length,
                                          const struct scene_overrides *set,
                                          const struct vocabulary *vocabulary, struct error *e)
{
    char path[] = "/tmp/sph-scene-XXXXXX";
    int file = mkstemp(path);
    *scene = NULL;
    if (file < 0 || write(file, text, length) != (ssize_t)length)
        return error_set(e, STATUS_RUN, "no temporary file");
    close(file);
    enum status status = scene_load(scene, path, set, vocabulary, e);
    unlink(path);
    return status;
}

#endif
