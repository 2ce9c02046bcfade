#include "ccd/certified/kernels.hpp"

#include <algorithm>
#include <cstring>

// Sanitizers cannot stand the resolvers, which run before they are set up.
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

}  // namespace

CCDFUZZ_FOR_EACH_CPU
void take_snapshot(const double* net, int width, double t0, double t1, double* out) {
  const int size = 3 * width;
  const double* velocities = net + size;
  for (int i = 0; i < size; i += 4) {
    Vector p, v;
    std::memcpy(&p, net + i, sizeof p);
    std::memcpy(&v, velocities + i, sizeof v);
    const Vector at_t0 = p + v * t0, at_t1 = p + v * t1;
    std::memcpy(out + i, &at_t0, sizeof p);
    std::memcpy(out + size + i, &at_t1, sizeof p);
  }
}

CCDFUZZ_FOR_EACH_CPU
void component_ranges(const Snapshot& snapshot, ComponentRanges& out) {
  for (int k = 0; k < 6; ++k) {
    const double* x = snapshot.values + k * snapshot.width;
    Vector least, most;
    std::memcpy(&least, x, sizeof least);
    most = least;
    for (int i = 4; i < snapshot.width; i += 4) {
      Vector y;
      std::memcpy(&y, x + i, sizeof y);
      least = y < least ? y : least;
      most = y > most ? y : most;
    }
    out.min[k] = std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
    out.max[k] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  }
}

CCDFUZZ_FOR_EACH_CPU
void project(const Snapshot& snapshot, const AxisBatch& axes, RangeBatch& out) {
  Vector l0, l1, l2;
  std::memcpy(&l0, axes.axes[0].data(), sizeof l0);
  std::memcpy(&l1, axes.axes[1].data(), sizeof l1);
  std::memcpy(&l2, axes.axes[2].data(), sizeof l2);
  const double* x = snapshot.values;
  const int w = snapshot.width;
  Vector min_lo = (l0 * x[0] + l1 * x[w]) + l2 * x[2 * w];
  Vector min_hi = (l0 * x[3 * w] + l1 * x[4 * w]) + l2 * x[5 * w];
  Vector max_lo = min_lo, max_hi = min_hi;
  for (int i = 1; i < snapshot.count; ++i) {
    ++x;
    const Vector lo = (l0 * x[0] + l1 * x[w]) + l2 * x[2 * w];
    const Vector hi = (l0 * x[3 * w] + l1 * x[4 * w]) + l2 * x[5 * w];
    min_lo = lo < min_lo ? lo : min_lo;
    max_lo = lo > max_lo ? lo : max_lo;
    min_hi = hi < min_hi ? hi : min_hi;
    max_hi = hi > max_hi ? hi : max_hi;
  }
  std::memcpy(out.min_lo.data(), &min_lo, sizeof min_lo);
  std::memcpy(out.max_lo.data(), &max_lo, sizeof max_lo);
  std::memcpy(out.min_hi.data(), &min_hi, sizeof min_hi);
  std::memcpy(out.max_hi.data(), &max_hi, sizeof max_hi);
}

CCDFUZZ_FOR_EACH_CPU
void project_lines(const double* net, int width, const std::array<double, 3>& axis, double* slopes,
                   double* intercepts) {
  for (int i = 0; i < width; i += 4) {
    Vector c[6];
    for (int k = 0; k < 6; ++k) std::memcpy(&c[k], net + k * width + i, sizeof c[k]);
    const Vector b = (c[0] * axis[0] + c[1] * axis[1]) + c[2] * axis[2];
    const Vector a = (c[3] * axis[0] + c[4] * axis[1]) + c[5] * axis[2];
    std::memcpy(intercepts + i, &b, sizeof b);
    std::memcpy(slopes + i, &a, sizeof a);
  }
}

}  // namespace ccdfuzz::certified
