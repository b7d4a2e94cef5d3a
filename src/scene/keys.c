/* The table of the scene's own keys: type, default, range, unit, meaning, place in struct scene. */
#include "scene/keys.h"

#include <math.h>
#include <string.h>

#define IN(member) offsetof(struct scene, member)
#define FLUID(member) offsetof(struct scene_fluid, member)
#define BODY(member) offsetof(struct scene_body, member)
#define OBSTACLE(member) offsetof(struct scene_obstacle, member)
#define MEASURE(member) offsetof(struct scene_measure, member)
#define LABEL(member) offsetof(struct scene_label, member)
#define LABEL_PLACES "top-left|top|top-right|bottom-left|bottom|bottom-right"
#define KEYFRAME(member) offsetof(struct scene_keyframe, member)
#define ANY 0, 0           /* no range */
#define FROM(low) low, INFINITY
#define WALLS "closed|particles|periodic"
#define FACE(name, index) \
    {"domain.walls." name, KEY_ENUM, 0, "\"closed\"", ANY, "", WALLS, "wall at the " name " face", \
     IN(domain.walls) + index * sizeof(enum wall_kind)}
#define MOVING(name, index) \
    {"domain.wall_velocity." name, KEY_VEC3, 0, "[0, 0, 0]", ANY, "m/s", NULL, \
     "velocity along itself of the closed wall at the " name " face, which drags (no_slip)", \
     IN(domain.wall_velocity) + index * 3 * sizeof(double)}

#define SHAPED(array, IN_ELEMENT, doc) \
    {array "[].shape", KEY_ENUM, 0, NULL, ANY, "", "box|sphere|cylinder", doc, IN_ELEMENT(shape.kind)}, \
    {array "[].min", KEY_VEC3, 0, NULL, ANY, "m", NULL, "box: lowest corner", IN_ELEMENT(shape.min)}, \
    {array "[].max", KEY_VEC3, 0, NULL, ANY, "m", NULL, "box: highest corner", IN_ELEMENT(shape.max)}, \
    {array "[].center", KEY_VEC3, 0, NULL, ANY, "m", NULL, "sphere, cylinder: its middle", \
     IN_ELEMENT(shape.center)}, \
    {array "[].radius", KEY_REAL, KEY_ABOVE_MIN, NULL, FROM(0), "m", NULL, "sphere, cylinder", \
     IN_ELEMENT(shape.radius)}, \
    {array "[].height", KEY_REAL, KEY_ABOVE_MIN, NULL, FROM(0), "m", NULL, \
     "cylinder: full length along its axis", IN_ELEMENT(shape.height)}, \
    {array "[].axis", KEY_ENUM, 0, "\"y\"", ANY, "", "x|y|z", "cylinder: its axis", \
     IN_ELEMENT(shape.axis)}

/* An enum is stored through an int. */
_Static_assert(sizeof(enum wall_kind) == sizeof(int) && sizeof(enum shape_kind) == sizeof(int) &&
               sizeof(enum body_fill) == sizeof(int) &&
               sizeof(enum body_start) == sizeof(int) && sizeof(enum color_spread) == sizeof(int) &&
               sizeof(enum label_place) == sizeof(int) && sizeof(enum box_style) == sizeof(int) &&
               sizeof(enum floor_style) == sizeof(int) &&
               sizeof(enum camera_projection) == sizeof(int), "enums are ints");

const char *const scene_face_names[FACE_COUNT] = {"-x", "+x", "-y", "+y", "-z", "+z"};

const struct key scene_core_keys[] = {
    {"title", KEY_TEXT, 0, "\"\"", ANY, "", NULL,
     "shown in the film when render.title is true", IN(title)},
    {"gravity", KEY_VEC3, 0, "[0, -9.81, 0]", ANY, "m/s^2", NULL,
     "acceleration of every particle", IN(gravity)},
    {"central_force.center", KEY_VEC3, 0, "[0, 0, 0]", ANY, "m", NULL,
     "the point that the central force pulls to", IN(central_force.center)},
    {"central_force.frequency", KEY_REAL, 0, "0", FROM(0), "rad/s", NULL,
     "Omega of the acceleration -Omega^2 (x - center), not along periodic axes; 0: none",
     IN(central_force.frequency)},
    {"buoyancy", KEY_REAL, 0, "0", FROM(0), "", NULL,
     "b of the acceleration b (rho - rho_mean)/rho g added to each fluid of density rho; rho_mean: "
     "of all fluids together. Fluids float without it by their pressure", IN(buoyancy)},
    {"dissipation", KEY_REAL, 0, "0", FROM(0), "1/s", NULL,
     "rate at which every velocity decays: acceleration -rate v", IN(dissipation)},

    {"domain.min", KEY_VEC3, 0, NULL, ANY, "m", NULL, "lowest corner of the box", IN(domain.min)},
    {"domain.max", KEY_VEC3, 0, NULL, ANY, "m", NULL, "highest corner of the box", IN(domain.max)},
    {"domain.walls", KEY_ENUM, 0, "\"closed\"", ANY, "", WALLS,
     "all faces at once, or an object of faces: a closed plane, boundary particles before one, or "
     "joined to the opposite face", KEY_GROUP},
    FACE("-x", 0), FACE("+x", 1), FACE("-y", 2), FACE("+y", 3), FACE("-z", 4), FACE("+z", 5),
    MOVING("-x", 0), MOVING("+x", 1), MOVING("-y", 2), MOVING("+y", 3), MOVING("-z", 4),
    MOVING("+z", 5),
    {"domain.restitution", KEY_REAL, 0, "0", 0, 1, "", NULL,
     "part of the normal velocity kept by a bounce off a plane", IN(domain.restitution)},
    {"domain.no_slip", KEY_BOOL, 0, "true", 0, 0, "", NULL,
     "closed walls drag with the fluid's viscosity (no slip); false: free slip",
     IN(domain.no_slip)},

    {"particles.spacing", KEY_REAL, KEY_ABOVE_MIN, NULL, FROM(0), "m", NULL,
     "distance of neighbours at the start; halving it takes 8 times the particles",
     IN(particles.spacing)},

    {"fluids[].name", KEY_TEXT, 0, "\"water\"", ANY, "", NULL,
     "what bodies call it; each fluid its own", FLUID(name)},
    {"fluids[].density", KEY_REAL, KEY_ABOVE_MIN, "1000", FROM(0), "kg/m^3", NULL,
     "rest density", FLUID(density)},
    {"fluids[].viscosity", KEY_REAL, 0, "1e-3", FROM(0), "Pa s", NULL,
     "dynamic viscosity", FLUID(viscosity)},
    {"fluids[].surface_tension", KEY_REAL, 0, "0", FROM(0), "N/m", NULL,
     "of its surface; where two fluids meet their tensions add", FLUID(surface_tension)},
    {"fluids[].visible", KEY_BOOL, 0, "true", ANY, "", NULL, "whether it is drawn",
     FLUID(visible)},
    {"fluids[].color", KEY_VEC3, 0, "[0.16, 0.44, 0.80]", 0, 1, "", NULL,
     "red, green, blue for color.by solid", FLUID(color)},

    {"bodies[].fluid", KEY_TEXT, 0, "\"\"", ANY, "", NULL,
     "name of its fluid; empty: the first", BODY(fluid_name)},
    SHAPED("bodies", BODY, "what is filled with particles"),
    {"bodies[].fill", KEY_ENUM, 0, "\"grid\"", ANY, "", "grid|random",
     "particles on a lattice, or at random", BODY(fill)},
    {"bodies[].jitter", KEY_REAL, 0, "0", 0, 0.5, "spacings", NULL,
     "standard deviation of the displacement from the lattice", BODY(jitter)},
    {"bodies[].seed", KEY_INT, 0, "0", FROM(0), "", NULL,
     "another number, another random fill or jitter", BODY(seed)},
    {"bodies[].velocity", KEY_VEC3, 0, "[0, 0, 0]", ANY, "m/s", NULL,
     "at the start", BODY(velocity)},
    {"bodies[].flow", KEY_CHOICE, 0, "\"none\"", ANY, "", "flows",
     "velocity field at the start, added to velocity", BODY(flow)},
    {"bodies[].flow_center", KEY_VEC3, 0, "[0, 0, 0]", ANY, "m", NULL,
     "flow: the point it is laid about", BODY(flow_center)},
    {"bodies[].flow_length", KEY_REAL, KEY_ABOVE_MIN, "1", FROM(0), "m", NULL,
     "flow: its length, as `list flows` says", BODY(flow_length)},
    {"bodies[].flow_speed", KEY_REAL, 0, "1", ANY, "m/s", NULL,
     "flow: its speed, as `list flows` says", BODY(flow_speed)},
    {"bodies[].start", KEY_ENUM, 0, "\"auto\"", ANY, "", "auto|rest|hydrostatic",
     "pressure at the start: none; by the weight of the fluid above (with the flow's); auto: "
     "hydrostatic in a settled tank, else the flow's", BODY(start)},

    SHAPED("obstacles", OBSTACLE, "of a solid that stands still, round which fluid flows"),
    {"obstacles[].color", KEY_VEC3, 0, "[0.62, 0.60, 0.57]", 0, 1, "", NULL, "red, green, blue",
     OBSTACLE(color)},
    {"obstacles[].visible", KEY_BOOL, 0, "true", ANY, "", NULL, "whether it is drawn",
     OBSTACLE(visible)},

    {"measure[].quantity", KEY_CHOICE, 0, NULL, ANY, "", "measures",
     "what the columns of a csv output hold", MEASURE(quantity)},
    {"measure[].name", KEY_TEXT, 0, "\"\"", ANY, "", NULL,
     "begins the names of its columns, each its own; empty: the quantity", MEASURE(name)},

    {"labels[].text", KEY_TEXT, 0, NULL, ANY, "", NULL, "written over every frame", LABEL(text)},
    {"labels[].at", KEY_ENUM, 0, "\"top-right\"", ANY, "", LABEL_PLACES,
     "its place; labels that meet stack up", LABEL(at)},
    {"labels[].size", KEY_REAL, KEY_ABOVE_MIN, "1", 0, 10, "", NULL,
     "times the height of other text", LABEL(size)},

    {"solver.method", KEY_CHOICE, 0, "\"isph\"", ANY, "", "solvers",
     "pressure solver", IN(solver.method)},
    {"solver.kernel", KEY_CHOICE, KEY_AUTO, "\"auto\"", ANY, "", "kernels",
     "smoothing kernel; auto: the method's", IN(solver.kernel)},
    {"solver.support", KEY_REAL, KEY_AUTO, "\"auto\"", 1, 6, "spacings", NULL,
     "support radius of the kernel; auto: the kernel's", IN(solver.support)},
    {"solver.skin", KEY_REAL, KEY_AUTO, "\"auto\"", 0, 1, "supports", NULL,
     "extra radius of neighbour lists, so that steps share them; auto: what is fastest",
     IN(solver.skin)},
    {"neighbours", KEY_CHOICE, KEY_AUTO, "\"auto\"", ANY, "", "neighbours",
     "neighbour search; all give the same bits", IN(neighbours)},

    {"time.end", KEY_REAL, 0, NULL, FROM(0), "s", NULL, "the run ends here", IN(time.end)},
    {"time.step", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", FROM(0), "s", NULL,
     "upper bound of the time step; auto: what is stable", IN(time.step)},
    {"time.cfl", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", 0, 10, "", NULL,
     "support radii that sound travels in a step at most; auto: the method's", IN(time.cfl)},
    {"time.measure", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", FROM(0), "s", NULL,
     "between rows of a csv output, from 0 on; auto: the time between frames", IN(time.measure)},

    {"movie.size", KEY_SIZE, 0, "[1280, 720]", 16, 16384, "pixels", NULL,
     "width and height", IN(movie.size)},
    {"movie.fps", KEY_REAL, KEY_ABOVE_MIN, "30", 0, 1000, "1/s", NULL,
     "frames per second of film", IN(movie.fps)},
    {"movie.start", KEY_REAL, 0, "0", FROM(0), "s", NULL, "scene time of the first frame",
     IN(movie.start)},
    {"movie.speed", KEY_REAL, KEY_ABOVE_MIN, "1", FROM(0), "", NULL,
     "scene seconds per second of film; 0.5 is slow motion", IN(movie.speed)},
    {"movie.codec", KEY_CHOICE, KEY_AUTO, "\"auto\"", ANY, "", "codecs",
     "how mp4, webm and mkv are compressed; auto: h264, in webm vp9, never a GPU's", IN(movie.codec)},
    {"movie.crf", KEY_REAL, KEY_AUTO, "\"auto\"", 0, 63, "", NULL,
     "constant quality of the codec, lower is better; auto: 18 to 28, by codec", IN(movie.crf)},
    {"movie.preset", KEY_TEXT, 0, "\"auto\"", ANY, "", NULL,
     "how hard the codec tries, in its words: veryslow, or 4", IN(movie.preset)},
    {"movie.tune", KEY_TEXT, 0, "\"auto\"", ANY, "", NULL,
     "what the codec is tuned for, in its words: animation, grain", IN(movie.tune)},
    {"movie.pixel_format", KEY_TEXT, 0, "\"auto\"", ANY, "", NULL,
     "of mp4, webm, mkv and y4m: yuv420p, yuv444p, yuv420p10le ... as the codec has it; auto: "
     "yuv420p", IN(movie.pixel_format)},
    {"movie.options", KEY_TEXT, 0, "\"\"", ANY, "", NULL,
     "further options of the codec: \"key=value key=value\"", IN(movie.options)},

    {"camera.eye", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "m", NULL,
     "where the camera is; auto: frames the domain", IN(camera.eye)},
    {"camera.target", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "m", NULL,
     "what it looks at; auto: middle of the domain", IN(camera.target)},
    {"camera.up", KEY_VEC3, 0, "[0, 1, 0]", ANY, "", NULL, "direction that is up in the picture",
     IN(camera.up)},
    {"camera.fov", KEY_REAL, 0, "35", 1, 150, "degrees", NULL, "vertical angle of view",
     IN(camera.fov)},
    {"camera.orbit_period", KEY_REAL, 0, "0", ANY, "s", NULL,
     "scene time of a turn about up; 0: still", IN(camera.orbit_period)},
    {"camera.projection", KEY_ENUM, 0, "\"perspective\"", ANY, "", "perspective|orthographic",
     "orthographic: nothing gets smaller with distance, so that lengths can be measured",
     IN(camera.projection)},
    {"camera.height", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", FROM(0), "m", NULL,
     "orthographic: height of the picture; auto: frames the domain, or with an eye what fov shows at "
     "the target", IN(camera.height)},
    {"camera.keyframes[].time", KEY_REAL, 0, NULL, FROM(0), "s", NULL,
     "scene time at which the camera is here; between, before and after: on a curve, first, last",
     KEYFRAME(time)},
    {"camera.keyframes[].eye", KEY_VEC3, 0, NULL, ANY, "m", NULL, "where the camera is",
     KEYFRAME(eye)},
    {"camera.keyframes[].target", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "m", NULL,
     "what it looks at; auto: camera.target", KEYFRAME(target)},
    {"camera.keyframes[].up", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "", NULL,
     "direction that is up in the picture; auto: camera.up", KEYFRAME(up)},
    {"camera.keyframes[].fov", KEY_REAL, KEY_AUTO, "\"auto\"", 1, 150, "degrees", NULL,
     "vertical angle of view; auto: camera.fov", KEYFRAME(fov)},

    {"color.by", KEY_CHOICE, 0, "\"velocity\"", ANY, "", "colors", "quantity shown", IN(color.by)},
    {"color.map", KEY_CHOICE, KEY_AUTO, "\"auto\"", ANY, "", "maps",
     "colour map; auto: viridis, or coolwarm where the scale is symmetric", IN(color.map)},
    {"color.map_file", KEY_TEXT, 0, "\"\"", ANY, "", NULL,
     "own colour map instead, beside the scene file: 2 to 256 lines of red green blue, 0 to 1 or 0 "
     "to 255, or #rrggbb, from low to high", IN(color.map_file)},
    {"color.reverse", KEY_BOOL, 0, "false", ANY, "", NULL, "the map from high to low",
     IN(color.reverse)},
    {"color.scale", KEY_ENUM, 0, "\"auto\"", ANY, "", "auto|linear|log|symmetric",
     "how values spread over the map; symmetric: linear, zero in the middle; auto: symmetric where "
     "color.by has a sign, else linear", IN(color.scale)},
    {"color.steps", KEY_INT, 0, "0", 0, 256, "", NULL,
     "equal parts of the scale, a colour each; 0: continuous", IN(color.steps)},
    {"color.range", KEY_PAIR, KEY_AUTO, "\"auto\"", ANY, "of color.by", NULL,
     "values at the ends of the map, for the whole film; auto: a physical estimate",
     IN(color.range)},
    {"color.percentiles", KEY_PAIR, KEY_AUTO, "\"auto\"", 0, 100, "%", NULL,
     "of each frame's particles, at the ends of the map: the range changes from frame to frame; "
     "auto: one range for the whole film", IN(color.percentiles)},
    {"color.legend", KEY_BOOL, 0, "true", ANY, "", NULL, "colour bar with label and unit",
     IN(color.legend)},

    {"render.style", KEY_CHOICE, 0, "\"spheres\"", ANY, "", "spheres|surface",
     "particles as spheres, or the fluid's surface (renderer cpu)", IN(render.style)},
    {"render.background", KEY_VEC3, 0, "[0.96, 0.97, 0.98]", 0, 1, "", NULL, "red, green, blue",
     IN(render.background)},
    {"render.background_top", KEY_VEC3, KEY_AUTO, "\"auto\"", 0, 1, "", NULL,
     "of the upper edge, fading downwards; auto: render.background", IN(render.background_top)},
    {"render.transparent", KEY_BOOL, 0, "false", ANY, "", NULL,
     "no background: pictures with alpha", IN(render.transparent)},
    {"render.samples", KEY_INT, 0, "2", 1, 4, "", NULL,
     "samples of a pixel, in x and in y", IN(render.samples)},
    {"render.outline", KEY_REAL, 0, "0", 0, 1, "radii", NULL,
     "dark rim of a particle", IN(render.outline)},
    {"render.occlusion", KEY_REAL, 0, "0", 0, 1, "", NULL,
     "how much darker particles are that others surround (renderer cpu)", IN(render.occlusion)},
    {"render.shadow", KEY_REAL, 0, "0", 0, 1, "", NULL,
     "how much light the fluid's soft shadow takes from the floor", IN(render.shadow)},
    {"render.clip_min", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "m", NULL,
     "particles outside clip_min to clip_max are not drawn; auto: no bound", IN(render.clip_min)},
    {"render.clip_max", KEY_VEC3, KEY_AUTO, "\"auto\"", ANY, "m", NULL, "see clip_min",
     IN(render.clip_max)},
    {"render.show_range", KEY_PAIR, KEY_AUTO, "\"auto\"", ANY, "of color.by", NULL,
     "particles with other values are not drawn; auto: all are", IN(render.show_range)},
    {"render.radius", KEY_REAL, KEY_ABOVE_MIN, "0.5", 0, 4, "spacings", NULL,
     "radius of a drawn particle", IN(render.radius)},
    {"render.box", KEY_ENUM, KEY_SWITCH, "\"lines\"", ANY, "", "none|lines|faces",
     "the domain: its edges, and its faces behind the fluid; true is lines, false none", IN(render.box)},
    {"render.floor", KEY_ENUM, 0, "\"auto\"", ANY, "", "auto|none|plain|grid|checker",
     "of the domain, where gravity points to; squares of 1, 2 or 5 times a power of ten m; auto: plain "
     "where there is a box", IN(render.floor)},
    {"render.time", KEY_BOOL, 0, "true", ANY, "", NULL, "time stamp", IN(render.time)},
    {"render.title", KEY_BOOL, 0, "true", ANY, "", NULL, "title", IN(render.title)},
    {"render.scale_bar", KEY_BOOL, 0, "false", ANY, "", NULL,
     "a length, true at the distance of the camera's target", IN(render.scale_bar)},
    {"render.axes", KEY_BOOL, 0, "false", ANY, "", NULL, "directions of x, y and z",
     IN(render.axes)},
    {"render.boundary", KEY_BOOL, 0, "false", ANY, "", NULL, "boundary particles too",
     IN(render.boundary)},
};
const size_t scene_core_key_count = sizeof scene_core_keys / sizeof *scene_core_keys;

const struct key_array scene_arrays[ARRAY_COUNT] = {
    {"fluids", "fluids[].", IN(fluids), IN(fluid_count), sizeof(struct scene_fluid), KEY_SHAPELESS},
    {"bodies", "bodies[].", IN(bodies), IN(body_count), sizeof(struct scene_body), BODY(shape)},
    {"obstacles", "obstacles[].", IN(obstacles), IN(obstacle_count), sizeof(struct scene_obstacle),
     OBSTACLE(shape)},
    {"measure", "measure[].", IN(measures), IN(measure_count), sizeof(struct scene_measure),
     KEY_SHAPELESS},
    {"labels", "labels[].", IN(labels), IN(label_count), sizeof(struct scene_label), KEY_SHAPELESS},
    {"camera.keyframes", "camera.keyframes[].", IN(keyframes), IN(keyframe_count),
     sizeof(struct scene_keyframe), KEY_SHAPELESS},
};

enum { BOX = 1 << SHAPE_BOX, SPHERE = 1 << SHAPE_SPHERE, CYLINDER = 1 << SHAPE_CYLINDER };
static const struct { const char *name; unsigned shapes; } shaped[] = {
    {"min", BOX},
    {"max", BOX},
    {"center", SPHERE | CYLINDER},
    {"radius", SPHERE | CYLINDER},
    {"height", CYLINDER},
    {"axis", CYLINDER},
};

/* Whether the key belongs to the elements of the array, and they have a shape. */
static bool in_shaped_array(const struct key *key, const struct key_array *array)
{
    return array->shape != KEY_SHAPELESS &&
           strncmp(key->path, array->prefix, strlen(array->prefix)) == 0;
}

static unsigned shapes_of(const struct key *key)
{
    for (int a = 0; a < ARRAY_COUNT; a++)
        for (size_t i = 0; i < sizeof shaped / sizeof *shaped && in_shaped_array(key, &scene_arrays[a]); i++)
            if (strcmp(shaped[i].name, key->path + strlen(scene_arrays[a].prefix)) == 0)
                return shaped[i].shapes;
    return BOX | SPHERE | CYLINDER;
}

bool key_fits_shape(const struct key *key, enum shape_kind shape)
{
    return shapes_of(key) >> shape & 1;
}

bool key_is_shaped(const struct key *key)
{
    return shapes_of(key) != (BOX | SPHERE | CYLINDER);
}

bool key_fits_element(const struct key *key, const struct key_array *array, const void *element)
{
    const struct shape *shape = (const void *)((const char *)element + array->shape);
    return array->shape == KEY_SHAPELESS || key_fits_shape(key, shape->kind);
}
