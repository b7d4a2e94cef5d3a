/* Features of drawing that a scene can leave out: rows of the table of features. */
#include "study/ledger/looks.h"

#include <math.h>
#include <string.h>

/* Each is drawn, not encoded, with its neutral value said and with it, and costs what drawing takes more. */
#define LOOK(doc_, name_, off_, on_, used_)                                                              \
    {{name_, doc_, NULL, 0, NULL}, {off_, on_, NULL}, NULL, NULL, {NULL}, {0}, 0, used_, "hash", NULL, \
     "draw"}

static bool uses_surface(const struct plan *plan)
{
    return strcmp(plan->scene->render.style, "surface") == 0;
}

static bool uses_samples(const struct plan *plan) { return plan->scene->render.samples > 1; }
static bool uses_occlusion(const struct plan *plan) { return plan->scene->render.occlusion > 0; }
static bool uses_shadow(const struct plan *plan) { return plan->scene->render.shadow > 0; }
static bool uses_outline(const struct plan *plan) { return plan->scene->render.outline > 0; }
static bool uses_alpha(const struct plan *plan) { return plan->scene->render.transparent; }
static bool uses_fade(const struct plan *plan) { return !isnan(plan->scene->render.background_top[0]); }
static bool uses_box(const struct plan *plan) { return plan->scene->render.box != BOX_NONE; }
static bool uses_legend(const struct plan *plan) { return plan->scene->color.legend; }
static bool uses_title(const struct plan *plan) { return plan->scene->render.title; }
static bool uses_time(const struct plan *plan) { return plan->scene->render.time; }
static bool uses_scale_bar(const struct plan *plan) { return plan->scene->render.scale_bar; }
static bool uses_axes(const struct plan *plan) { return plan->scene->render.axes; }
static bool uses_labels(const struct plan *plan) { return plan->scene->label_count > 0; }

static bool uses_floor(const struct plan *plan)
{
    return plan->scene->render.floor != FLOOR_NONE &&
           (plan->scene->render.floor != FLOOR_AUTO || plan->scene->render.box != BOX_NONE);
}

const struct feature_row look_surface = LOOK("the fluid's surface instead of spheres", "surface",
    "render.style=\"spheres\"", "render.style=\"surface\"", uses_surface);
const struct feature_row look_samples = LOOK("two samples of a pixel in x and in y", "antialiasing",
    "render.samples=1", "render.samples=2", uses_samples);
const struct feature_row look_occlusion = LOOK("darker where others surround", "occlusion",
    "render.occlusion=0", "render.occlusion=0.6", uses_occlusion);
const struct feature_row look_shadow = LOOK("on the floor", "shadow",
    "render.shadow=0", "render.floor=\"plain\" render.shadow=0.5", uses_shadow);
const struct feature_row look_outline = LOOK("dark rims of particles", "outline",
    "render.outline=0", "render.outline=0.25", uses_outline);
const struct feature_row look_alpha = LOOK("no background", "alpha",
    "render.transparent=false", "render.transparent=true", uses_alpha);
const struct feature_row look_fade = LOOK("a background that fades", "background that fades",
    "render.background_top=\"auto\"", "render.background_top=[0.6,0.7,0.9]", uses_fade);
const struct feature_row look_box = LOOK("edges of the domain", "box",
    "render.box=\"none\"", "render.box=\"lines\"", uses_box);
const struct feature_row look_floor = LOOK("of the domain", "floor",
    "render.floor=\"none\"", "render.floor=\"plain\"", uses_floor);
const struct feature_row look_legend = LOOK("colour bar", "legend",
    "color.legend=false", "color.legend=true", uses_legend);
const struct feature_row look_title = LOOK("title", "title",
    "render.title=false", "render.title=true", uses_title);
const struct feature_row look_time = LOOK("time stamp", "time stamp",
    "render.time=false", "render.time=true", uses_time);
const struct feature_row look_scale_bar = LOOK("a length", "scale bar",
    "render.scale_bar=false", "render.scale_bar=true", uses_scale_bar);
const struct feature_row look_axes = LOOK("directions of x, y and z", "axes",
    "render.axes=false", "render.axes=true", uses_axes);
const struct feature_row look_labels = LOOK("text over every frame", "labels",
    "labels=[]", "labels=[{\"text\":\"label\"}]", uses_labels);
