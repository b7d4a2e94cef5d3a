/* A scene: what a scene file says, with defaults, checked, never changed after. SI units. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/error.h"
#include "scene/key.h"
#include "scene/shape.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Faces in the order -x +x -y +y -z +z, as in "domain.walls.-x". */
enum { FACE_COUNT = 6 };
extern const char *const scene_face_names[FACE_COUNT];

enum wall_kind {
    WALL_CLOSED,    /* plane that reflects with restitution; nothing passes */
    WALL_PARTICLES, /* static boundary particles (Akinci 2012) in front of a closed plane */
    WALL_PERIODIC   /* joined to the opposite face, which must be periodic too */
};

enum body_fill { FILL_GRID, FILL_RANDOM };
enum body_start { START_AUTO, START_REST, START_HYDROSTATIC }; /* pressure at the start */

enum color_spread { SPREAD_AUTO, SPREAD_LINEAR, SPREAD_LOG, SPREAD_SYMMETRIC };

enum box_style { BOX_NONE, BOX_LINES, BOX_FACES };
enum floor_style { FLOOR_AUTO, FLOOR_NONE, FLOOR_PLAIN, FLOOR_GRID, FLOOR_CHECKER };

enum label_place {
    LABEL_TOP_LEFT, LABEL_TOP, LABEL_TOP_RIGHT, LABEL_BOTTOM_LEFT, LABEL_BOTTOM, LABEL_BOTTOM_RIGHT
};

struct scene_place { int line, column; }; /* in the scene file; 0: not said there */

struct scene_fluid {
    char name[KEY_TEXT_SIZE];
    double density;        /* rest density, kg/m^3 */
    double viscosity;      /* dynamic viscosity, Pa s */
    double surface_tension;/* N/m */
    bool visible;          /* drawn */
    double color[3];       /* for color.by = "solid", 0..1 */
};

struct scene_body {
    char fluid_name[KEY_TEXT_SIZE]; /* as written; never empty once loaded */
    int fluid;             /* index into fluids */
    struct shape shape;
    enum body_fill fill;
    double jitter;         /* standard deviation of displacement from the lattice, in spacings */
    uint64_t seed;
    double velocity[3];    /* m/s */
    char flow[KEY_TEXT_SIZE]; /* table "flows": added to velocity */
    double flow_center[3]; /* m */
    double flow_length;    /* m */
    double flow_speed;     /* m/s */
    enum body_start start;
    struct scene_place place;
};

enum { OBSTACLES_MAX = 64 };

/* A solid that stands still in the domain: fluid flows round it. Obstacles may share space. */
struct scene_obstacle {
    struct shape shape;
    double color[3];       /* 0..1 */
    bool visible;          /* drawn */
    struct scene_place place;
};

/* A measured quantity. What a quantity does not read is zero. */
struct scene_measure {
    char quantity[KEY_TEXT_SIZE]; /* table "measures" */
    char name[KEY_TEXT_SIZE];     /* of its columns; never empty once loaded, each its own */
    double at[3], radius;         /* m; radius NAN: the kernel's support */
    int face;                     /* as in scene_face_names */
    double min[3], max[3];        /* m, rectangle on the face; NAN: all of it */
    int axis, side;               /* 0 x, 1 y, 2 z; 0 the largest coordinate, 1 the lowest */
    double from[3], to[3];        /* m, ends of a line */
    int64_t points;               /* on it, or slabs */
    double wavelength;            /* m */
    char flow[KEY_TEXT_SIZE];     /* table "flows", as of a body */
    double flow_center[3], flow_length, flow_speed; /* m, m, m/s */
    double decay;                 /* 1/s */
};

struct scene_label { /* text over every frame */
    char text[KEY_TEXT_SIZE];
    enum label_place at;
    double size;           /* times the height of other text */
};

/* The camera at one time; between times it moves along smooth curves. */
struct scene_keyframe {
    double time;           /* s, each after the one before */
    double eye[3];         /* m */
    double target[3];      /* m; NAN: camera.target */
    double up[3];          /* NAN: camera.up */
    double fov;            /* degrees; NAN: camera.fov */
};

enum camera_projection { PROJECTION_PERSPECTIVE, PROJECTION_ORTHOGRAPHIC };

struct scene_option { /* a variant's own key, by path */
    char path[KEY_TEXT_SIZE];
    struct scene_place place; /* of its value */
    enum key_type type;
    union {
        bool flag;
        int64_t integer;
        double real, vector[3];
        char text[KEY_TEXT_SIZE];
    } value;
};

struct scene {
    char source[4096];     /* file it came from */
    char title[KEY_TEXT_SIZE];
    double gravity[3];     /* m/s^2 */
    struct { double center[3], frequency; } central_force; /* m, rad/s; 0: none */
    double buoyancy;       /* times the fluids' own */
    double dissipation;    /* of velocity, 1/s */

    struct {
        double min[3], max[3]; /* m */
        enum wall_kind walls[FACE_COUNT];
        double wall_velocity[FACE_COUNT][3]; /* m/s; closed faces, along the face */
        double restitution;    /* normal velocity kept by a bounce, 0..1 */
        bool no_slip;          /* closed walls drag with the fluid's viscosity */
    } domain;

    struct { double spacing; } particles; /* initial distance d of neighbours, m */

    struct scene_fluid *fluids;
    size_t fluid_count;    /* at least 1 */
    struct scene_body *bodies;
    size_t body_count;     /* may be 0 */
    struct scene_obstacle *obstacles;
    size_t obstacle_count; /* 0 .. OBSTACLES_MAX */
    struct scene_measure *measures;
    size_t measure_count;  /* may be 0 */
    struct scene_label *labels;
    size_t label_count;    /* may be 0 */

    struct {
        char method[KEY_TEXT_SIZE];   /* table "solvers" */
        char kernel[KEY_TEXT_SIZE];   /* table "kernels"; "auto": the method's */
        double support;               /* support radius / spacing; NAN: the kernel's */
        double skin;                  /* extra list radius / support radius; NAN: chosen */
    } solver;

    char neighbours[KEY_TEXT_SIZE];   /* table "neighbours"; "auto" */

    struct {
        double end;        /* s */
        double step;       /* upper bound of the time step, s; NAN: chosen */
        double cfl;        /* C1 of the acoustic limit; NAN: the method's */
        double measure;    /* between rows of a csv output, s; NAN: the frame interval */
    } time;

    struct {
        int size[2];       /* pixels */
        double fps;        /* frames per second of film = frames per `speed` seconds of scene */
        double start;      /* first frame, s */
        double speed;      /* scene seconds per film second; 0.5 is slow motion */
        char codec[KEY_TEXT_SIZE];        /* table "codecs"; "auto": by the file */
        double crf;                       /* constant quality; NAN: the codec's */
        char preset[KEY_TEXT_SIZE], tune[KEY_TEXT_SIZE]; /* of the codec; "auto" */
        char pixel_format[KEY_TEXT_SIZE]; /* as libavutil calls it; "auto" */
        char options[KEY_TEXT_SIZE];      /* of the codec: "key=value key=value" */
    } movie;

    struct {
        double eye[3], target[3], up[3]; /* m; eye NAN (auto): frames the domain */
        double fov;                      /* vertical, degrees */
        double orbit_period;             /* s of scene time per turn about `up`; 0: still */
        enum camera_projection projection;
        double height;                   /* orthographic: of the picture, m; NAN: chosen */
    } camera;
    struct scene_keyframe *keyframes; /* of the camera */
    size_t keyframe_count; /* may be 0 */

    struct {
        char by[KEY_TEXT_SIZE];  /* table "colors" */
        char map[KEY_TEXT_SIZE]; /* table "maps"; "auto" */
        char map_file[KEY_TEXT_SIZE]; /* instead of map, beside the scene file; "": none */
        bool reverse;            /* the map from high to low */
        enum color_spread scale;
        int64_t steps;           /* colours; 0: continuous */
        double range[2];         /* NAN: physical estimate; pinned for the film */
        double percentiles[2];   /* of each frame, at the ends of the map; NAN: one range */
        bool legend;             /* colour bar with label and unit */
    } color;

    struct {
        char style[KEY_TEXT_SIZE]; /* spheres, surface */
        double background[3]; /* 0..1 */
        double background_top[3]; /* 0..1; NAN: background */
        bool transparent;
        int64_t samples;      /* of a pixel, in x and in y */
        double outline;       /* rim / radius */
        double occlusion;     /* ambient, 0..1 */
        double shadow;        /* on the floor: light taken, 0..1 */
        double clip_min[3], clip_max[3]; /* m; NAN: no bound */
        double show_range[2]; /* of the colour's quantity; NAN: all */
        double radius;        /* drawn radius / spacing */
        enum box_style box;   /* of the domain */
        enum floor_style floor; /* auto: plain where there is a box */
        bool time, title;     /* time stamp, title */
        bool scale_bar, axes;
        bool boundary;        /* draw static boundary particles */
    } render;

    struct scene_option *options;
    size_t option_count;
};

/* Settings from the command line, applied over the file in order: "key.path=value", the value in
 * JSON or, for text, bare. */
struct scene_overrides {
    const char *const *items;
    const char *const *labels; /* what the user wrote, "--fps 60", for messages; NULL: --set ITEM */
    size_t count;
};

/* Reads and checks a whole scene. On failure (STATUS_USAGE) the message is
 * "FILE:LINE:COL: what is wrong; what to do" and *scene is NULL. Free with scene_free. */
enum status scene_load(struct scene **scene, const char *path, const struct scene_overrides *set,
                       const struct vocabulary *vocabulary, struct error *e);
void scene_free(struct scene *scene);

/* The value of a variant's own key. NAN, false or "" when its variant is not the one chosen (see
 * KEY_OPTION), so that a reader shared by variants can tell. */
double scene_real(const struct scene *scene, const char *path);
bool scene_flag(const struct scene *scene, const char *path);
const char *scene_text(const struct scene *scene, const char *path);

/* The same for KEY_INT (0 when absent) and KEY_VEC3 or KEY_PAIR (NULL when absent). */
int64_t scene_integer(const struct scene *scene, const char *path);
const double *scene_vector(const struct scene *scene, const char *path);

/* Records "FILE:LINE:COL: message" where the file says the option, else "FILE: message". STATUS_USAGE. */
enum status scene_fail(const struct scene *scene, const char *path, struct error *e,
                       const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The same at a place that is known. */
enum status scene_fail_at(const struct scene *scene, struct scene_place place, struct error *e,
                          const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Writes every key with its value in force, as a scene file that loads to the same scene. */
void scene_write(const struct scene *scene, const struct vocabulary *vocabulary, FILE *out);

/* FNV-1a of what scene_write writes: equal for scenes that say the same in other words. */
uint64_t scene_hash(const struct scene *scene, const struct vocabulary *vocabulary);

/* scene_write to a file, by way of PATH.part and rename; "-" is stdout. STATUS_OUTPUT. */
enum status scene_save(const struct scene *scene, const struct vocabulary *vocabulary,
                       const char *path, struct error *e);

/* JSON Schema (draft 2020-12) of scene files; and a table of all keys for a person. */
void scene_write_schema(const struct vocabulary *vocabulary, FILE *out);
void scene_write_keys(const struct vocabulary *vocabulary, FILE *out);

#endif
