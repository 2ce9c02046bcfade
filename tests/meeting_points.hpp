#pragma once

#include "case/query.hpp"

namespace ccdfuzz {

/// Two points that approach along x and meet at t = 1/2 exactly.
inline Query meeting_points(double t_max) {
  Query query;
  query.patches[0] = {Shape::point(), {{0, 0, 0}}, {{1, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1, 0, 0}}, {{-1, 0, 0}}};
  query.t_max = t_max;
  return query;
}

}  // namespace ccdfuzz
