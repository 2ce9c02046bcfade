#include "ccd/certified/kernels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/verify.hpp"
#include "ccd/certified/projection.hpp"

// ifunc resolvers run before the sanitizer runtime is initialised.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CCDFUZZ_SANITIZED
#endif
#endif
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(CCDFUZZ_SANITIZED)
#define CCDFUZZ_FOR_EACH_CPU __attribute__((target_clones("default", "avx2")))
#else
#define CCDFUZZ_FOR_EACH_CPU
#endif

namespace ccdfuzz::certified {

namespace {

/// Four doubles; compilers break it down where the target has shorter vectors.
using Vector = double __attribute__((vector_size(32)));
using Mask = long long __attribute__((vector_size(32)));

/// The four doubles at a place, to read or to write as a whole. A vector load from several narrower
/// stores fails store forwarding. (A structure: clang forgets how a vector type is aligned where a
/// function returns a reference to it.)
struct __attribute__((packed, aligned(8), may_alias)) Quad {
  Vector all;
};
[[gnu::always_inline]] inline const Quad& quad(const double* from) {
  return *reinterpret_cast<const Quad*>(from);
}
[[gnu::always_inline]] inline Quad& quad(double* to) {
  return *reinterpret_cast<Quad*>(to);
}

/// fl(h) on four axes at both ends, for side 0 below side 1 and above it (Gaps).
struct GapVectors {
  Vector lo0, hi0, lo1, hi1;

  [[gnu::always_inline]] GapVectors(const RangeBatch& a, const RangeBatch& b) {
    lo0 = quad(a.max_lo.data()).all - quad(b.min_lo.data()).all;
    hi0 = quad(a.max_hi.data()).all - quad(b.min_hi.data()).all;
    lo1 = quad(b.max_lo.data()).all - quad(a.min_lo.data()).all;
    hi1 = quad(b.max_hi.data()).all - quad(a.min_hi.data()).all;
  }

  /// The lesser of both sides' larger gap.
  [[gnu::always_inline]] void throughout(Vector& out) const {
    const Vector below = lo0 > hi0 ? lo0 : hi0;
    const Vector above = lo1 > hi1 ? lo1 : hi1;
    out = below < above ? below : above;
  }
};

/// Extents on four axes at both ends.
struct RangeVectors {
  Vector min_lo, max_lo, min_hi, max_hi;

  [[gnu::always_inline]] void begin(const Vector& lo, const Vector& hi) {
    min_lo = max_lo = lo;
    min_hi = max_hi = hi;
  }
  [[gnu::always_inline]] void add(const Vector& lo, const Vector& hi) {
    min_lo = lo < min_lo ? lo : min_lo;
    max_lo = lo > max_lo ? lo : max_lo;
    min_hi = hi < min_hi ? hi : min_hi;
    max_hi = hi > max_hi ? hi : max_hi;
  }
  [[gnu::always_inline]] void store(RangeBatch& out) const {
    quad(out.min_lo.data()).all = min_lo;
    quad(out.max_lo.data()).all = max_lo;
    quad(out.min_hi.data()).all = min_hi;
    quad(out.max_hi.data()).all = max_hi;
  }
};

[[gnu::always_inline]] inline void copy_point(const double* from, double* to) {
  quad(to).all = quad(from).all;
  quad(to + 4).all = quad(from + 4).all;
}

/// p + t·v, over the weight in p's last place if there is one, which then is 0 again.
template <bool kRational>
[[gnu::always_inline]] inline void place_at(const Vector& p, const Vector& v, double t,
                                            Vector& at) {
  at = p + v * t;
  if constexpr (kRational) {
    at /= p[kWeightPlace];
    at[kWeightPlace] = 0;
  }
}

/// As take_snapshot; without ranges where they are a null pointer.
template <bool kRational>
[[gnu::always_inline]] inline void snapshot_inline(const double* net, int count, double t0,
                                                   double t1, double* out, RangeBatch* ranges) {
  RangeVectors extents{};
  for (int i = 0; i < count; ++i, net += kPerPoint, out += kPerPoint) {
    const Vector p = quad(net).all, v = quad(net + 4).all;
    Vector at_t0, at_t1;
    place_at<kRational>(p, v, t0, at_t0);
    place_at<kRational>(p, v, t1, at_t1);
    quad(out).all = at_t0;
    quad(out + 4).all = at_t1;
    if (ranges == nullptr) continue;
    if (i == 0) {
      extents.begin(at_t0, at_t1);
    } else {
      extents.add(at_t0, at_t1);
    }
  }
  if (ranges != nullptr) extents.store(*ranges);
}

[[gnu::always_inline]] inline void project_inline(const Snapshot& snapshot, const AxisBatch& axes,
                                                  RangeBatch& out) {
  const Vector l0 = quad(axes.axes[0].data()).all, l1 = quad(axes.axes[1].data()).all,
               l2 = quad(axes.axes[2].data()).all;
  const double* x = snapshot.values;
  RangeVectors extents;
  extents.begin((l0 * x[0] + l1 * x[1]) + l2 * x[2], (l0 * x[4] + l1 * x[5]) + l2 * x[6]);
  for (int i = 1; i < snapshot.count; ++i) {
    x += kPerPoint;
    extents.add((l0 * x[0] + l1 * x[1]) + l2 * x[2], (l0 * x[4] + l1 * x[5]) + l2 * x[6]);
  }
  extents.store(out);
  out.of = snapshot.of;
}

/// Asserts what compare requires, and that its vectors say what single numbers do.
[[gnu::always_inline]] inline void check([[maybe_unused]] const RangeBatch& a,
                                         [[maybe_unused]] const RangeBatch& b,
                                         [[maybe_unused]] const Bounds& bounds,
                                         [[maybe_unused]] unsigned throughout) {
#ifndef NDEBUG
  const Basis& basis = bounds.made_from;
  CCDFUZZ_ASSERT(a.of.is_of(b.of.window));
  CCDFUZZ_ASSERT(a.of.window.lo <= a.of.window.hi);
  CCDFUZZ_ASSERT(std::max(a.of.roundings, b.of.roundings) <= basis.roundings);
  for (size_t i = 0; i < kLanes; ++i) {
    // Products of the least doubles are rounded up to one.
    const double most = basis.magnitude * basis.norms[i] * (1 + 0x1p-20) + kLeastAbsolute;
    for (const RangeBatch* r : {&a, &b}) {
      for (const double x : {r->min_lo[i], r->max_lo[i], r->min_hi[i], r->max_hi[i]}) {
        CCDFUZZ_ASSERT(std::abs(x) <= most);
      }
    }
    const double e = bounds.on[i];
    // The zero axis separates nothing, whatever its bound: NaN where `absolute` is infinite.
    CCDFUZZ_ASSERT(basis.norms[i] == 0 ||
                   e >= HeightErrorBound::kHalfUlp *
                            (basis.roundings + HeightErrorBound::kFixedRoundings) *
                            basis.magnitude * basis.norms[i]);
    CCDFUZZ_ASSERT(basis.norms[i] == 0 || e >= 4 * basis.absolute * basis.norms[i]);
    const bool separated = (a.max_lo[i] - b.min_lo[i] < -e && a.max_hi[i] - b.min_hi[i] < -e) ||
                           (b.max_lo[i] - a.min_lo[i] < -e && b.max_hi[i] - a.min_hi[i] < -e);
    CCDFUZZ_ASSERT(separated == ((throughout >> i & 1) != 0));
  }
#endif
}

[[gnu::always_inline]] inline void compare_inline(const RangeBatch& a, const RangeBatch& b,
                                                  const Bounds& bounds, SeparatingAxes& out) {
  const GapVectors gap(a, b);
  const Vector bound = quad(bounds.on.data()).all;
  Vector throughout;
  gap.throughout(throughout);
  const Vector least0 = gap.lo0 < gap.hi0 ? gap.lo0 : gap.hi0;
  const Vector least1 = gap.lo1 < gap.hi1 ? gap.lo1 : gap.hi1;
  const Vector least = least0 < least1 ? least0 : least1;
  // Laws A and C: below −E at both ends is separated throughout.
  const Mask separated = throughout < -bound, at_end = least < -bound;
  constexpr Mask kThroughout = {1, 2, 4, 8}, kAtEnd = {16, 32, 64, 128};
  const Mask bits = (separated & kThroughout) | (at_end & kAtEnd);
  const auto all = static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3]));
  out.throughout = all & 15;
  out.at_an_end = all >> 4;
  check(a, b, bounds, out.throughout);
}

}  // namespace

CCDFUZZ_FOR_EACH_CPU
void take_snapshot(const double* net, int count, double t0, double t1, double* out,
                   RangeBatch* ranges) {
  if (net[kWeightPlace] != 0) return snapshot_inline<true>(net, count, t0, t1, out, ranges);
  // Apart, so that no loop asks for ranges.
  if (ranges == nullptr) return snapshot_inline<false>(net, count, t0, t1, out, nullptr);
  snapshot_inline<false>(net, count, t0, t1, out, ranges);
}

CCDFUZZ_FOR_EACH_CPU
void split_net(const MidpointProgram& program, const double* net, int count, double* slots,
               double* children) {
  for (int i = 0; i < count; ++i) copy_point(net + i * kPerPoint, slots + i * kPerPoint);
  double* next = slots + count * kPerPoint;
  for (const MidpointProgram::Step step : program.steps) {
    for (int half = 0; half < kPerPoint; half += 4) {
      const Vector l = quad(slots + step.left * kPerPoint + half).all;
      const Vector r = quad(slots + step.right * kPerPoint + half).all;
      quad(next + half).all = (l + r) * 0.5;
    }
    next += kPerPoint;
  }
  for (const std::vector<int>& places : program.children) {
    for (const int place : places) {
      copy_point(slots + place * kPerPoint, children);
      children += kPerPoint;
    }
  }
}

CCDFUZZ_FOR_EACH_CPU
void project(const Snapshot& snapshot, const AxisBatch& axes, RangeBatch& out) {
  project_inline(snapshot, axes, out);
}

CCDFUZZ_FOR_EACH_CPU
SeparatingAxes compare(const RangeBatch& a, const RangeBatch& b, const Bounds& bounds) {
  SeparatingAxes out;
  compare_inline(a, b, bounds, out);
  return out;
}

CCDFUZZ_FOR_EACH_CPU
SeparatingAxes project_and_compare(const Snapshot& a, const Snapshot& b, const AxisBatch& axes,
                                   const Bounds& bounds, std::array<RangeBatch, 2>& ranges) {
  project_inline(a, axes, ranges[0]);
  project_inline(b, axes, ranges[1]);
  SeparatingAxes out;
  compare_inline(ranges[0], ranges[1], bounds, out);
  return out;
}

CCDFUZZ_FOR_EACH_CPU
unsigned not_separated(const RangeBatch* a, const RangeBatch* b, unsigned pairs,
                       const Bounds& bounds) {
  const Vector bound = quad(bounds.on.data()).all;
  Mask apart{};  // in each lane the pairs that its axis separates
  for (unsigned left = pairs; left != 0; left &= left - 1) {
    const int pair = std::countr_zero(left);
    const GapVectors gap(a[pair / 4], b[pair % 4]);
    Vector throughout;
    gap.throughout(throughout);
    apart |= (throughout < -bound) & (1LL << pair);
    unsigned separating = 0;
    for (int i = 0; i < kLanes; ++i) separating |= static_cast<unsigned>(apart[i] >> pair & 1) << i;
    check(a[pair / 4], b[pair % 4], bounds, separating);
  }
  return pairs & ~static_cast<unsigned>((apart[0] | apart[1]) | (apart[2] | apart[3]));
}

}  // namespace ccdfuzz::certified
