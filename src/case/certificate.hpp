#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// Certificate M: a box in parameters and time that holds a contact, by Poincaré–Miranda.
///
/// The unknowns are (x1, y1, x2, y2, t). Those of a patch are its parameters u, v. A triangle has
/// the barycentrics (w, u, v) numbered 0, 1, 2. Its unknowns are the two that follow `dependent` in
/// the cycle, and the remaining one is 1 minus their sum. So an edge of any kind is a fixed
/// unknown. Three unknowns vary by ±radius about the centre, the others stay there. `inverse` is
/// any regular matrix, usually near the inverse of the Jacobian of S1 − S2 in the three. Row i
/// makes component i of inverse·(S1 − S2) change its sign from one face of unknown i to the
/// opposite one.
struct ContactBox {
  std::array<double, 5> centre{};
  std::array<int, 2> dependent{};  ///< 0..2 for a triangle, else 0
  std::array<int, 3> varied{};     ///< ascending places in centre
  std::array<double, 3> radius{};  ///< > 0, of the unknowns in varied
  std::array<std::array<double, 3>, 3> inverse{};

  static constexpr int kTime = 4;

  /// A time by which the contact has come.
  Rational until() const {
    const Rational t = exact(centre[kTime]);
    return varied[2] == kTime ? Rational(t + exact(radius[2])) : t;
  }

  friend bool operator==(const ContactBox&, const ContactBox&) = default;
};

/// The highest degree that a ContactRoot's polynomial may have in a file. It divides a polynomial
/// of degree 10 or less (check_linear.hpp), so higher degrees prove nothing new; proofs have 6 or
/// less.
inline constexpr size_t kMaxRootDegree = 16;

/// Certificate R: a root of a polynomial in time, at which two linear patches are in contact.
struct ContactRoot {
  std::vector<Integer> polynomial;  ///< polynomial[k] belongs to t^k
  Rational from, by;                ///< the root is between them, where the sign changes

  friend bool operator==(const ContactRoot&, const ContactRoot&) = default;
};

/// Certificate P: a plane that moves along with the patches and separates them at every t in the
/// half-open [0, until). At t = until it is normal·x = offset. Patch 2 is behind it then, and patch
/// 1 beyond it by the query's separation.
struct MovingPlane {
  static constexpr bool closed = false;
  Rational until;
  Vec3<Rational> normal;  ///< towards patch 1
  Rational offset;

  friend bool operator==(const MovingPlane&, const MovingPlane&) = default;
};

/// A miss tree, as certify/checker/miss_tree.hpp says. Empty: it stood in another file, as earlier
/// versions kept it, and is not known.
struct TreeBytes {
  std::string bytes;

  friend bool operator==(const TreeBytes&, const TreeBytes&) = default;
};

/// Certificate T: a tree of separating axes that covers all pairs of parts of the patches at every
/// t in the closed [0, until].
struct MissTree {
  static constexpr bool closed = true;
  /// The largest of the paper's set has 850 kB; it bounds what a wrong file takes.
  static constexpr size_t kMaxBytes = 2 << 20;
  Rational until;
  TreeBytes tree;  ///< at most kMaxBytes

  friend bool operator==(const MissTree&, const MissTree&) = default;
};

/// Certificate L: two linear patches are farther apart than the separation in [0, until), or in the
/// closed [0, until]. It carries nothing, as the checker decides that by itself.
struct LinearClearance {
  Rational until;
  bool closed = false;

  friend bool operator==(const LinearClearance&, const LinearClearance&) = default;
};

/// Certificate K: a direction along which two bodies are farther apart than their radii and the
/// separation, at every t in [0, until), or in the closed [0, until].
struct BodyClearance {
  Rational until;
  Vec3<Rational> normal;  ///< towards patch 2
  bool closed = false;

  friend bool operator==(const BodyClearance&, const BodyClearance&) = default;
};

/// Certificate N: planes between two bodies, one after another, at every t in the closed
/// [0, until]. From its time to that of the next, or to `until`, normal and offset of a plane
/// change linearly. Patch 1 is at normal·x ≤ offset, and patch 2 at normal·x ≥ offset + gap.
struct BodyPlanes {
  static constexpr bool closed = true;
  struct Plane {
    Rational from;
    std::array<Vec3<Rational>, 2> normals;  ///< at its two ends; towards patch 2
    std::array<Rational, 2> offsets;        ///< at its two ends
    Rational gap;

    friend bool operator==(const Plane&, const Plane&) = default;
  };
  Rational until;
  std::vector<Plane> planes;

  friend bool operator==(const BodyPlanes&, const BodyPlanes&) = default;
};

/// Certificate F: certificate K of each face of a mesh that is there (mesh.hpp), in their order.
/// Its normals are towards patch 2, one per face.
struct MeshClearance {
  Rational until;
  std::vector<Vec3<Rational>> normals;
  bool closed = false;

  friend bool operator==(const MeshClearance&, const MeshClearance&) = default;
};

/// Proof that nothing touches for a time.
using Clearance =
    std::variant<MovingPlane, MissTree, LinearClearance, BodyClearance, BodyPlanes, MeshClearance>;

inline const Rational& until_of(const Clearance& clearance) {
  return std::visit([](const auto& c) -> const Rational& { return c.until; }, clearance);
}

/// True iff the clearance, if it holds, proves absence of contact in the closed [0, t].
inline bool covers(const Clearance& clearance, const Rational& t) {
  const Rational& until = until_of(clearance);
  const bool closed = std::visit([](const auto& c) { return c.closed; }, clearance);
  return closed ? t <= until : t < until;
}

}  // namespace ccdfuzz
