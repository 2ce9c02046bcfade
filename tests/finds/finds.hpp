#pragma once

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "files/case_json.hpp"
#include "finds/store.hpp"

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

inline Store open_store(const std::string& folder) {
  auto store = Store::open(folder);
  if (!store) throw std::runtime_error(store.error().message());
  return *std::move(store);
}

/// Puts a find for the first failure that it expects.
inline Result<Store::Put> try_put(Store& store, const Case& find) {
  return store.put(failures_of(find).front(), find);
}
inline Store::Put put(Store& store, const Case& find) {
  const auto done = try_put(store, find);
  if (!done) throw std::runtime_error(done.error().message());
  return *done;
}

inline std::vector<Case> cases_in(const std::string& folder) {
  std::vector<Case> cases;
  const auto read =
      for_each_entry(folder, [&](const NamedCase& entry) { cases.push_back(entry.value); });
  if (!read) throw std::runtime_error(read.error().message());
  return cases;
}

}  // namespace ccdfuzz
