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

/// A vertex that falls through the unit triangle at t = 1/2, where u = x and v = y.
inline Query falling_vertex(double x = 0.25, double y = 0.25) {
  Query query;
  query.patches[0] = {Shape::point(), {{x, y, 1}}, {{0, 0, -2}}};
  query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Points<double>(3, {0, 0, 0})};
  return query;
}

}  // namespace ccdfuzz
