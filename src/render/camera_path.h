/* The camera that the scene asks for at a time: the still one, or on the way between keyframes. */
#ifndef RENDER_CAMERA_PATH_H
#define RENDER_CAMERA_PATH_H

#include "scene/scene.h"

/* Nothing is NAN but what the scene leaves to the program: the eye (no keyframes), or numbers that
 * make no sense. A target that is not said is the middle of the domain. Coordinates of the scene. */
void camera_path(const struct scene *scene, double time, struct scene_keyframe *at);

#endif
