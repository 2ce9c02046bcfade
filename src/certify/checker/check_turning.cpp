#include "certify/checker/check_turning.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/verify.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/spin.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kPlanes = "truth.certificate.clear";

/// A polynomial on an interval: Bernstein coefficients times binomials. So a product is one of the
/// numbers alone, and (1, 1) is the constant 1.
using Polynomial = std::vector<Fraction>;
using Numbers = std::vector<Fraction>;
/// w, x, y, z.
using Quaternion = std::array<Polynomial, 4>;

constexpr auto real = from_double<Fraction>;

/// Arithmetic that is charged for.
class Charged {
 public:
  explicit Charged(Work& work) : work_(work) {}

  Fraction product(const Fraction& a, const Fraction& b) {
    work_.charge(product_work(a, b));
    return a * b;
  }
  void add(Fraction& sum, const Fraction& x) {
    work_.charge(product_work(sum, x));
    sum += x;
  }
  void add_product(Fraction& sum, const Fraction& a, const Fraction& b) {
    work_.charge(product_work(a, b));
    add(sum, product_.set_product(a, b));
  }
  Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial out(a.size() + b.size() - 1);
    for (size_t i = 0; i < a.size(); ++i) {
      for (size_t j = 0; j < b.size(); ++j) add_product(out[i + j], a[i], b[j]);
    }
    return out;
  }
  /// The sum, of which one may be of a lower degree.
  Polynomial sum(Polynomial a, const Polynomial& b) {
    static const Polynomial one = {1, 1};
    while (a.size() < b.size()) a = product(a, one);
    if (b.size() < a.size()) return sum(std::move(a), product(b, one));
    for (size_t i = 0; i < a.size(); ++i) add(a[i], b[i]);
    return a;
  }
  Polynomial times(const Fraction& factor, Polynomial p) {
    for (Fraction& c : p) c = product(factor, c);
    return p;
  }
  Fraction dot(const Numbers& a, const Numbers& b) {
    Fraction out = 0;
    for (size_t i = 0; i < a.size(); ++i) add_product(out, a[i], b[i]);
    return out;
  }
  /// (1 − t)·from + t·to
  Numbers between(const std::vector<double>& from, const std::vector<double>& to,
                  const Fraction& t) {
    Numbers out;
    for (size_t i = 0; i < from.size(); ++i) {
      out.push_back(product(1 - t, real(from[i])));
      add(out[i], product(t, real(to[i])));
    }
    return out;
  }

 private:
  Work& work_;
  Fraction product_;  ///< keeps its memory
};

/// The matrix p ↦ q p q* of a quaternion.
std::array<std::array<Polynomial, 3>, 3> matrix_of(const Quaternion& q, Charged& with) {
  std::array<Quaternion, 4> products;
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j <= i; ++j) products[i][j] = products[j][i] = with.product(q[i], q[j]);
  }
  std::array<std::array<Polynomial, 3>, 3> out;
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      Polynomial& sum = out[row][column];
      if (row == column) {
        sum = products[0][0];
        for (size_t i = 1; i < 4; ++i) {
          sum = with.sum(std::move(sum), with.times(i == row + 1 ? 1 : -1, products[i][i]));
        }
      } else {
        // 2(q_i q_j ± q_0 q_k), with + where k follows i and j in the cycle in reverse.
        const size_t i = row + 1, j = column + 1, k = 6 - i - j;
        const int sign = (row + 1) % 3 == column ? -1 : 1;
        sum = with.times(2, with.sum(products[i][j], with.times(sign, products[0][k])));
      }
    }
  }
  return out;
}

/// The product of two quaternions.
Quaternion product(const Quaternion& a, const Quaternion& b, Charged& with) {
  Quaternion out;
  for (size_t i = 0; i < 4; ++i) {
    // The product of parts i and j is part i^j, as 1·2 = 3 in the cycle.
    for (size_t j = 0; j < 4; ++j) {
      const bool is_positive = i == 0 || j == 0 || (i != j && (j + 3 - i) % 3 == 1);
      Polynomial& part = out[i ^ j];
      part = with.sum(std::move(part), with.times(is_positive ? 1 : -1, with.product(a[i], b[j])));
    }
  }
  return out;
}

/// A plane in a part of its time.
struct Piece {
  Fraction from, until;
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
    if (body.turn->is_spin()) {
      turn_by_spin();
      return;
    }
    from_ = with_.between(body.turn->from, body.turn->to, piece.from);
    until_ = with_.between(body.turn->from, body.turn->to, piece.until);
    body.turn->is_quaternion() ? turn_by_linear_quaternion() : turn_by_angle();
  }

  /// Whether all points are on their side of the plane.
  bool holds() {
    const Vec3<double> centre = body_.turn ? body_.turn->centre : Vec3<double>(0, 0, 0);
    Polynomial height =
        with_.sum(with_.times(-1, piece_.offset), Polynomial{sign_ > 0 ? -margin_ : margin_});
    for (int k = 0; k < 3; ++k) {
      const Fraction velocity = real(body_.velocities[0][k]);
      Polynomial place = {with_.product(piece_.from, velocity),
                          with_.product(piece_.until, velocity)};
      for (Fraction& x : place) with_.add(x, real(centre[k]));
      height =
          with_.sum(std::move(height), with_.product(piece_.normal[static_cast<size_t>(k)], place));
    }
    return std::ranges::all_of(scales_, [&](const Polynomial& scale) {
      Polynomial base = with_.product(height, scale);
      std::array<Polynomial, 3> rows = rows_;
      if (is_by_angle_) rows[2] = with_.product(piece_.normal[2], scale);
      base = with_.sum(std::move(base), Polynomial(rows[0].size(), 0));
      for (Polynomial& row : rows) {
        row = with_.sum(std::move(row), Polynomial(base.size(), 0));
        CCDFUZZ_VERIFY(row.size() == base.size());
      }
      Polynomial sum;
      return std::ranges::all_of(body_.positions, [&](const Vec3<double>& p) {
        sum = base;
        for (int k = 0; k < 3; ++k) {
          const Fraction from_centre = real(p[k]) - real(centre[k]);
          const Polynomial& row = rows[static_cast<size_t>(k)];
          for (size_t i = 0; i < sum.size(); ++i) with_.add_product(sum[i], from_centre, row[i]);
        }
        return std::ranges::all_of(sum, [&](const Fraction& c) { return sign_ * sgn(c) >= 0; });
      });
    });
  }

 private:
  void turn_by(const Quaternion& q) {
    const auto matrix = matrix_of(q, with_);
    for (size_t column = 0; column < 3; ++column) {
      rows_[column] = {0};
      for (size_t row = 0; row < 3; ++row) {
        rows_[column] = with_.sum(std::move(rows_[column]),
                                  with_.product(piece_.normal[row], matrix[row][column]));
      }
    }
  }

  void turn_by_linear_quaternion() {
    Quaternion q;
    scales_ = {{0}};
    for (size_t i = 0; i < 4; ++i) {
      q[i] = {from_[i], until_[i]};
      scales_[0] = with_.sum(scales_[0], with_.product(q[i], q[i]));
    }
    turn_by(q);
  }

  /// By a polynomial near its quaternion, and what that can be off by.
  void turn_by_spin() {
    scales_ = {{1}};
    const std::vector<double>& spin = body_.turn->spin;
    const auto start = quaternion_of_spin(spin, piece_.from.rational(), work_);
    // With v = w·(until − from)/2 and x = |v|², the rest turns by the series of (cos |v|s, sin |v|s
    // / |v| · v) up to s².
    Numbers v;
    for (const double w : spin) {
      v.push_back(with_.product(real(w) / 2, piece_.until - piece_.from));
    }
    const Fraction x = with_.dot(v, v);
    Quaternion rest = {with_.sum({1}, {0, 0, -x / 2}), {0, v[0]}, {0, v[1]}, {0, v[2]}};
    Quaternion first;
    for (size_t i = 0; i < 4; ++i) first[i] = {start[i]};
    Quaternion q = product(first, rest, with_);
    for (Polynomial& part : q) {
      for (Fraction& c : part) c = rounded(c);
    }
    turn_by(q);
    margin_ = margin_of_spin(with_.product(x, root_of(x)) / 6);
  }

  /// Towards 0, by less than spin_error.
  Fraction rounded(const Fraction& x) {
    const Fraction unit = spin_error();
    work_.charge(product_work(x, unit));
    const Integer units = floor_of_ratio(x.sign() < 0 ? -x : x, unit);
    return Fraction(Dyadic(Integer(x.sign() * units), 0)) * unit;
  }

  Fraction root_of(const Fraction& x) { return root_above(x.rational(), work_); }

  /// What heights can be off by, with a quaternion of the rest that is off by so much.
  Fraction margin_of_spin(const Fraction& error_of_rest) {
    const Fraction of_start = spin_error();
    const Fraction error = with_.product(1 + of_start, error_of_rest) + 3 * of_start;
    Fraction farthest = 0, longest = 0;
    for (const Vec3<double>& p : body_.positions) {
      Numbers way;
      for (int k = 0; k < 3; ++k) way.push_back(real(p[k]) - real(body_.turn->centre[k]));
      farthest = std::max(farthest, with_.dot(way, way));
    }
    for (const size_t end : {size_t{0}, size_t{1}}) {
      const auto& [a, b, c] = piece_.normal;
      const Numbers normal = {a[end], b[end], c[end]};
      longest = std::max(longest, with_.dot(normal, normal));
    }
    const Fraction length = with_.product(root_of(longest), root_of(farthest));
    return with_.product(with_.product(error, 2 + error), length);
  }

  void turn_by_angle() {
    is_by_angle_ = true;
    const Polynomial cosine = {from_[0], until_[0]}, sine = {from_[1], until_[1]};
    const auto& [x, y, z] = piece_.normal;
    rows_[0] = with_.sum(with_.product(x, cosine), with_.product(y, sine));
    rows_[1] = with_.sum(with_.product(y, cosine), with_.times(-1, with_.product(x, sine)));
    Numbers along = {from_[0] + until_[0], from_[1] + until_[1]};
    const Fraction length = root_of(with_.dot(along, along));
    for (Fraction& c : along) c = with_.product(c, 1 / length);
    scales_ = {{with_.dot(from_, along), with_.dot(until_, along)},
               {root_of(with_.dot(from_, from_)), root_of(with_.dot(until_, until_))}};
  }

  const MovingPatch<double>& body_;
  const Piece& piece_;
  const int sign_;
  Work& work_;
  Charged with_;
  Numbers from_, until_;            ///< q at the ends of the piece
  std::vector<Polynomial> scales_;  ///< D, or what it is between
  std::array<Polynomial, 3> rows_;  ///< the normal times the matrix of the turn, times D
  Fraction margin_ = 0;             ///< what heights may be off by
  bool is_by_angle_ = false;
};

Result<void> check_between(const Query& query, const BodyPlanes::Plane& plane,
                           const Rational& until, Work& work) {
  const auto refuse = [](std::string what) { return input_error(kPlanes, std::move(what)); };
  Piece piece{plane.from, until, {}, {}};
  if (piece.until < piece.from) return refuse("a plane ends before it begins");
  if (has_turns(query) && until > 1) {
    return refuse(
        fmt::format("until: {} is past 1, where {}", abbreviated(until), end_of_motion(query)));
  }
  const Fraction reach =
      real(query.separation) + real(query.patches[0].radius) + real(query.patches[1].radius);
  Charged with(work);
  for (const auto& n : plane.normals) {
    const Numbers normal(n.begin(), n.end());
    const Fraction kept = with.product(with.product(reach, reach), with.dot(normal, normal));
    if (plane.gap > 0 && with.product(plane.gap, plane.gap) > kept) continue;
    return refuse(fmt::format("gap: {} does not keep the bodies apart", abbreviated(plane.gap)));
  }
  for (int k = 0; k < 3; ++k) {
    piece.normal[static_cast<size_t>(k)] = {plane.normals[0][k], plane.normals[1][k]};
  }
  piece.offset = {plane.offsets[0], plane.offsets[1]};
  const bool is_below = HeightCheck(query.patches[0], piece, -1, work).holds();
  for (Fraction& x : piece.offset) with.add(x, plane.gap);
  if (is_below && HeightCheck(query.patches[1], piece, 1, work).holds()) return {};
  return refuse(fmt::format("patches[{}] is not seen to stay on its side of a plane from {} on",
                            is_below ? 1 : 0, abbreviated(plane.from)));
}

Result<void> check_planes_of_bodies(const Query& query, const BodyPlanes& clearance, Work& work) {
  const auto& [until, planes] = clearance;
  if (planes.empty() || planes[0].from != 0) return input_error(kPlanes, "no plane begins at 0");
  for (size_t i = 0; i < planes.size(); ++i) {
    const Rational& end = i + 1 < planes.size() ? planes[i + 1].from : until;
    CCDFUZZ_TRY_VOID(check_between(query, planes[i], end, work));
  }
  return {};
}

}  // namespace

Rational root_above(const Rational& x, Work& work, unsigned long bits) {
  work.charge(4 * product_work(x, x));
  // √(p/q) = √(p·q·4^k) / (q·2^k)
  const Integer scaled = Integer(x.get_num() * x.get_den()) << (2 * bits);
  Integer root = sqrt(scaled);
  if (root * root < scaled) ++root;
  return Rational(root) / Integer(x.get_den() << bits);
}

MovedPoint moved_point(const MovingPatch<double>& body, const Vec3<Rational>& p, const Rational& t,
                       Work& work) {
  Charged with(work);
  MovedPoint out;
  Numbers at{p[0], p[1], p[2]};
  if (body.turn) {
    const BodyTurn& turn = *body.turn;
    Vec3<Rational> way;
    for (int k = 0; k < 3; ++k) way[k] = p[k] - exact(turn.centre[k]);
    Numbers q = with.between(turn.from, turn.to, t);
    Fraction scale = with.dot(q, q);
    const Rational length = abs(way[0]) + abs(way[1]) + abs(way[2]);
    if (turn.is_spin()) {
      const auto spun = quaternion_of_spin(turn.spin, t, work);
      q.assign(spun.begin(), spun.end());
      scale = 1;
      // |q p q* − r p r*| ≤ |q − r|·(|q| + |r|)·|p|, and |p| ≤ |x| + |y| + |z|.
      const Fraction error = spin_error();
      out.error = with.product(with.product(error, 2 + error), length).rational();
      // If w·t = 0, the quaternion is exactly 1.
      const auto is_zero = [](double w) { return exact(w) == 0; };
      if (t == 0 || std::ranges::all_of(turn.spin, is_zero)) out.error = 0;
    }
    if (q.size() == 4) {
      const auto matrix = matrix_of({Polynomial{q[0]}, {q[1]}, {q[2]}, {q[3]}}, with);
      for (size_t row = 0; row < 3; ++row) {
        Fraction sum = 0;
        for (size_t column = 0; column < 3; ++column) {
          with.add(sum, with.product(matrix[row][column][0], way[static_cast<int>(column)]));
        }
        at[row] = sum;
      }
    } else {
      constexpr unsigned long kRootBits = kSpinErrorBits;
      const Fraction root = root_above(scale.rational(), work, kRootBits);
      // Where the root is too long by a part of it, all ways from the axis are too short by that.
      if (root * root != scale) out.error = power_of_two(-long{kRootBits}) * length;
      scale = root;
      at = {with.product(q[0], way[0]) - with.product(q[1], way[1]),
            with.product(q[1], way[0]) + with.product(q[0], way[1]), with.product(scale, way[2])};
    }
    for (size_t k = 0; k < 3; ++k) {
      at[k] = with.product(at[k], 1 / scale);
      with.add(at[k], real(turn.centre[static_cast<int>(k)]));
    }
  }
  for (int k = 0; k < 3; ++k) {
    Fraction& x = at[static_cast<size_t>(k)];
    with.add(x, with.product(t, real(body.velocities[0][k])));
    out.point[k] = x.rational();
  }
  return out;
}

Result<void> check_body_plane(const Query& query, const BodyPlanes::Plane& plane,
                              const Rational& until) {
  return within_work(kPlanes, kMostWork, check_between, query, plane, until);
}

Result<void> check_body_planes(const Query& query, const BodyPlanes& clearance) {
  return within_work(kPlanes, kMostWork, check_planes_of_bodies, query, clearance);
}

}  // namespace ccdfuzz
