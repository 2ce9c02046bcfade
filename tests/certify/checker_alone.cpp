// The checker by itself, linked with nothing that reads files, writes or asks methods. Certificates
// are drawn for queries whose contact is known. Whatever the checker accepts must agree: a proof
// that nothing touches for a time never covers a contact. Exits 1 on a contradiction, on a refusal
// of what is true, and where a kind of certificate was accepted never.
//   checker_alone [SEED [INPUTS]]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

#include "certify/checker/check_box.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/miss_tree.hpp"
#include "certify/rising_triangle.hpp"

namespace ccdfuzz {
namespace {

/// One certificate takes at most this, so that no input takes long; planes are charged for in
/// advance.
constexpr std::uint64_t kWork = 1 << 17, kPlaneWork = 1 << 28;

using Random = std::mt19937_64;

int below(Random& random, int end) {
  return static_cast<int>(random() % static_cast<unsigned>(end));
}
double small_number(Random& random) {
  return below(random, 17) * 0.5 - 4;
}
Vec3<double> small_vector(Random& random) {
  const double x = small_number(random), y = small_number(random), z = small_number(random);
  return {x, y, z};
}

/// Two patches whose first control points, at u = v = 0, meet at the witness's time.
Case drawn_contact(Random& random) {
  constexpr std::array kShapes = {Shape::point(),  Shape::curve(1),    Shape::triangle(1),
                                  Shape::curve(2), Shape::triangle(2), Shape::tensor(1, 1)};
  Case drawn;
  const double t = below(random, 5) * 0.25;
  for (MovingPatch<double>& patch : drawn.query.patches) {
    patch.shape = kShapes[static_cast<size_t>(below(random, 6))];
    const bool is_rigid = below(random, 2) == 0;
    for (int i = 0; i < patch.shape.control_count(); ++i) {
      patch.positions.push_back(small_vector(random));
      patch.velocities.push_back(is_rigid && i > 0 ? patch.velocities[0] : small_vector(random));
    }
  }
  MovingPatch<double>&one = drawn.query.patches[0], &two = drawn.query.patches[1];
  two.positions[0] = one.positions[0] + t * (one.velocities[0] - two.velocities[0]);
  drawn.truth.witness = Witness{exact(t), {}};
  return drawn;
}

Rational time_near(Random& random, const Rational& t) {
  constexpr std::array kFactors = {0.0, 0.5, 1.0, 1.0, 1.0, 1.5};
  const Rational scaled = t * exact(kFactors[static_cast<size_t>(below(random, 6))]);
  return below(random, 4) == 0 ? Rational(scaled + Rational(1, 1 << 20)) : scaled;
}

/// A plane through the point of contact at its `until`, likely to be beside both patches.
MovingPlane drawn_plane(Random& random, const Case& known, const Rational& until) {
  MovingPlane plane{until, {}, 0};
  const MovingPatch<double>& one = known.query.patches[0];
  const Vec3<double> normal = small_vector(random);
  for (int k = 0; k < 3; ++k) {
    plane.normal[static_cast<size_t>(k)] = exact(normal[k]);
    plane.offset +=
        exact(normal[k]) * (exact(one.positions[0][k]) + until * exact(one.velocities[0][k]));
  }
  return plane;
}

/// Nodes in any order, or any bytes: mostly no tree at all.
std::string drawn_tree(Random& random) {
  TreeBits bits;
  for (int left = below(random, 3) == 0 ? 1 + below(random, 6) : 1; left > 0; --left) {
    const auto component = [&] { return below(random, 9) - 4; };
    switch (left == 1 ? 0 : below(random, 4)) {
      case 1:
        bits.split(below(random, 2));
        break;
      case 2:
        bits.time(std::uint64_t{1} << (1 + below(random, 51)));
        break;
      case 3:
        bits.outside(below(random, 2));
        break;
      default:
        bits.leaf({component(), component(), component()});
    }
  }
  std::string bytes = bits.bytes();
  if (below(random, 4) == 0) bytes[random() % bytes.size()] = static_cast<char>(random());
  return bytes;
}

/// The box about the contact of rising_triangle, with a number changed or none.
ContactBox drawn_box(Random& random) {
  ContactBox box = rising_box();
  const size_t place = random() % 3;
  switch (below(random, 5)) {
    case 0:
      box.centre[random() % 5] += small_number(random) / 1024;
      break;
    case 1:
      box.radius[place] *= small_number(random);
      break;
    case 2:
      box.inverse[place][random() % 3] += small_number(random) / 8;
      break;
    case 3:
      box.varied[place] = below(random, 6);
      break;
    default:
      break;
  }
  return box;
}

/// A linear polynomial that is 0 near t, or one that is it twice.
ContactRoot drawn_root(Random& random, const Rational& t) {
  const Rational at = time_near(random, t);
  const Integer p = at.get_num(), q = at.get_den();
  ContactRoot root{{-p, q}, at - Rational(1, 8), at + Rational(1, 8)};
  if (below(random, 4) == 0) root.polynomial = {p * p, -2 * p * q, q * q};
  if (root.from < 0) root.from = 0;
  return root;
}

struct Accepted {
  std::array<std::uint64_t, 6> counts{};  // W, M, R; P, T, L
  bool is_wrong = false;
};

/// Puts certificates of one case to the checker, and holds those that it accepts to each other.
void check_one(Random& random, Accepted& accepted) {
  const bool is_rising = below(random, 4) == 0;
  const Case known = is_rising ? rising_triangle() : drawn_contact(random);
  const Query& query = known.query;
  const Rational t = known.truth.witness->t;
  Rational touched = t;  // by this time at the latest
  const auto count = [&](size_t kind, bool is_accepted) {
    accepted.counts[kind] += is_accepted;
    return is_accepted;
  };
  if (!count(0, check_contact(query, *known.truth.witness, kWork).has_value())) {
    std::printf("a contact is refused\n");
    accepted.is_wrong = true;
  }
  if (is_rising) {
    const ContactBox box = drawn_box(random);
    if (count(1, check_box(query, box, kWork).has_value())) {
      touched = std::min(touched, box.until());
    }
  }
  if (is_linear_query(query)) {
    const ContactRoot root = drawn_root(random, t);
    if (count(2, check_contact_root(query, root, kWork).has_value())) {
      touched = std::min(touched, root.by);
    }
  }
  const Rational until = time_near(random, t);
  const auto hold_to_contact = [&](size_t kind, const Clearance& proof, bool is_accepted) {
    if (!count(kind, is_accepted) || !covers(proof, touched)) return;
    std::printf("a proof of absence until %s covers a contact by %s\n", to_text(until).c_str(),
                to_text(touched).c_str());
    accepted.is_wrong = true;
  };
  const MovingPlane plane = drawn_plane(random, known, until);
  hold_to_contact(3, plane, check_plane(query, plane, kPlaneWork).has_value());
  hold_to_contact(4, MissTree{until, {}},
                  check_tree(query, until, drawn_tree(random), kWork).has_value());
  if (!is_linear_query(query)) return;
  const LinearClearance linear{until, below(random, 2) == 0};
  hold_to_contact(5, linear, check_linear_clearance(query, linear, kWork).has_value());
}

int run(std::uint64_t seed, std::uint64_t inputs) {
  Random random(seed);
  Accepted accepted;
  for (std::uint64_t i = 0; i < inputs; ++i) check_one(random, accepted);
  for (size_t i = 0; i < accepted.counts.size(); ++i) {
    std::printf("%c %llu\n", "WMRPTL"[i], static_cast<unsigned long long>(accepted.counts[i]));
  }
  const bool has_all = *std::min_element(accepted.counts.begin(), accepted.counts.end()) > 0;
  return accepted.is_wrong || !has_all ? 1 : 0;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  const auto number = [&](int i, std::uint64_t otherwise) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  return ccdfuzz::run(number(1, 1), number(2, 5000));
}
