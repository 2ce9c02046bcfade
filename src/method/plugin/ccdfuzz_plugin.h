/* The C interface of a ccdfuzz plug-in, version 1: a shared library that answers continuous
 * collision detection queries, for `--methods plugin:PATH`.
 *
 * A plug-in exports one function, ccdfuzz_plugin_get, and keeps what it needs between queries in
 * the state that its create() makes: no globals. It is loaded into a worker process of its own with
 * limited time and memory. Whatever goes wrong there (a crash, exit(), a hang, a NaN, an exception
 * that leaves a function) is a finding against the plug-in and harms nothing else.
 *
 * Versions: every struct begins with its size in bytes, set by whoever made it to its own sizeof.
 * Later versions only append fields, so the smaller of two sizes says what both sides know. All
 * pointers that a plug-in is given are valid during the call alone. Numbers are finite doubles, but
 * where nan_policy says so.
 */
#ifndef CCDFUZZ_PLUGIN_H
#define CCDFUZZ_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CCDFUZZ_PLUGIN_ABI 1u

/* ccdfuzz_patch.shape */
enum {
  CCDFUZZ_POINT = 0,    /* 1 control point, no parameters */
  CCDFUZZ_CURVE = 1,    /* degree_u + 1 control points, u in [0,1] */
  CCDFUZZ_TRIANGLE = 2, /* (n+1)(n+2)/2 control points for n = degree_u; u, v >= 0, u + v <= 1 */
  CCDFUZZ_TENSOR = 3,   /* (degree_u+1)(degree_v+1) control points, u, v in [0,1] */
  CCDFUZZ_HULL = 4      /* a body: all points within `radius` of the convex hull of 1 to 81 control
                         * points; no parameters. A query has two bodies or none: as the plug-in claims
                         * CCDFUZZ_TAKES_BODIES, CCDFUZZ_TAKES_MESHES, CCDFUZZ_TAKES_ONE_SIDED */
};

/* A moving Bezier patch: at time t control point i stands at positions[i] + t * velocities[i], or
 * where `ends` are given at positions[i] + t * (ends[i] - positions[i]).
 * Control points come by rising power i of u and within it by rising power j of v. The weight of
 * (i,j) is n!/(i!j!k!) u^i v^j w^k, w = 1-u-v, for a triangle; a product of Bernstein polynomials
 * otherwise. So a triangle of degree 1 has the corners (u,v) = (0,0), (0,1), (1,0), in this order.
 */
typedef struct ccdfuzz_patch {
  uint32_t size;
  uint32_t shape;
  uint32_t degree_u; /* 0 for a point or a hull, else 1 to 8 */
  uint32_t degree_v; /* tensor only, else 0 */
  uint64_t count;    /* of control points */
  const double (*positions)[3];
  const double (*velocities)[3]; /* a hull has one velocity for all of its points */
  /* Positions at t = 1, exactly; velocities is NULL then, and t_max <= 1. NULL otherwise, and
   * always for a plug-in that does not claim CCDFUZZ_TAKES_ENDS: ends are asked of it as velocities
   * where these are doubles, and not at all where they are not. */
  const double (*ends)[3];
  /* `count` weights > 0, fixed in time: the patch is rational, its point the sum of weight times
   * Bernstein polynomial times control point, over the sum of weight times Bernstein polynomial.
   * NULL otherwise, and always for a plug-in that does not claim CCDFUZZ_TAKES_WEIGHTS: it is not
   * asked of patches whose weights differ. */
  const double* weights;
  double radius; /* >= 0; of a hull, else 0 */
  /* `loop_count` closed polygons, one after the other, of loop_sizes[i] vertices (u, v) each: the
   * patch is over their even-odd region, which its boundary belongs to. 0 and NULL: over all of the
   * domain, as always for a plug-in that does not claim CCDFUZZ_TAKES_TRIMS. */
  uint64_t loop_count;
  const uint64_t* loop_sizes;
  const double (*loop_vertices)[2];
  /* Of a body that turns: at time t a point p of it is at c + R (p - c) + t * velocity, c the
   * turn_centre. R is the rotation of q = (1-t) * turn_from + t * turn_to, whose length does not
   * matter, and t_max <= 1. With a turn_count of 4 the numbers are w, x, y, z of a quaternion: R v
   * = q v q* / |q|^2. With 2 they are cosine and sine of an angle about the z axis, times |q|. With
   * 3, turn_from is a constant angular velocity w in radians, and turn_to is NULL: R is the
   * rotation about w by |w| t, and |w| <= 8. 0 and NULL: it does not turn, as always for a plug-in
   * that claims none of CCDFUZZ_TAKES_TURNS, CCDFUZZ_TAKES_ANGLES and CCDFUZZ_TAKES_SPINS. */
  uint64_t turn_count;
  const double* turn_from;
  const double* turn_to;
  double turn_centre[3];
  /* Of a mesh: face_count triangles, in place of the hull of the positions, with the radius 0. A
   * face has the places of its corners among the positions, counter-clockwise as seen from its
   * front. If one_sided is 1, a face is there only if n . v < 0, in exact arithmetic: n = (b-a) x
   * (c-a) of its corners, v the other body's velocity less the mesh's. 0 and NULL: no mesh, as
   * always for a plug-in that claims neither CCDFUZZ_TAKES_MESHES nor CCDFUZZ_TAKES_ONE_SIDED. */
  uint64_t face_count;
  const uint32_t (*faces)[3];
  uint32_t one_sided;
} ccdfuzz_patch;

/* Do the two patches touch at some t of the closed [0, t_max], and when first? */
typedef struct ccdfuzz_query {
  uint32_t size;
  uint32_t reserved;
  const ccdfuzz_patch* patches[2];
  double t_max;            /* >= 0 */
  double precision;        /* parameter width at which ccdfuzz's own methods stop */
  uint64_t max_iterations; /* after about so many it may answer CCDFUZZ_INCONCLUSIVE */
  double max_seconds;      /* and after this time it should; the worker is killed later */
  double separation;       /* >= 0; in contact are points no farther apart; 0, always, for a plug-in
                            * that does not claim CCDFUZZ_TAKES_SEPARATION: touching */
} ccdfuzz_query;

/* ccdfuzz_answer.verdict */
enum {
  CCDFUZZ_HIT = 1,          /* they touch; toi_lower is needed */
  CCDFUZZ_MISS = 2,         /* they do not touch in [0, t_max] */
  CCDFUZZ_INCONCLUSIVE = 3, /* gave up; never counted as wrong */
  CCDFUZZ_ERROR = 4,        /* failed on a valid query: a finding; message may say why */
  CCDFUZZ_REFUSED = 5       /* does not take such queries: never counted; message says why */
};

/* The host fills every field with what is no answer (verdict 0, NaN) before each call. */
typedef struct ccdfuzz_answer {
  uint32_t size; /* set by the host; a plug-in sets it to what it knows if that is less */
  uint32_t verdict;
  double toi_lower;    /* hit: the time of impact, or a lower bound of it; in [0, t_max] */
  double toi_upper;    /* hit: a finite upper bound of it, or NaN if it has none */
  double uv[2][2];     /* hit: where on each patch, or two NaN if it does not know; one NaN is a
                          finding ("uv NaN"), but of a shape that has no v; what rounding took out
                          of the domain is moved back to its edge */
  uint64_t iterations; /* boxes, Newton steps: whatever it counts */
  double tolerance;    /* achieved, in the unit of the claimed one, which it stands in for where it
                        * is tighter; looser: a finding ("broken claim"); NaN: as claimed */
  char message[128];   /* for people; ends with a NUL */
} ccdfuzz_answer;

/* ccdfuzz_description.claims; the next bit that is free is 524288 */
enum {
  CCDFUZZ_CONSERVATIVE = 1,      /* never misses a contact, and toi_lower is never after it */
  CCDFUZZ_CLOSED_T_MAX = 2,      /* sees a contact at t = t_max, too */
  CCDFUZZ_CONTACT_AT_ZERO = 4,   /* sees a contact at t = 0, too */
  CCDFUZZ_TAKES_ENDS = 8,        /* answers patches with `ends` */
  CCDFUZZ_TAKES_SEPARATION = 16, /* answers queries with a `separation` above 0 */
  CCDFUZZ_TAKES_WEIGHTS = 32,    /* answers patches with `weights` */
  CCDFUZZ_TAKES_BODIES = 64,     /* answers queries of two convex bodies (CCDFUZZ_HULL) */
  CCDFUZZ_TAKES_TRIMS = 128,     /* answers patches with loops */
  /* What it promises to answer is narrower; it is asked of nothing else: */
  CCDFUZZ_BINARY32 = 256, /* queries all of whose numbers are floats; of bodies, so are t_max times
                           * each velocity, the differences of both bodies' and, where a body has
                           * two points and a radius, their middle and half of their difference */
  CCDFUZZ_ORDINARY = 512, /* queries that start apart, in motion, of patches or bodies with extent,
                           * and whose contact is well inside of [0, t_max] */
  CCDFUZZ_PLANE = 1024,   /* bodies that lie and move in the plane z = 0 */
  /* And it answers bodies that turn: */
  CCDFUZZ_TAKES_TURNS = 2048,   /* by quaternions */
  CCDFUZZ_TAKES_ANGLES = 4096,  /* by cosine and sine */
  CCDFUZZ_TAKES_SPINS = 8192,   /* by an angular velocity */
  CCDFUZZ_SMALL_SPINS = 131072, /* and by pi / 4 at most in the step: it is asked of no larger */
  CCDFUZZ_SHORT_SPINS = 262144, /* and by 3 radians at most: the shorter way between two poses */
  /* It answers a convex body against a mesh, with CCDFUZZ_TAKES_BODIES or without: */
  CCDFUZZ_TAKES_MESHES = 16384,    /* whose faces have two sides */
  CCDFUZZ_TAKES_ONE_SIDED = 32768, /* whose faces have fronts alone */
  /* With CCDFUZZ_ORDINARY and CCDFUZZ_CONTACT_AT_ZERO: beside these queries, convex bodies that
   * touch or overlap at t = 0. It promises a hit there, whatever way they move: */
  CCDFUZZ_INITIAL_OVERLAP = 65536
};

/* ccdfuzz_description.tolerance_kind; how a claimed tolerance > 0 is counted in its favour:
 *   time (of all parameters, the one that answers are about): a hit so much before a contact that
 *     comes after t_max is no false positive; if it is not conservative, a hit so much after the
 *     contact is still in time
 *   space: a hit where the patches are this near each other, as uv says, is no false positive */
enum {
  CCDFUZZ_TOLERANCE_TIME = 0,
  CCDFUZZ_TOLERANCE_TIME_RELATIVE = 1, /* times t_max */
  CCDFUZZ_TOLERANCE_SPACE = 2,
  CCDFUZZ_TOLERANCE_SPACE_RELATIVE = 3 /* times the largest coordinate at t = 0 and t_max */
};

/* ccdfuzz_description.nan_policy: what it answers where a coordinate is NaN or infinite. To hold it
 * to its word each query is asked once more so, between others; with undefined, never. */
enum {
  CCDFUZZ_NAN_UNDEFINED = 0,
  CCDFUZZ_NAN_ERROR = 1,
  CCDFUZZ_NAN_INCONCLUSIVE = 2,
  CCDFUZZ_NAN_HIT = 3, /* at 0: what cannot be known to be safe is not */
  CCDFUZZ_NAN_REFUSED = 4
};

/* A pair of shapes that it answers, up to these degrees; hulls up to so many points. The host swaps
 * the patches of a query, and uv back, where that makes them fit. */
typedef struct ccdfuzz_pair {
  uint32_t shapes[2];
  uint32_t max_degrees[2];
} ccdfuzz_pair;

/* ccdfuzz_body_kind.radius */
enum { CCDFUZZ_ANY_RADIUS = 0, CCDFUZZ_NO_RADIUS = 1, CCDFUZZ_POSITIVE_RADIUS = 2 };

/* Bodies that it has a shape for: hulls of so many points, with such a radius. */
typedef struct ccdfuzz_body_kind {
  uint32_t least_points;
  uint32_t most_points;
  uint32_t radius;
} ccdfuzz_body_kind;

/* What a plug-in is and claims: how its answers are judged. */
typedef struct ccdfuzz_description {
  uint32_t size; /* set by the host, as in ccdfuzz_answer; all else is 0 before the call */
  uint32_t claims;
  const char* name;
  const char* version;
  const ccdfuzz_pair* pairs; /* pair_count of them; none: every shape of every degree */
  uint64_t pair_count;
  uint32_t tolerance_kind;
  uint32_t nan_policy;
  double tolerance; /* 0: none claimed; at most 2^40, or 1 where the kind is relative */
  /* In [0, 2^40]; a hit where the patches are this near is no false positive. If it is
   * conservative, that they come nearer needs a hit, and toi_lower is never after that. */
  double minimum_separation;
  /* NULL, or the sentence that it is held to, with a link: reports show it. */
  const char* promise;
  /* 0, or N: it is asked only about numbers that are 0 or of a magnitude in [2^-N, 2^N]. Points
   * of patches are within 2^N at t_max, too, and a separation may be smaller. Bodies move by 2^N at
   * most along an axis, each and against each other. */
  uint64_t within;
  /* body_count of them: each body of a query that it is asked is of one. None: all bodies are. */
  const ccdfuzz_body_kind* bodies;
  uint64_t body_count;
} ccdfuzz_description;

/* A plug-in. Every function may be called from one thread at a time. No function may let an
 * exception out, but create in C++. */
typedef struct ccdfuzz_plugin {
  uint32_t size;
  uint32_t abi; /* CCDFUZZ_PLUGIN_ABI */
  /* A new state (0 is one, too), from what stands behind the path in
   * `plugin:PATH:OPTIONS`; "" if nothing does. Returns 0, or not 0 if the options are wrong.
   * What it throws says what is wrong with them. */
  int32_t (*create)(const char* options, void** state);
  void (*destroy)(void* state);
  int32_t (*describe)(void* state, ccdfuzz_description* description);
  /* Returns 0 if the answer is filled, and anything else for an error. */
  int32_t (*answer)(void* state, const ccdfuzz_query* query, ccdfuzz_answer* answer);
} ccdfuzz_plugin;

/* The one exported function. What it returns stays valid while the library is loaded. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const ccdfuzz_plugin*
ccdfuzz_plugin_get(void);

#ifdef __cplusplus
}
#endif

#endif /* CCDFUZZ_PLUGIN_H */
