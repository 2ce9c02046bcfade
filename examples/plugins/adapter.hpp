// What the adapters of linear CCD codes share: options, and a query as eight end points.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "ccdfuzz_plugin.hpp"

namespace adapter {

namespace ccd = ccdfuzz_plugin_cpp;

using ccd::Refusal;

inline float as_float(double x) {
  const auto narrow = static_cast<float>(x);
  if (static_cast<double>(narrow) != x) throw Refusal("a number is no float");
  return narrow;
}

/// A number of a turn, if its q has the unit length that an engine asks for.
inline float of_unit(const double* q, std::uint64_t count, std::size_t place) {
  double squared = 0;
  for (std::uint64_t i = 0; i < count; ++i) squared += q[i] * q[i];
  if (std::abs(squared - 1) > 0x1p-20) throw Refusal("a turn is not of unit length");
  return as_float(q[place]);
}

/// w, x, y, z of the quaternion of a body that spins until t; it may do so by `most` radians.
inline std::array<double, 4> spun(const ccdfuzz_patch& body, double t, double most) {
  if (body.turn_count != 3) return {1, 0, 0, 0};
  const double* v = body.turn_from;
  const double speed = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), half = speed * t / 2;
  if (2 * half > most) throw Refusal("it turns by too much in the step");
  const double part = speed > 0 ? std::sin(half) / speed : 0;
  return {std::cos(half), part * v[0], part * v[1], part * v[2]};
}

/// "key=number:key=number".
class Options {
 public:
  explicit Options(const std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find(':', begin), text.size());
      const std::string one = text.substr(begin, end - begin);
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos) throw std::invalid_argument(one + " is not KEY=NUMBER");
      values_[one.substr(0, equals)] = one.substr(equals + 1);
      begin = end + 1;
    }
  }

  double number(const std::string& key, double otherwise) {
    known_ += " " + key + "=NUMBER";
    const auto found = values_.find(key);
    if (found == values_.end()) return otherwise;
    char* end = nullptr;
    const double value = std::strtod(found->second.c_str(), &end);
    if (end == found->second.c_str() || *end != '\0') {
      throw std::invalid_argument(key + "=" + found->second + " is no number");
    }
    values_.erase(found);
    return value;
  }

  void check_all_known() const {
    if (values_.empty()) return;
    const auto& [key, value] = *values_.begin();
    throw std::invalid_argument("unknown option " + key + "=" + value + "; there are" +
                                (known_.empty() ? " none" : ":" + known_));
  }

 private:
  std::map<std::string, std::string> values_;
  std::string known_;
};

/// A time of [0, 1] as one of [0, t_max], rounded down: what is conservative stays so.
inline double scaled_toi(double toi, double t_max) {
  return t_max == 1 ? toi : std::nextafter(toi * t_max, 0.0);
}

/// The four points at t = 0 and then at t = t_max: vertex and face v, f0, f1, f2, or both edges.
/// The end points are rounded where p + t_max v is no double: the code is then asked about a motion
/// that is off by so much. Hunt with cases whose end points are doubles to see the code alone.
template <class Vector>
std::array<Vector, 8> end_points(const ccd::Query& query) {
  std::array<Vector, 8> points;
  std::size_t next = 0;
  for (int side = 0; side < 2; ++side) {
    const ccd::Patch patch = query.patch(side);
    for (std::size_t i = 0; i < patch.count(); ++i, ++next) {
      for (int k = 0; k < 3; ++k) {
        using Scalar = typename Vector::Scalar;
        points[next][k] = static_cast<Scalar>(patch.at(i, k, 0));
        points[next + 4][k] = static_cast<Scalar>(patch.at(i, k, query.t_max()));
      }
    }
  }
  return points;
}

/// The same, exactly. Where a query has velocities the step is as long as the least power of two
/// that is no less than t_max. Where it has ends the step is 1. Throws a Refusal where an end is no
/// double.
template <class Vector>
struct ExactEnds {
  std::array<Vector, 8> points;
  double step = 1;

  explicit ExactEnds(const ccd::Query& query) {
    points.fill(Vector::Zero());
    const bool has_ends = query.raw.patches[0]->ends != nullptr;
    if (!has_ends) step = std::exp2(std::ceil(std::log2(std::max(query.t_max(), 0x1p-60))));
    std::size_t next = 0;
    for (const ccdfuzz_patch* patch : query.raw.patches) {
      for (std::uint64_t i = 0; i < patch->count; ++i, ++next) {
        for (int k = 0; k < 3; ++k) {
          const double start = patch->positions[i][k];
          points[next][k] = start;
          points[next + 4][k] =
              has_ends ? patch->ends[i][k] : moved(start, patch->velocities[i][k]);
        }
      }
    }
  }

 private:
  double moved(double start, double velocity) const {
    const double way = step * velocity, end = start + way;
    if (end - start != way || end - way != start) {
      throw Refusal("an end of the motion is no double");
    }
    return end;
  }
};

}  // namespace adapter
