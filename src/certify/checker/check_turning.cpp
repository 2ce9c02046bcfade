#include "certify/checker/check_turning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "certify/checker/abbreviated.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kPlanes = "truth.certificate.clear";

/// A polynomial on an interval: Bernstein coefficients times binomials. So a product is one of the
/// numbers alone, and (1, 1) is the constant 1.
using Polynomial = std::vector<Rational>;
using Numbers = std::vector<Rational>;

/// Arithmetic that is charged for.
class Charged {
 public:
  explicit Charged(Work& work) : work_(work) {}

  Rational product(const Rational& a, const Rational& b) {
    work_.charge(product_work(a, b));
    return a * b;
  }
  void add(Rational& sum, const Rational& x) {
    work_.charge(product_work(sum, x));
    sum += x;
  }
  Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial out(a.size() + b.size() - 1);
    for (size_t i = 0; i < a.size(); ++i) {
      for (size_t j = 0; j < b.size(); ++j) add(out[i + j], product(a[i], b[j]));
    }
    return out;
  }
  /// The sum, of which one may be of a lower degree.
  Polynomial sum(Polynomial a, Polynomial b) {
    while (a.size() < b.size()) a = product(a, {1, 1});
    while (b.size() < a.size()) b = product(b, {1, 1});
    for (size_t i = 0; i < a.size(); ++i) add(a[i], b[i]);
    return a;
  }
  Polynomial times(const Rational& factor, Polynomial p) {
    for (Rational& c : p) c = product(factor, c);
    return p;
  }
  Rational dot(const Numbers& a, const Numbers& b) {
    Rational out = 0;
    for (size_t i = 0; i < a.size(); ++i) add(out, product(a[i], b[i]));
    return out;
  }
  /// (1 − t)·from + t·to
  Numbers between(const std::vector<double>& from, const std::vector<double>& to,
                  const Rational& t) {
    Numbers out;
    for (size_t i = 0; i < from.size(); ++i) {
      out.push_back(product(1 - t, exact(from[i])));
      add(out[i], product(t, exact(to[i])));
    }
    return out;
  }

 private:
  Work& work_;
};

/// The entry of the matrix p ↦ q p q* of two quaternions, symmetric in them.
Rational entry(const Numbers& q, const Numbers& r, size_t row, size_t column, Charged& with) {
  const auto twice = [&](size_t i, size_t j) {
    Rational sum = with.product(q[i], r[j]);
    with.add(sum, with.product(q[j], r[i]));
    return sum;
  };
  if (row != column) {
    // 2(q_i q_j ± q_0 q_k), with + where k follows i and j in the cycle in reverse.
    const size_t i = row + 1, j = column + 1, k = 6 - i - j;
    const Rational turned = twice(0, k), both = twice(i, j);
    return (row + 1) % 3 == column ? Rational(both - turned) : Rational(both + turned);
  }
  Rational sum = with.product(q[0], r[0]);
  for (size_t i = 1; i < 4; ++i) {
    const Rational square = with.product(q[i], r[i]);
    with.add(sum, i == row + 1 ? square : Rational(-square));
  }
  return sum;
}

/// The root of x ≥ 0, rounded up by less than 2^-64 of what it is, or exact.
Rational root_above(const Rational& x, Work& work) {
  constexpr unsigned long kBits = 64;
  work.charge(4 * product_work(x, x));
  // √(p/q) = √(p·q·4^k) / (q·2^k)
  const Integer scaled = Integer(x.get_num() * x.get_den()) << (2 * kBits);
  Integer root = sqrt(scaled);
  if (root * root < scaled) ++root;
  Rational out(root, Integer(x.get_den() << kBits));
  out.canonicalize();
  return out;
}

/// A plane in a part of its time.
struct Piece {
  Rational from, until;
  std::array<Polynomial, 3> normal;
  Polynomial offset;
};

/// A body above, of sign 1, or below a plane.
class HeightCheck {
 public:
  HeightCheck(const MovingPatch<double>& body, const Piece& piece, int sign, Work& work)
      : body_(body), piece_(piece), sign_(sign), work_(work), with_(work) {
    if (!body.turn) {
      scales_ = {{1}};
      rows_ = piece.normal;
      return;
    }
    from_ = with_.between(body.turn->from, body.turn->to, piece.from);
    until_ = with_.between(body.turn->from, body.turn->to, piece.until);
    body.turn->is_quaternion() ? turn_by_quaternion() : turn_by_angle();
  }

  /// Whether all points are on their side of the plane.
  bool holds() {
    const Vec3<double> centre = body_.turn ? body_.turn->centre : Vec3<double>(0, 0, 0);
    Polynomial height = with_.times(-1, piece_.offset);
    for (int k = 0; k < 3; ++k) {
      const Rational velocity = exact(body_.velocities[0][k]);
      Polynomial place = {with_.product(piece_.from, velocity),
                          with_.product(piece_.until, velocity)};
      for (Rational& x : place) with_.add(x, exact(centre[k]));
      height = with_.sum(height, with_.product(piece_.normal[static_cast<size_t>(k)], place));
    }
    return std::ranges::all_of(scales_, [&](const Polynomial& scale) {
      const Polynomial base = with_.product(height, scale);
      const bool by_angle = body_.turn && !body_.turn->is_quaternion();
      std::array<Polynomial, 3> rows = rows_;
      if (by_angle) rows[2] = with_.product(piece_.normal[2], scale);
      for (Polynomial& row : rows) row = with_.sum(row, Polynomial(base.size(), 0));
      return std::ranges::all_of(body_.positions, [&](const Vec3<double>& p) {
        Polynomial sum = base;
        for (int k = 0; k < 3; ++k) {
          const Rational from_centre = exact(p[k]) - exact(centre[k]);
          sum = with_.sum(sum, with_.times(from_centre, rows[static_cast<size_t>(k)]));
        }
        return std::ranges::all_of(sum, [&](const Rational& c) { return sign_ * sgn(c) >= 0; });
      });
    });
  }

 private:
  void turn_by_quaternion() {
    scales_ = {{with_.dot(from_, from_), 2 * with_.dot(from_, until_), with_.dot(until_, until_)}};
    for (size_t column = 0; column < 3; ++column) {
      rows_[column] = {0};
      for (size_t row = 0; row < 3; ++row) {
        const Polynomial matrix = {entry(from_, from_, row, column, with_),
                                   Rational(2 * entry(from_, until_, row, column, with_)),
                                   entry(until_, until_, row, column, with_)};
        rows_[column] = with_.sum(rows_[column], with_.product(piece_.normal[row], matrix));
      }
    }
  }

  void turn_by_angle() {
    const Polynomial cosine = {from_[0], until_[0]}, sine = {from_[1], until_[1]};
    const auto& [x, y, z] = piece_.normal;
    rows_[0] = with_.sum(with_.product(x, cosine), with_.product(y, sine));
    rows_[1] = with_.sum(with_.product(y, cosine), with_.times(-1, with_.product(x, sine)));
    Numbers along = {from_[0] + until_[0], from_[1] + until_[1]};
    const Rational length = root_above(with_.dot(along, along), work_);
    for (Rational& c : along) c = with_.product(c, 1 / length);
    scales_ = {
        {with_.dot(from_, along), with_.dot(until_, along)},
        {root_above(with_.dot(from_, from_), work_), root_above(with_.dot(until_, until_), work_)}};
  }

  const MovingPatch<double>& body_;
  const Piece& piece_;
  const int sign_;
  Work& work_;
  Charged with_;
  Numbers from_, until_;            ///< q at the ends of the piece
  std::vector<Polynomial> scales_;  ///< D, or what it is between
  std::array<Polynomial, 3> rows_;  ///< the normal times the matrix of the turn, times D
};

Result<void> check_between(const Query& query, const BodyPlanes::Plane& plane,
                           const Rational& until, Work& work) {
  const auto refuse = [](std::string what) { return input_error(kPlanes, std::move(what)); };
  Piece piece{plane.from, until, {}, {}};
  if (piece.until < piece.from) return refuse("a plane ends before it begins");
  if (has_turns(query) && until > 1) {
    return refuse(fmt::format("until: {} is past 1, where {}", abbreviated(until), kEndOfMotion));
  }
  const Rational reach =
      exact(query.separation) + exact(query.patches[0].radius) + exact(query.patches[1].radius);
  Charged with(work);
  for (const auto& n : plane.normals) {
    const Numbers normal(n.begin(), n.end());
    const Rational kept = with.product(with.product(reach, reach), with.dot(normal, normal));
    if (plane.gap > 0 && with.product(plane.gap, plane.gap) > kept) continue;
    return refuse(fmt::format("gap: {} does not keep the bodies apart", abbreviated(plane.gap)));
  }
  for (size_t k = 0; k < 3; ++k) piece.normal[k] = {plane.normals[0][k], plane.normals[1][k]};
  piece.offset = {plane.offsets[0], plane.offsets[1]};
  const bool is_below = HeightCheck(query.patches[0], piece, -1, work).holds();
  for (Rational& x : piece.offset) with.add(x, plane.gap);
  if (is_below && HeightCheck(query.patches[1], piece, 1, work).holds()) return {};
  return refuse(fmt::format("patches[{}] is not seen to stay on its side of a plane from {} on",
                            is_below ? 1 : 0, abbreviated(plane.from)));
}

Result<void> check_planes_of_bodies(const Query& query, const BodyPlanes& clearance, Work& work) {
  const auto& [until, planes] = clearance;
  if (planes.empty() || planes[0].from != 0) return input_error(kPlanes, "no plane begins at 0");
  for (size_t i = 0; i < planes.size(); ++i) {
    const Rational& end = i + 1 < planes.size() ? planes[i + 1].from : until;
    if (auto checked = check_between(query, planes[i], end, work); !checked) return checked;
  }
  return {};
}

}  // namespace

std::optional<Vec3<Rational>> moved_point(const MovingPatch<double>& body, const Vec3<Rational>& p,
                                          const Rational& t, Work& work) {
  Charged with(work);
  Vec3<Rational> out = p;
  if (body.turn) {
    const BodyTurn& turn = *body.turn;
    const Numbers q = with.between(turn.from, turn.to, t);
    Rational scale = with.dot(q, q);
    Vec3<Rational> way;
    for (int k = 0; k < 3; ++k) way[k] = p[k] - exact(turn.centre[k]);
    if (turn.is_quaternion()) {
      for (size_t row = 0; row < 3; ++row) {
        Rational sum = 0;
        for (size_t column = 0; column < 3; ++column) {
          with.add(sum,
                   with.product(entry(q, q, row, column, with), way[static_cast<int>(column)]));
        }
        out[static_cast<int>(row)] = sum;
      }
    } else {
      const Rational root = root_above(scale, work);
      if (root * root != scale) return std::nullopt;
      scale = root;
      out = {Rational(with.product(q[0], way[0]) - with.product(q[1], way[1])),
             Rational(with.product(q[1], way[0]) + with.product(q[0], way[1])),
             with.product(scale, way[2])};
    }
    for (int k = 0; k < 3; ++k) {
      out[k] = with.product(out[k], 1 / scale);
      with.add(out[k], exact(turn.centre[k]));
    }
  }
  for (int k = 0; k < 3; ++k) with.add(out[k], with.product(t, exact(body.velocities[0][k])));
  return out;
}

Result<void> check_body_plane(const Query& query, const BodyPlanes::Plane& plane,
                              const Rational& until, std::uint64_t most_work) {
  return within_work(kPlanes, most_work,
                     [&](Work& work) { return check_between(query, plane, until, work); });
}

Result<void> check_body_planes(const Query& query, const BodyPlanes& clearance,
                               std::uint64_t most_work) {
  return within_work(kPlanes, most_work,
                     [&](Work& work) { return check_planes_of_bodies(query, clearance, work); });
}

}  // namespace ccdfuzz
