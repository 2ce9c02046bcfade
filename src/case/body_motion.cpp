#include "case/body_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/nearest_float.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kAxes = {0, 1, 2};

/// Whether x - y is a float; x and y are. No rounding hides behind both sums: the difference from
/// the larger of the two is exact (Dekker).
bool have_float_difference(double x, double y) {
  const double difference = x - y;
  return is_float(difference) && x - difference == y && y + difference == x;
}

bool is_capsule(const MovingPatch<double>& body) {
  return body.positions.size() == 2 && body.radius > 0;
}

bool has_float_middle(double x, double y) {
  const double middle = (x + y) / 2, half = (y - x) / 2;
  return is_float(middle) && is_float(half) && middle - half == x && middle + half == y;
}

bool moves_by_step(const Query& bodies) {
  return std::ranges::all_of(bodies.patches, [](const MovingPatch<double>& body) {
    return !body.turn || body.turn->is_spin();
  });
}

/// Whether the motions of both bodies in the step, along each axis, are such.
template <class Good>
bool are_all_motions(const Query& bodies, const Good& good) {
  const Vec3<double>&first = bodies.patches[0].velocities[0],
        &second = bodies.patches[1].velocities[0];
  return !moves_by_step(bodies) || std::ranges::all_of(kAxes, [&](int k) {
    return good(bodies.t_max * first[k], bodies.t_max * second[k]);
  });
}

bool are_float_motions(const Query& bodies) {
  return are_all_motions(bodies, [](double x, double y) {
    return is_float(x) && is_float(y) && have_float_difference(x, y);
  });
}

/// Makes the step as long as a power of two: then what floats move by in it are floats.
void lengthen_step(Query& bodies) {
  int exponent = 0;
  const double part = std::frexp(bodies.t_max, &exponent);
  if (part == 0.5) return;
  bodies.t_max = std::ldexp(1.0, exponent);
  for (MovingPatch<double>& body : bodies.patches) {
    for (const int k : kAxes) {
      double& x = body.velocities[0][k];
      x = nearest_float(part * x);
    }
    if (!body.turn) continue;
    for (double& x : body.turn->spin) x = nearest_float(part * x);
  }
}

/// Makes both multiples of one power of two, and at most 2^23 of it. So their sum and their
/// difference are at most 2^24 of it, and with their halves floats.
void align(double& x, double& y) {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (larger == 0) return;
  const int exponent = std::ilogb(larger) - 22;
  for (double* number : {&x, &y}) {
    *number = std::ldexp(std::round(std::ldexp(*number, -exponent)), exponent);
  }
}

}  // namespace

double largest_motion(const Query& bodies) {
  double largest = 0;
  are_all_motions(bodies, [&](double x, double y) {
    largest = std::max({largest, std::abs(x), std::abs(y), std::abs(x - y)});
    return true;
  });
  return largest;
}

bool are_given_as_floats(const Query& bodies) {
  return are_float_motions(bodies) &&
         std::ranges::all_of(bodies.patches, [](const MovingPatch<double>& body) {
           return !is_capsule(body) || std::ranges::all_of(kAxes, [&](int k) {
             return has_float_middle(body.positions[0][k], body.positions[1][k]);
           });
         });
}

void give_as_floats(Query& bodies) {
  if (!are_float_motions(bodies)) {
    lengthen_step(bodies);
    Vec3<double>&first = bodies.patches[0].velocities[0], &second = bodies.patches[1].velocities[0];
    for (const int k : kAxes) {
      for (double* const v : {&first[k], &second[k]}) {
        const double moved = bodies.t_max * *v;  // a float below 2^-126 has fewer bits
        if (std::abs(moved) < 0x1p-126) *v = nearest_float(moved) / bodies.t_max;
      }
      if (!have_float_difference(first[k], second[k])) align(first[k], second[k]);
    }
  }
  for (MovingPatch<double>& body : bodies.patches) {
    if (!is_capsule(body)) continue;
    for (const int k : kAxes) {
      double &x = body.positions[0][k], &y = body.positions[1][k];
      if (!has_float_middle(x, y)) align(x, y);
    }
  }
}

}  // namespace ccdfuzz
