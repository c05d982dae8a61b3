/* Griffith from C: brittle fracture in real time.
 *
 * A scene is a value that describes bodies, materials, supports, loads and shots. A world is a simulation of a
 * scene. Each step of a world gives a frame: arrays of nodes, tetrahedra, bodies, cracks and contacts, which this
 * interface exposes without copies.
 *
 *     griffith_error error;
 *     griffith_scene* scene;
 *     griffith_world* world;
 *     if (griffith_scene_read("wall.json", &scene, &error) != GRIFFITH_OK ||
 *         griffith_world_create(scene, NULL, &world, &error) != GRIFFITH_OK ||
 *         griffith_world_step(world, 60, &error) != GRIFFITH_OK)
 *       fprintf(stderr, "%s: %s (%s)\n", error.where, error.problem, error.remedy);
 *
 * Units     SI throughout: m, kg, s, N, Pa, J. Angles are in radians.
 * Text      UTF-8, zero-terminated.
 * Errors    A function that can fail returns a status and fills `error` unless it is null. It then leaves its arguments
 *           unchanged. No C++ exception leaves the library.
 * Ownership Objects returned through a `**` belong to the caller, who passes them to the matching `_destroy` or
 *           `_free`, which accept null. Everything else belongs to the object from which it came.
 * Threads   Any number of scenes and worlds may exist. Each may be used by one thread at a time,
 *           different ones concurrently. Results do not depend on the number of threads.
 */
#ifndef GRIFFITH_GRIFFITH_H
#define GRIFFITH_GRIFFITH_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GRIFFITH_API __attribute__((visibility("default")))
#else
#define GRIFFITH_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- Version ------------------------------------------------------------------------------------------------------ */

/* Version of the binary interface that this header describes. Structs grow and enumerations gain members only with it.
 */
#define GRIFFITH_ABI_VERSION 1

/* Returns GRIFFITH_ABI_VERSION of the library, to compare with that of the header. */
GRIFFITH_API uint32_t griffith_abi_version(void);
/* Returns the version of the program, such as "0.1.0". */
GRIFFITH_API const char* griffith_version(void);

/* --- Errors ------------------------------------------------------------------------------------------------------- */

typedef enum griffith_status {
  GRIFFITH_OK = 0,
  GRIFFITH_INVALID_ARGUMENT = 1, /* a null, an index out of range, an unknown name */
  GRIFFITH_INPUT_ERROR = 2,      /* a scene, file or value that cannot be used; the error names the place */
  GRIFFITH_CANCELLED = 3,        /* by the monitor */
  GRIFFITH_OUT_OF_MEMORY = 4,
  GRIFFITH_INTERNAL_ERROR = 5 /* a bug of the library: please report it */
} griffith_status;

/* Place and reason of a failure. Longer texts are truncated and end with "…". */
typedef struct griffith_error {
  int32_t status;     /* a griffith_status */
  char where[512];    /* the place: a file, file:line, file#/json/pointer, or the argument */
  char problem[1024]; /* description of the error */
  char remedy[512];   /* correction; may be empty */
} griffith_error;

/* Returns the name of a status: "input error". Never null. */
GRIFFITH_API const char* griffith_status_name(int32_t status);

/* --- Scenes ------------------------------------------------------------------------------------------------------- */

/* A description of bodies, materials, supports, loads, shots and settings; scenes/README.md describes its format. */
typedef struct griffith_scene griffith_scene;

/* Reads a scene file. */
GRIFFITH_API griffith_status griffith_scene_read(const char* path, griffith_scene** scene, griffith_error* error);
/* Reads a scene from JSON text. Relative paths in it start at `folder`; null: the current one. */
GRIFFITH_API griffith_status griffith_scene_parse(const char* json, const char* folder, griffith_scene** scene,
                                                  griffith_error* error);
/* Copies a scene with its meshes. */
GRIFFITH_API griffith_status griffith_scene_copy(const griffith_scene* scene, griffith_scene** copy,
                                                 griffith_error* error);
GRIFFITH_API void griffith_scene_destroy(griffith_scene* scene);

/* Sets the field at a JSON pointer (RFC 6901), "/bodies/0/material/young_modulus", to a value in JSON:
 * "3e10", "\"granite\"", "[0, 1, 0]". The scene stays unchanged if the result would be invalid. */
GRIFFITH_API griffith_status griffith_scene_set(griffith_scene* scene, const char* pointer, const char* json,
                                                griffith_error* error);
/* Returns the value at a JSON pointer as JSON text, defaults included; "" is the whole scene. Pass it to
 * griffith_string_free(). */
GRIFFITH_API griffith_status griffith_scene_get(const griffith_scene* scene, const char* pointer, char** json,
                                                griffith_error* error);
/* Adds a mesh under the name of a file: a body whose shape is {"mesh": {"path": name}} has these tetrahedra.
 *   points  3 coordinates per point [m]
 *   tets    4 indices of points per tetrahedron, in either orientation
 * Both are copied. A mesh of the same name is replaced. */
GRIFFITH_API griffith_status griffith_scene_set_mesh(griffith_scene* scene, const char* name, const double* points,
                                                     int64_t point_count, const int32_t* tets, int64_t tet_count,
                                                     griffith_error* error);
GRIFFITH_API void griffith_string_free(char* text);

/* --- Worlds ------------------------------------------------------------------------------------------------------- */

/* A simulation of a scene. */
typedef struct griffith_world griffith_world;

/* Callbacks of long work. Either function may be null. */
typedef struct griffith_monitor {
  void (*stage)(const char* name, void* context); /* called as each stage of the work begins: "Refining mesh" */
  int32_t (*cancelled)(void* context);            /* not 0: cancel. Called from any thread */
  void* context;
} griffith_monitor;

/* Builds meshes and bodies. `monitor` may be null. The world does not refer to the scene afterwards. */
GRIFFITH_API griffith_status griffith_world_create(const griffith_scene* scene, const griffith_monitor* monitor,
                                                   griffith_world** world, griffith_error* error);
/* Copies a world between two steps, as a snapshot or a branch. Both continue identically, to the bit. A copy is not
 * recorded. */
GRIFFITH_API griffith_status griffith_world_copy(const griffith_world* world, griffith_world** copy,
                                                 griffith_error* error);
/* Restores the state of a copy, which stays unchanged. Ends a recording of the world. */
GRIFFITH_API griffith_status griffith_world_restore(griffith_world* world, const griffith_world* copy,
                                                    griffith_error* error);
GRIFFITH_API void griffith_world_destroy(griffith_world* world);

/* Advances by `count` (0 to 1,000,000) time steps of the scene. Earlier arrays become invalid. */
GRIFFITH_API griffith_status griffith_world_step(griffith_world* world, int32_t count, griffith_error* error);

/* A sphere that is launched immediately. */
typedef struct griffith_shot {
  double position[3];  /* center [m], -1e6 to 1e6 */
  double direction[3]; /* flight direction, not zero, -1e6 to 1e6 */
  double speed;        /* [m/s], 0 to 1e5 */
  double mass;         /* [kg], 1e-6 to 1e9 */
  double radius;       /* [m], 1e-4 to 1e4 */
} griffith_shot;

GRIFFITH_API griffith_status griffith_world_fire(griffith_world* world, const griffith_shot* shot,
                                                 griffith_error* error);
/* Fires an entry of a scene's "projectiles", such as {"speed": 20, "count": 3}; its start is relative to the current
 * time. */
GRIFFITH_API griffith_status griffith_world_fire_json(griffith_world* world, const char* json, griffith_error* error);
/* Pushes the material at a position [m], or the point of the surface nearest to it, with an impulse [N·s]. It acts as a
 * constant force in the next time step; the piece may deform and break. */
GRIFFITH_API griffith_status griffith_world_push(griffith_world* world, const double position[3],
                                                 const double impulse[3], griffith_error* error);

/* A spring with a damper. All of it is relative to the piece that it pulls, so that pieces of any mass follow alike. */
typedef struct griffith_spring {
  double frequency;     /* frequency of the piece on the spring [Hz], 0.01 to 100 */
  double damping_ratio; /* 0 to 10 */
  double strength;      /* greatest force, in weights of the piece, 0.01 to 1e6 */
} griffith_spring;

/* Grabs the material at a position [m], or the point of the surface nearest to it, in place of what is held: a spring
 * pulls it to the target [m]. Null `spring`: that of the editor, {3, 0.7, 10}. */
GRIFFITH_API griffith_status griffith_world_grab(griffith_world* world, const double position[3],
                                                 const double target[3], const griffith_spring* spring,
                                                 griffith_error* error);
/* Moves the target of the grab [m]. */
GRIFFITH_API griffith_status griffith_world_move_grab(griffith_world* world, const double target[3],
                                                      griffith_error* error);
/* Ends the grab, if there is one. */
GRIFFITH_API griffith_status griffith_world_release(griffith_world* world, griffith_error* error);

/* Changes a field of the material of a scene's body in the running world: "young_modulus", "3e10". The pieces of the
 * body keep their velocities. */
GRIFFITH_API griffith_status griffith_world_set_material(griffith_world* world, int32_t scene_body, const char* field,
                                                         const char* json, griffith_error* error);

/* Returns the hash of all positions, velocities and topology; 0 for null. Equal states have equal hashes, as in
 * `griffith simulate --stats`. */
GRIFFITH_API uint64_t griffith_world_state_hash(const griffith_world* world);

/* Starts to record shots, pushes, grabs, changes of material and hashes; call it before the first step. */
GRIFFITH_API griffith_status griffith_world_start_recording(griffith_world* world, griffith_error* error);
/* Writes the recording, for `griffith replay`, `griffith render` and bug reports. */
GRIFFITH_API griffith_status griffith_world_save_recording(const griffith_world* world, const char* path,
                                                           griffith_error* error);

/* Limit on the threads of all worlds, as long as it exists. Results do not depend on it. */
typedef struct griffith_thread_limit griffith_thread_limit;
GRIFFITH_API griffith_status griffith_thread_limit_create(int32_t threads, griffith_thread_limit** limit,
                                                          griffith_error* error);
GRIFFITH_API void griffith_thread_limit_destroy(griffith_thread_limit* limit);

/* --- Numbers of a frame ------------------------------------------------------------------------------------------- */

/* Describes a number of a frame. */
typedef struct griffith_value_info {
  const char* name;    /* "kinetic_energy" */
  const char* unit;    /* "J"; "" for counts and ratios */
  const char* meaning; /* a sentence */
} griffith_value_info;

/* Returns the number of numbers of a frame: time, sums, the energy account and the counters of the last step. */
GRIFFITH_API int32_t griffith_value_count(void);
/* Describes number `index`; null outside 0..griffith_value_count() - 1. */
GRIFFITH_API const griffith_value_info* griffith_value_describe(int32_t index);
/* Reads a number by its name. */
GRIFFITH_API griffith_status griffith_world_value(const griffith_world* world, const char* name, double* value,
                                                  griffith_error* error);

/* --- Arrays of a frame -------------------------------------------------------------------------------------------- */

typedef enum griffith_type {
  GRIFFITH_FLOAT64 = 0,
  GRIFFITH_FLOAT32 = 1,
  GRIFFITH_INT64 = 2,
  GRIFFITH_INT32 = 3,
  GRIFFITH_UINT8 = 4 /* 1: true, 0: false, or bits */
} griffith_type;

/* Arrays, grouped by the object of an entry. griffith_array_describe() gives their units and meanings. Indices of
 * nodes, tets and bodies are stable: nodes and bodies are only ever appended. -1 is none. */
typedef enum griffith_array_id {
  /* Per node. */
  GRIFFITH_NODE_POSITIONS = 0,      /* float64[3], m */
  GRIFFITH_NODE_REST_POSITIONS,     /* float64[3], m */
  GRIFFITH_NODE_VELOCITIES,         /* float64[3], m/s */
  GRIFFITH_NODE_MASSES,             /* float64, kg */
  GRIFFITH_NODE_UTILIZATION,        /* float64, load over resistance; the node separates above 1 */
  GRIFFITH_NODE_SEPARATION_TENSORS, /* float64[3][3], N, symmetric */
  GRIFFITH_NODE_SEPARATION_NORMALS, /* float64[3], unit normal of the plane across which the node would separate */
  GRIFFITH_NODE_SEPARATION_STRESS,  /* float64, Pa */
  GRIFFITH_NODE_RESISTANCE,         /* float64, Pa, or N with the force criterion */
  GRIFFITH_NODE_REACTIONS,          /* float64[3], N, of supports */
  GRIFFITH_NODE_HAS_SUPPORT,        /* uint8 */
  GRIFFITH_NODE_AT_CRACK_FRONT,     /* uint8 */
  /* Per tetrahedron. */
  GRIFFITH_TET_NODES,     /* int32[4] */
  GRIFFITH_TET_NEIGHBORS, /* int32[4], the tetrahedron beyond the face opposite each node; -1 on the surface */
  GRIFFITH_TET_BODIES,    /* int32 */
  GRIFFITH_TET_STRESS,    /* float64[3][3], Pa, Cauchy stress, symmetric */
  /* Per body: a connected piece. */
  GRIFFITH_BODY_POSITIONS,          /* float64[3], m, of the center of mass */
  GRIFFITH_BODY_ORIENTATIONS,       /* float64[4], unit quaternion x, y, z, w, relative to its initial shape */
  GRIFFITH_BODY_VELOCITIES,         /* float64[3], m/s */
  GRIFFITH_BODY_ANGULAR_VELOCITIES, /* float64[3], rad/s */
  GRIFFITH_BODY_MASSES,             /* float64, kg */
  GRIFFITH_BODY_PARENTS,            /* int32, the body from which it broke off; -1 for an original */
  GRIFFITH_BODY_SCENE_BODIES,       /* int32, index into the scene's bodies */
  GRIFFITH_BODY_IS_RIGID,           /* uint8 */
  GRIFFITH_BODY_IS_ASLEEP,          /* uint8 */
  GRIFFITH_BODY_IS_SUPPORTED,       /* uint8 */
  /* Per crack event: a node that separated, oldest first. */
  GRIFFITH_CRACK_STEPS,      /* int64 */
  GRIFFITH_CRACK_TIMES,      /* float64, s */
  GRIFFITH_CRACK_NODES,      /* int32 */
  GRIFFITH_CRACK_BODIES,     /* int32 */
  GRIFFITH_CRACK_POSITIONS,  /* float64[3], m */
  GRIFFITH_CRACK_NORMALS,    /* float64[3], unit normal of the plane */
  GRIFFITH_CRACK_LOADS,      /* float64, Pa or N */
  GRIFFITH_CRACK_RESISTANCE, /* float64, Pa or N */
  /* Per contact of the last step that carried an impulse. */
  GRIFFITH_CONTACT_BODIES_A,  /* int32; -1: a projectile or the ground */
  GRIFFITH_CONTACT_BODIES_B,  /* int32 */
  GRIFFITH_CONTACT_POSITIONS, /* float64[3], m */
  GRIFFITH_CONTACT_NORMALS,   /* float64[3], unit, from b to a */
  GRIFFITH_CONTACT_IMPULSES,  /* float64[3], N s, on a */
  /* Per projectile. */
  GRIFFITH_PROJECTILE_POSITIONS,  /* float64[3], m */
  GRIFFITH_PROJECTILE_VELOCITIES, /* float64[3], m/s */
  GRIFFITH_PROJECTILE_ROTATIONS,  /* float64[4], unit quaternion x, y, z, w */
  GRIFFITH_PROJECTILE_RADII,      /* float64, m */
  GRIFFITH_PROJECTILE_MASSES,     /* float64, kg */
  /* Surfaces to draw, after griffith_world_update_surfaces(). */
  GRIFFITH_SURFACE_POSITIONS,       /* float32[3], m, per vertex in the frame of its piece */
  GRIFFITH_SURFACE_NORMALS,         /* float32[3], unit, per vertex in the frame of its piece */
  GRIFFITH_SURFACE_TRIANGLES,       /* int32[3], counted from the piece's first vertex, counterclockwise from outside */
  GRIFFITH_SURFACE_IS_CRACK,        /* uint8, 1 for a crack face, per triangle */
  GRIFFITH_SURFACE_FIRST_VERTICES,  /* int32, per body */
  GRIFFITH_SURFACE_VERTEX_COUNTS,   /* int32, per body */
  GRIFFITH_SURFACE_FIRST_TRIANGLES, /* int32, per body */
  GRIFFITH_SURFACE_TRIANGLE_COUNTS, /* int32, per body */
  GRIFFITH_SURFACE_VERSIONS,        /* int32, per body: grows with each change of its vertices; 0: nothing to draw */
  GRIFFITH_ARRAY_COUNT
} griffith_array_id;

/* Describes an array of a frame. */
typedef struct griffith_array_info {
  const char* name;    /* "node_positions" */
  const char* unit;    /* "m"; "" for indices and ratios */
  const char* meaning; /* a sentence */
} griffith_array_info;

/* Describes an array; null outside 0..GRIFFITH_ARRAY_COUNT - 1. */
GRIFFITH_API const griffith_array_info* griffith_array_describe(int32_t array);

/* A view of the library's own memory, valid until the next call that changes the world. Entry i begins at
 * (const char*)data + i * stride. */
typedef struct griffith_array {
  const void* data;   /* may be null if count is 0 */
  int64_t count;      /* entries */
  int64_t stride;     /* bytes from one entry to the next */
  int32_t type;       /* a griffith_type */
  int32_t dimensions; /* rank of an entry: 0 a number, 1 a vector, 2 a matrix */
  int32_t shape[2];   /* lengths of these dimensions, else 1 */
} griffith_array;

/* Returns a view of an array. */
GRIFFITH_API griffith_status griffith_world_array(const griffith_world* world, int32_t array, griffith_array* view,
                                                  griffith_error* error);

/* Updates the surfaces to draw: outside and crack faces of each body, or its splinters if it has any, in the body's own
 * frame. To draw a vertex, rotate it by the body's orientation and add its position. Vertices of a piece change when it
 * cracks or deforms, and its version changes with them. Earlier views of surfaces become invalid. */
GRIFFITH_API griffith_status griffith_world_update_surfaces(griffith_world* world, griffith_error* error);

/* --- Quantities of a frame ------------------------------------------------------------------------------------------
 */

/* Returns the number of quantities: what `griffith simulate --export` writes, computed from the arrays of a frame. */
GRIFFITH_API int32_t griffith_quantity_count(void);
/* Describes quantity `index`; null outside 0..griffith_quantity_count() - 1. */
GRIFFITH_API const griffith_value_info* griffith_quantity_describe(int32_t index);
/* Computes a quantity by its name: "von_mises". One entry per node or tet: float64, float64[3] or float64[3][3]; valid
 * until the next one of this world. */
GRIFFITH_API griffith_status griffith_world_quantity(griffith_world* world, const char* name, griffith_array* view,
                                                     griffith_error* error);

/* --- Pictures ----------------------------------------------------------------------------------------------------- */

/* Renderer of pictures of a world through EGL, without a window, as in `griffith render`. Use it in the thread that
 * made it. */
typedef struct griffith_painter griffith_painter;

/* Prepares pictures of `width` by `height` pixels (16 to 8192) of a world before any fracture.
 *   camera  a camera of the scene; null or "": the first
 *   view    a view as for `griffith render --view`, "utilization+fracture_planes"; null or "": the scene's
 * Fails if the library was built without the renderer, or without a graphics driver. */
GRIFFITH_API griffith_status griffith_painter_create(const griffith_world* world, int32_t width, int32_t height,
                                                     const char* camera, const char* view, griffith_painter** painter,
                                                     griffith_error* error);
/* Draws the current state of the painter's world or a copy of it. Returns the pixels: one entry per
 * row, from the top, uint8[width][4], red, green, blue and opacity; valid until the painter's next call. */
GRIFFITH_API griffith_status griffith_painter_paint(griffith_painter* painter, const griffith_world* world,
                                                    griffith_array* pixels, griffith_error* error);
GRIFFITH_API void griffith_painter_destroy(griffith_painter* painter);

#ifdef __cplusplus
}
#endif

#endif
