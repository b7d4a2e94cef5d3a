/* How the scene wants films compressed: movie.codec, crf, preset, tune, pixel_format and options. */
#ifndef RUN_VIDEO_H
#define RUN_VIDEO_H

#include "encode/encode.h"
#include "scene/scene.h"

enum { VIDEO_NUMBER = 32 }; /* room for movie.crf as text */

/* Points into the scene and `crf`. */
struct encode_video video_of_scene(const struct scene *scene, char crf[VIDEO_NUMBER]);

/* Says which of these keys no output heeds, if outputs are pictures or films at all; and that films have no alpha. */
void video_warn(const struct scene *scene, const struct encode_video *video, const char *const *outputs, size_t count);

#endif
