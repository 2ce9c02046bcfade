// Newton's method from a few starts: what one writes first, and what a hunt breaks in seconds.
#include <array>
#include <cmath>

#include "ccdfuzz_plugin.hpp"

namespace ccd = ccdfuzz_plugin_cpp;
using Vec = std::array<double, 3>;
using Unknowns = std::array<double, 5>;  // u, v on each triangle, and t

static double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The point (u, v) of a triangle at time t, by de Casteljau's algorithm.
static Vec point(const ccd::Patch& patch, double u, double v, double t) {
  std::vector<Vec> p(patch.count());
  for (std::size_t i = 0; i < p.size(); ++i) {
    p[i] = {patch.at(i, 0, t), patch.at(i, 1, t), patch.at(i, 2, t)};
  }
  const auto index = [](int n, int i, int j) {
    return static_cast<std::size_t>(i * (n + 1) - i * (i - 1) / 2 + j);
  };
  for (int n = static_cast<int>(patch.raw.degree_u); n > 0; --n) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n - i; ++j) {
        const Vec &w = p[index(n, i, j)], &a = p[index(n, i, j + 1)], &b = p[index(n, i + 1, j)];
        Vec q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = (1 - u - v) * w[k] + v * a[k] + u * b[k];
        p[index(n - 1, i, j)] = q;
      }
    }
  }
  return p[0];
}

static Vec gap(const ccd::Query& query, const Unknowns& x) {
  const Vec a = point(query.patch(0), x[0], x[1], x[4]);
  const Vec b = point(query.patch(1), x[2], x[3], x[4]);
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

struct Naive {
  explicit Naive(const std::string&) {}

  static ccd::Description describe() {
    ccd::Description d{"naive Newton", "1.0"};
    d.pairs = {{{CCDFUZZ_TRIANGLE, CCDFUZZ_TRIANGLE}, {8, 8}}};
    return d;
  }

  static ccd::Answer answer(const ccd::Query& query) {
    ccd::Answer best = ccd::Answer::miss();
    for (const double start : {0.05, 0.3, 0.6}) {
      Unknowns x = {start, 0.3, start, 0.3, start * query.t_max()};
      for (int step = 0; step < 20; ++step, ++best.iterations) {
        const Vec r = gap(query, x);
        if (dot(r, r) < 1e-18) {
          if (best.verdict != CCDFUZZ_HIT || x[4] < best.toi_lower) best = hit(x, best.iterations);
          break;
        }
        // The shortest step d with J d = -r: d = -J^T y where J J^T y = r; J by differences.
        std::array<Vec, 5> columns;
        std::array<Vec, 3> m{};
        for (std::size_t k = 0; k < 5; ++k) {
          Unknowns moved = x;
          moved[k] += 1e-7;
          const Vec s = gap(query, moved);
          for (std::size_t i = 0; i < 3; ++i) columns[k][i] = (s[i] - r[i]) / 1e-7;
          for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) m[i][j] += columns[k][i] * columns[k][j];
          }
        }
        const double det = dot(m[0], cross(m[1], m[2]));
        if (!(det > 0)) break;
        const Vec y = {dot(r, cross(m[1], m[2])) / det, dot(r, cross(m[2], m[0])) / det,
                       dot(r, cross(m[0], m[1])) / det};
        for (std::size_t k = 0; k < 5; ++k) {
          const double most = k == 4 ? query.t_max() : 1;
          x[k] = std::fmin(std::fmax(x[k] - dot(columns[k], y), 0), most);
        }
      }
    }
    return best;
  }

  static ccd::Answer hit(const Unknowns& x, std::uint64_t iterations) {
    ccd::Answer answer = ccd::Answer::hit(x[4]);
    for (std::size_t k = 0; k < 4; ++k) answer.uv[k / 2][k % 2] = x[k];
    answer.iterations = iterations;
    return answer;
  }
};

CCDFUZZ_PLUGIN(Naive)
