/* An engine as a shared library, judged by graze. Plain C11; every function is optional, and found by its name.
 *
 *   graze certify --engine "graze_engine_host libmine.so"
 *
 * graze_engine_host opens the library and speaks the protocol of docs/reference/protocol.md for it, in a process of its own.
 *
 * Frames: positions, displacements, normals and witnesses are in world axes, shapes in their body's own; quaternions are
 * w, x, y, z. Units: lengths in the question's, angles in radians, times in the question's unit of t.
 * Pointers of a question are valid until the call returns; those that graze_engine_begin saw until graze_engine_end. */
#ifndef GRAZE_ENGINE_H
#define GRAZE_ENGINE_H

#include <stddef.h>

#if defined(_WIN32)
#define GRAZE_ENGINE_EXPORT __declspec(dllexport)
#else
#define GRAZE_ENGINE_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum graze_engine_shape_type {
  GRAZE_ENGINE_POINT,
  GRAZE_ENGINE_SEGMENT,   /* vertices: a, b */
  GRAZE_ENGINE_TRIANGLE,  /* vertices: a, b, c */
  GRAZE_ENGINE_SPHERE,    /* radius */
  GRAZE_ENGINE_CAPSULE,   /* radius, half_height of the core segment, along z */
  GRAZE_ENGINE_CYLINDER,  /* radius, half_height, along z */
  GRAZE_ENGINE_CONE,      /* radius, half_height, along z, the apex at +half_height */
  GRAZE_ENGINE_BOX,       /* half_extents */
  GRAZE_ENGINE_ELLIPSOID, /* radii */
  GRAZE_ENGINE_HULL,      /* vertices, in any order */
  GRAZE_ENGINE_POSED,     /* parts[0] at position and orientation */
  GRAZE_ENGINE_ROUNDED,   /* parts[0] rounded by radius */
  GRAZE_ENGINE_SUM,       /* Minkowski sum of parts */
  GRAZE_ENGINE_HULL_OF    /* hull of the union of parts */
} graze_engine_shape_type;

typedef struct graze_engine_shape {
  graze_engine_shape_type type;
  double radius, half_height;
  double half_extents[3];
  double radii[3];
  const double* vertices; /* three numbers each */
  size_t vertex_count;
  double position[3], orientation[4];
  const struct graze_engine_shape* parts;
  size_t part_count;
} graze_engine_shape;

typedef struct graze_engine_body {
  graze_engine_shape shape;
  double position[3], orientation[4]; /* at t = 0 */
  double displacement[3];             /* over one unit of t */
  double rotation[3];                 /* rotation vector over one unit of t; of a rotating cast */
  double pivot[3]; /* centre of the rotation, in the body's own frame; of a rotating cast */
} graze_engine_body;

typedef enum graze_engine_query {
  GRAZE_ENGINE_CAST,
  GRAZE_ENGINE_ROTATING_CAST,
  GRAZE_ENGINE_RAY,
  GRAZE_ENGINE_OVERLAP,
  GRAZE_ENGINE_DISTANCE,
  GRAZE_ENGINE_PENETRATION
} graze_engine_query;

typedef struct graze_engine_question {
  graze_engine_query query;
  graze_engine_body a, b;         /* of a ray b is not there */
  double origin[3], direction[3]; /* of a ray: origin + t direction */
  double t_max;                   /* of casts and rays; may be infinite if the engine takes that */
  double target_distance;         /* of casts */
  int pass_over;                  /* of casts: the start policy */
} graze_engine_question;

typedef enum graze_engine_outcome {
  GRAZE_ENGINE_UNSUPPORTED,
  GRAZE_ENGINE_HIT,
  GRAZE_ENGINE_INITIALLY_OVERLAPPING,
  GRAZE_ENGINE_MISS,
  GRAZE_ENGINE_NOT_CONVERGED
} graze_engine_outcome;

/* Everything is NaN at first. What stays so, but is among the `answers` of the description, is a finding. A number that
 * is no bracket has its upper end left at NaN. */
typedef struct graze_engine_answer {
  double time, time_upper;
  double distance, distance_upper;
  double depth, depth_upper;
  double normal[3];              /* unit, from A to B */
  double point_a[3], point_b[3]; /* witnesses */
  char message[240];             /* whatever helps who reads a finding; ends with a zero */
} graze_engine_answer;

/* The engine's graze.engine/1, one line of JSON without its end. Without it the engine is called by the name of its
 * file, takes every shape but posed and summed ones, in double, and promises nothing: casts and rays are held to their
 * time, distance and penetration to their number. */
GRAZE_ENGINE_EXPORT const char* graze_engine_describe(void);

/* Before and after the calls of one question: what one prepares is handed to the call, and is not timed. */
GRAZE_ENGINE_EXPORT void* graze_engine_begin(const graze_engine_question* question);
GRAZE_ENGINE_EXPORT void graze_engine_end(void* prepared);

/* The queries. `prepared` is null where there is no graze_engine_begin. */
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_cast(const graze_engine_question* question,
                                                           void* prepared, graze_engine_answer* answer);
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_rotating_cast(const graze_engine_question* question,
                                                                    void* prepared,
                                                                    graze_engine_answer* answer);
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_ray(const graze_engine_question* question,
                                                          void* prepared, graze_engine_answer* answer);
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_overlap(const graze_engine_question* question,
                                                              void* prepared, graze_engine_answer* answer);
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_distance(const graze_engine_question* question,
                                                               void* prepared, graze_engine_answer* answer);
GRAZE_ENGINE_EXPORT graze_engine_outcome graze_engine_penetration(const graze_engine_question* question,
                                                                  void* prepared,
                                                                  graze_engine_answer* answer);

#ifdef __cplusplus
}
#endif

#endif
