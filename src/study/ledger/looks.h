/* Features of drawing that a scene can leave out. */
#ifndef STUDY_LOOKS_H
#define STUDY_LOOKS_H

#include "study/ledger/features.h"

extern const struct feature_row look_surface, look_samples, look_occlusion, look_shadow, look_outline, look_alpha,
    look_fade, look_box, look_floor, look_legend, look_title, look_time, look_scale_bar, look_axes, look_labels;

/* Whether the feature changes pictures by its settings. */
static inline bool feature_is_look(const struct feature_row *feature)
{
    return feature->output && feature->settings[STRENGTH_ON];
}

#endif
