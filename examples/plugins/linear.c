/* Vertex-face and edge-edge queries of a linear mesh: roots of the cubic of coplanarity, and then
 * whether the points lie in the triangle or on the segments. In floating point, with tolerances: it
 * does not claim to be conservative, and a hunt shows what that costs. */
#include <math.h>
#include <stddef.h>

#include "ccdfuzz_plugin.h"

typedef double Vec[3];

/* How far outside of its domain a parameter may be and still count as inside. */
static const double kInside = 1e-10;

static void difference(const Vec a, const Vec b, Vec out) {
  for (int k = 0; k < 3; ++k) out[k] = a[k] - b[k];
}
static double dot(const Vec a, const Vec b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static void cross(const Vec a, const Vec b, Vec out) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    out[k] = a[i] * b[j] - a[j] * b[i];
  }
}

/* The four points of the query at time t: of the edges a b, c d; or the vertex a, the face b c d.
 */
static void points_at(const ccdfuzz_query* query, double t, Vec p[4]) {
  int next = 0;
  for (int side = 0; side < 2; ++side) {
    const ccdfuzz_patch* patch = query->patches[side];
    for (uint64_t i = 0; i < patch->count; ++i, ++next) {
      for (int k = 0; k < 3; ++k) p[next][k] = patch->positions[i][k] + t * patch->velocities[i][k];
    }
  }
}

static double volume(const ccdfuzz_query* query, double t) {
  Vec p[4], a, b, c, n;
  points_at(query, t, p);
  difference(p[1], p[0], a);
  difference(p[2], p[0], b);
  difference(p[3], p[0], c);
  cross(b, c, n);
  return dot(a, n);
}

/* Whether four coplanar points are in contact, and where. */
static int touches(const ccdfuzz_query* query, double t, double uv[2][2]) {
  Vec p[4], d, e, f;
  points_at(query, t, p);
  const int is_vertex_face = query->patches[0]->shape == CCDFUZZ_POINT;
  if (is_vertex_face) {
    difference(p[3], p[1], d); /* along u */
    difference(p[2], p[1], e); /* along v */
    difference(p[0], p[1], f);
  } else {
    difference(p[1], p[0], d);
    difference(p[2], p[3], e);
    difference(p[2], p[0], f);
  }
  /* f = s d + r e in the least-squares sense */
  const double dd = dot(d, d), de = dot(d, e), ee = dot(e, e), df = dot(d, f), ef = dot(e, f);
  const double det = dd * ee - de * de;
  if (det <= 0) return 0;
  const double s = (df * ee - ef * de) / det, r = (dd * ef - de * df) / det;
  if (s < -kInside || r < -kInside) return 0;
  if (is_vertex_face ? s + r > 1 + kInside : s > 1 + kInside || r > 1 + kInside) return 0;
  uv[0][0] = is_vertex_face ? 0 : s;
  uv[0][1] = 0;
  uv[1][0] = is_vertex_face ? s : r;
  uv[1][1] = is_vertex_face ? r : 0;
  return 1;
}

/* The first contact within [lo, hi], on which the volume has a sign change or none. */
static int root_in(const ccdfuzz_query* query, double lo, double hi, ccdfuzz_answer* answer) {
  const double at_lo = volume(query, lo);
  if (at_lo != 0 && at_lo * volume(query, hi) > 0) return 0;
  for (int step = 0; step < 60 && at_lo != 0; ++step, ++answer->iterations) {
    const double middle = 0.5 * (lo + hi);
    if (at_lo * volume(query, middle) > 0) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  const double t = at_lo == 0 ? lo : hi;
  if (!touches(query, t, answer->uv)) return 0;
  answer->toi_lower = lo;
  answer->toi_upper = t;
  return 1;
}

static int32_t answer_query(void* state, const ccdfuzz_query* query, ccdfuzz_answer* answer) {
  (void)state;
  answer->verdict = CCDFUZZ_MISS;
  answer->iterations = 0;
  /* The cubic through four samples, and where its slope is 0: the roots lie between those. */
  const double T = query->t_max;
  const double y0 = volume(query, 0), y1 = volume(query, T / 3), y2 = volume(query, 2 * T / 3),
               y3 = volume(query, T);
  const double c3 = 4.5 * (y3 - 3 * y2 + 3 * y1 - y0), c2 = 4.5 * (2 * y0 - 5 * y1 + 4 * y2 - y3),
               c1 = 0.5 * (-11 * y0 + 18 * y1 - 9 * y2 + 2 * y3);
  double ends[4] = {0, T, T, T};
  const double discriminant = c2 * c2 - 3 * c3 * c1;
  if (discriminant > 0) {
    const double q = -(c2 + copysign(sqrt(discriminant), c2));
    const double a = c3 != 0 ? q / (3 * c3) : 0, b = q != 0 ? c1 / q : 0;
    ends[1] = fmin(fmax(fmin(a, b), 0), 1) * T;
    ends[2] = fmin(fmax(fmax(a, b), 0), 1) * T;
  }
  for (int i = 0; i < 3; ++i) {
    if (root_in(query, ends[i], ends[i + 1], answer)) {
      answer->verdict = CCDFUZZ_HIT;
      break;
    }
  }
  return 0;
}

static int32_t describe(void* state, ccdfuzz_description* out) {
  static const ccdfuzz_pair kPairs[2] = {{{CCDFUZZ_POINT, CCDFUZZ_TRIANGLE}, {0, 1}},
                                         {{CCDFUZZ_CURVE, CCDFUZZ_CURVE}, {1, 1}}};
  (void)state;
  out->claims = CCDFUZZ_CLOSED_T_MAX | CCDFUZZ_CONTACT_AT_ZERO;
  out->name = "linear, by roots of the cubic";
  out->version = "1.0";
  out->pairs = kPairs;
  out->pair_count = 2;
  out->tolerance_kind = CCDFUZZ_TOLERANCE_TIME_RELATIVE;
  out->tolerance = 1e-12;
  return 0;
}

static int32_t create(const char* options, void** state) {
  *state = NULL;
  return options[0] != '\0'; /* it has none */
}
static void destroy(void* state) {
  (void)state;
}

const ccdfuzz_plugin* ccdfuzz_plugin_get(void) {
  static const ccdfuzz_plugin plugin = {
      sizeof(ccdfuzz_plugin), CCDFUZZ_PLUGIN_ABI, create, destroy, describe, answer_query};
  return &plugin;
}
