#pragma once

#include <ostream>
#include <string>

#include "query/case_json.hpp"

namespace ccdfuzz {

inline void PrintTo(const Case& value, std::ostream* out) {
  *out << to_json(value);
}

/// A point at x that meets a point at rest in the origin at t = 1: a true contact, whose size
/// grows with the bits of x.
inline Case find_of(double x, const std::string& method = "tdibm",
                    Outcome outcome = Outcome::kMissed, const std::string& contact = "VV") {
  Case c;
  c.query.patches[0] = {Shape::point(), {{x, 0, 0}}, {{-x, 0, 0}}};
  c.query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  c.truth.collides = true;
  c.truth.witness = Witness{Rational(1), {}};
  c.origin.contact = contact;
  c.origin.kind = "RP";
  c.origin.generator = "by hand";
  c.expect[method] = outcome;
  return c;
}

}  // namespace ccdfuzz
