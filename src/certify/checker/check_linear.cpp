#include "certify/checker/check_linear.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>

#include "certify/checker/abbreviated.hpp"
#include "certify/checker/linear_directions.hpp"

namespace ccdfuzz {

namespace {

/// What the header speaks of, each multiplied out when it is asked for.
class Products {
 public:
  Products(const Triangle& triangle, Work& work) : work_(work), p_(points_of(triangle)) {
    for (size_t i = 0; i < 3; ++i) n_[i] = cross_of(p_[(i + 1) % 3], p_[(i + 2) % 3], work);
  }

  Form d3() const { return dot_of(p_[0], n_[0], work_); }
  Form m() const { return square(n_[0]) + square(n_[1]) + square(n_[2]); }
  Form s(size_t i) const { return dot_of(n_[(i + 1) % 3], n_[(i + 2) % 3], work_); }
  Form d(size_t i) const { return dot_of(p_[(i + 1) % 3], p_[(i + 2) % 3], work_); }

 private:
  Form square(const FormVector& a) const { return dot_of(a, a, work_); }

  Work& work_;
  std::array<FormVector, 3> p_, n_;
};

/// Whether they touch. Its forms: D, m, the s_i and the d_i.
struct TouchTest {
  Work& work;

  std::vector<Form> forms_of(const Triangle& triangle) const {
    const Products of(triangle, work);
    std::vector<Form> out = {of.d3(), of.m()};
    for (size_t i = 0; i < 3; ++i) out.push_back(of.s(i));
    for (size_t i = 0; i < 3; ++i) out.push_back(of.d(i));
    return out;
  }

  static std::span<const Form> s(const std::vector<Form>& of) {
    return std::span(of).subspan(2, 3);
  }
  static std::span<const Form> d(const std::vector<Form>& of) {
    return std::span(of).subspan(5, 3);
  }

  /// Outside of the triangle where x > 0, y ≥ 0, and at x = 0 too if `closed`.
  static bool is_outside(const std::vector<Form>& of, bool closed) {
    return is_strictly(of[0], 1, closed) || is_strictly(of[0], -1, closed) ||
           std::ranges::all_of(d(of), [&](const Form& f) { return is_strictly(f, 1, closed); }) ||
           std::ranges::any_of(s(of), [&](const Form& f) { return is_strictly(f, -1, closed); });
  }

  /// The origin is in the triangle at this end.
  static bool is_contact(const std::vector<Form>& of, End end) {
    const auto sign = [end](const Form& f) { return sign_at(end, f); };
    return sign(of[0]) == 0 &&
           std::ranges::all_of(s(of), [&](const Form& f) { return sign(f) >= 0; }) &&
           (sign(of[1]) > 0 ||
            std::ranges::any_of(d(of), [&](const Form& f) { return sign(f) <= 0; }));
  }
};

/// Whether they come as near as a distance > 0. Its forms: LinearDirections::kForms of each
/// direction, one after another.
struct DistanceTest {
  const Integer& distance;
  Work& work;

  std::vector<Form> forms_of(const Triangle& triangle) const {
    const LinearDirections of(triangle, Form(2, distance), work);
    std::vector<Form> out;
    for (int i = 0; i < LinearDirections::kCount; ++i) of.add_forms(i, out);
    return out;
  }

  template <class IsPositive>
  static bool is_shown(const std::vector<Form>& of, const IsPositive& is_positive) {
    for (size_t i = 0; i < of.size(); i += LinearDirections::kForms) {
      const auto forms = std::span(of).subspan(i, LinearDirections::kForms);
      if (std::ranges::all_of(forms, is_positive)) return true;
    }
    return false;
  }

  /// Farther away where x > 0, y ≥ 0, and at x = 0 too if `closed`, along one direction.
  static bool is_outside(const std::vector<Form>& of, bool closed) {
    return is_shown(of, [closed](const Form& f) { return is_strictly(f, 1, closed); });
  }

  static bool is_contact(const std::vector<Form>& of, End end) {
    return !is_shown(of, [end](const Form& f) { return sign_at(end, f) > 0; });
  }
};

/// Where the corners of the triangles come from: pairs of control points.
std::vector<std::array<std::array<size_t, 2>, 3>> triangles_of(const Query& query) {
  const size_t a = query.patches[0].positions.size(), b = query.patches[1].positions.size();
  if (a == 2 && b == 2) {
    return {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
  }
  std::array<std::array<size_t, 2>, 3> corners{};
  for (size_t c = 0; c < 3; ++c) corners[c] = {std::min(c, a - 1), std::min(c, b - 1)};
  return {corners};
}

Rational exact_velocity(const MovingPatch<double>& patch, size_t i, int k) {
  if (!patch.has_ends()) return exact(patch.velocities[i][k]);
  return exact(patch.ends[i][k]) - exact(patch.positions[i][k]);
}

/// The triangles as `ends` gives them: a component of a control point's position and velocity to
/// a pair of rationals. All times a common positive number, so that they are integers, and so is
/// the separation, which is put into `distance`.
template <class Ends>
std::vector<Triangle> triangles_between(const Query& query, const Ends& ends, Integer& distance) {
  std::vector<std::array<Rational, 2>> exact_ends;
  const auto places = triangles_of(query);
  const Rational separation = exact(query.separation);
  Integer denominator = separation.get_den();
  for (const auto& corners : places) {
    for (const auto& [i, j] : corners) {
      for (int k = 0; k < 3; ++k) {
        const auto &a = query.patches[0], &b = query.patches[1];
        const Rational p = exact(a.positions[i][k]) - exact(b.positions[j][k]);
        const Rational v = exact_velocity(a, i, k) - exact_velocity(b, j, k);
        exact_ends.push_back(ends(p, v));
        for (const Rational& x : exact_ends.back()) denominator = lcm(denominator, x.get_den());
      }
    }
  }
  distance = Rational(separation * denominator).get_num();
  std::vector<Triangle> out(places.size());
  size_t next = 0;
  for (Triangle& triangle : out) {
    for (Corner& corner : triangle) {
      for (auto& component : corner) {
        const auto& from = exact_ends[next++];
        for (size_t e = 0; e < 2; ++e) {
          component[e] = denominator / from[e].get_den() * from[e].get_num();
        }
      }
    }
  }
  return out;
}

enum class Found { kOutside, kInside, kUndecided };

/// Decides for all s in [0, 1], or if not `closed` in [0, 1), where x = 1 − s and y = s. All pieces
/// of one length before any shorter, so that a contact between two is found before one of them is
/// halved towards it without end. Test: the forms of a triangle, and the decision by those.
template <class Test>
Found decide_outside(std::vector<Form> forms, bool closed, int most_halvings, const Test& test) {
  struct Piece {
    std::vector<Form> forms;
    bool closed;
  };
  std::vector<Piece> pieces, shorter;
  pieces.push_back({std::move(forms), closed});
  for (int halvings = 0; !pieces.empty(); ++halvings) {
    for (Piece& piece : pieces) {
      if (test.is_outside(piece.forms, piece.closed)) continue;
      if (test.is_contact(piece.forms, End::kStart)) return Found::kInside;
      if (halvings == most_halvings) return Found::kUndecided;
      Piece first{piece.forms, true};
      for (Form& f : first.forms) f = half_of(std::move(f), End::kStart, test.work);
      for (Form& f : piece.forms) f = half_of(std::move(f), End::kStop, test.work);
      shorter.push_back(std::move(first));
      shorter.push_back(std::move(piece));
    }
    pieces = std::exchange(shorter, {});
  }
  return Found::kOutside;
}

int sign_of(const Form& f, const Rational& t, Work& work) {
  Rational sum = 0;
  for (size_t i = f.size(); i-- > 0;) {
    work.charge(fraction_work(words_of(sum) + words_of(t) + words_of(f[i])));
    sum = sum * t + f[i];
  }
  return sgn(sum);
}

/// True iff p divides f, both ordinary polynomials, p with a leading coefficient.
bool divides(const Form& p, Form f, Work& work) {
  while (f.size() >= p.size()) {
    const Integer leading = f.back();
    const size_t shift = f.size() - p.size();
    for (Integer& c : f) {
      work.charge(product_work(c, p.back()));
      c *= p.back();
    }
    for (size_t i = 0; i < p.size(); ++i) {
      work.charge(product_work(leading, p[i]));
      f[shift + i] -= leading * p[i];
    }
    f.pop_back();
  }
  return std::ranges::all_of(f, [](const Integer& c) { return c == 0; });
}

/// True iff it is shown that a triangle is as near as the separation at the root of p. All that
/// nearness() asks for is so by its coefficients on the interval, or is 0 as p divides it.
/// power, end: the triangle in powers of t, and with its ends at those of the interval.
bool is_near_at_root(const Form& p, const LinearDirections& power, const LinearDirections& end,
                     Work& work) {
  for (int k = 0; k < LinearDirections::kCount; ++k) {
    const LinearDirections::Nearness x = power.nearness(k), y = end.nearness(k);
    bool holds =
        is_strictly(y.sum, 1, true) && (has_no_sign(y.excess, 1) || divides(p, x.excess, work));
    for (size_t i = 0; i < 3; ++i) {
      holds &= has_no_sign(y.weights[i], -1) || divides(p, x.weights[i], work);
    }
    if (holds) return true;
  }
  return false;
}

Result<void> refuse_unless_linear(const Query& query, const char* where) {
  if (is_linear_query(query)) return {};
  return input_error(where, "{} and {} are not linear", to_text(query.patches[0].shape),
                     to_text(query.patches[1].shape));
}

constexpr const char* kClear = "truth.certificate.clear";
constexpr const char* kRoot = "truth.certificate.root";

Result<void> check_clearance_within(const Query& query, const LinearClearance& clearance,
                                    Work& work) {
  constexpr int kMostHalvings = 4000;
  CCDFUZZ_TRY_VOID(refuse_unless_linear(query, kClear));
  const Rational& until = clearance.until;
  if (until < 0) return input_error(kClear, "until = {} is negative", abbreviated(until));
  if (until == 0 && !clearance.closed) return {};  // there is no such time
  const auto ends = [&](const Rational& p, const Rational& v) -> std::array<Rational, 2> {
    return {p, p + until * v};
  };
  Integer distance;
  const std::vector<Triangle> triangles = triangles_between(query, ends, distance);
  const auto decide_by = [&](const auto& test) -> Result<void> {
    std::vector<std::vector<Form>> forms;
    for (const Triangle& triangle : triangles) {
      forms.push_back(test.forms_of(triangle));
      // Halving would come near this contact without end.
      if (!clearance.closed || !test.is_contact(forms.back(), End::kStop)) continue;
      return input_error(kClear, "there is a contact at t = {}", abbreviated(until));
    }
    for (std::vector<Form>& of : forms) {
      const Found found = decide_outside(std::move(of), clearance.closed, kMostHalvings, test);
      if (found == Found::kOutside) continue;
      const bool is_inside = found == Found::kInside;
      return tl::unexpected(InputError{
          kClear,
          fmt::format("{} before t = {}", is_inside ? "there is a contact" : "no proof of absence",
                      abbreviated(until)),
          !is_inside});
    }
    return {};
  };
  if (distance > 0) return decide_by(DistanceTest{distance, work});
  return decide_by(TouchTest{work});
}

Result<void> check_root_within(const Query& query, const ContactRoot& root, Work& work) {
  CCDFUZZ_TRY_VOID(refuse_unless_linear(query, kRoot));
  if (is_trimmed(query)) return input_error(kRoot, "does not show that the contact is in a trim");
  const Form& p = root.polynomial;
  if (root.from < 0 || root.by <= root.from) {
    return input_error(kRoot, "from = {} and by = {} are no times", abbreviated(root.from),
                       abbreviated(root.by));
  }
  if (p.empty() || p.back() == 0 || sign_of(p, root.from, work) * sign_of(p, root.by, work) >= 0) {
    return input_error(kRoot, "the polynomial does not change its sign from one end to the other");
  }
  const auto powers = [](const Rational& x, const Rational& v) -> std::array<Rational, 2> {
    return {x, v};
  };
  const auto ends = [&](const Rational& x, const Rational& v) -> std::array<Rational, 2> {
    return {x + root.from * v, x + root.by * v};
  };
  Integer distance, at_ends;  // in the units of either
  const auto in_powers = triangles_between(query, powers, distance);
  const auto in_ends = triangles_between(query, ends, at_ends);
  for (size_t i = 0; i < in_powers.size(); ++i) {
    if (distance > 0) {
      const LinearDirections power(in_powers[i], {distance, 0}, work);
      if (is_near_at_root(p, power, {in_ends[i], Form(2, at_ends), work}, work)) return {};
      continue;
    }
    const Products power(in_powers[i], work), end(in_ends[i], work);
    bool holds = divides(p, power.d3(), work), some_d = false;
    for (size_t k = 0; k < 3; ++k) {
      holds &= has_no_sign(end.s(k), -1) || divides(p, power.s(k), work);
      some_d |= has_no_sign(end.d(k), 1) || divides(p, power.d(k), work);
    }
    if (holds && (some_d || is_strictly(end.m(), 1, true))) return {};
  }
  return input_error(kRoot, "it is not shown that the patches are in contact at the root");
}

}  // namespace

bool is_linear_query(const Query& query) {
  int parameters = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    if (patch.shape.kind >= ShapeKind::kTensor || patch.shape.n > 1) return false;
    parameters += patch.shape.parameter_count();
  }
  return parameters <= 2;
}

Result<void> check_linear_clearance(const Query& query, const LinearClearance& clearance,
                                    std::uint64_t most_work) {
  return within_work(kClear, most_work, check_clearance_within, query, clearance);
}

Result<void> check_contact_root(const Query& query, const ContactRoot& root,
                                std::uint64_t most_work) {
  return within_work(kRoot, most_work, check_root_within, query, root);
}

}  // namespace ccdfuzz
