#include "certify/oracle/is_readable.hpp"

#include <algorithm>
#include <tuple>
#include <variant>

namespace ccdfuzz {

namespace {

bool all_readable(const Integer& x) {
  return is_readable(Rational(x));
}
bool all_readable(const Rational& x) {
  return is_readable(x);
}
template <class Parts>
bool all_readable(const Parts& parts) {
  return std::ranges::all_of(parts, [](const auto& part) { return all_readable(part); });
}
template <class... Parts>
bool each_readable(const Parts&... parts) {
  return (all_readable(parts) && ...);
}

struct OfClearance {
  bool operator()(const MovingPlane& x) const { return each_readable(x.normal, x.offset); }
  bool operator()(const MissTree&) const { return true; }
  bool operator()(const LinearClearance&) const { return true; }
  bool operator()(const BodyClearance& x) const { return each_readable(x.normal); }
  bool operator()(const MeshClearance& x) const { return each_readable(x.normals); }
  bool operator()(const BodyPlanes& x) const {
    return std::ranges::all_of(x.planes, [](const BodyPlanes::Plane& p) {
      return each_readable(p.from, p.normals, p.offsets, p.gap);
    });
  }
};

}  // namespace

bool is_readable(const Witness& witness) {
  return each_readable(witness.t, witness.uv, witness.weights);
}

bool is_readable(const ContactRoot& root) {
  return each_readable(root.polynomial, root.from, root.by);
}

bool is_readable(const Truth& truth) {
  const auto& [root, clearance] = std::tie(truth.contact_root, truth.clearance);
  return (!truth.witness || is_readable(*truth.witness)) && (!root || is_readable(*root)) &&
         (!truth.clear_until || is_readable(*truth.clear_until)) &&
         (!clearance ||
          (is_readable(until_of(*clearance)) && std::visit(OfClearance(), *clearance)));
}

}  // namespace ccdfuzz
