#include "certify/checker/check_tree.hpp"

#include <fmt/format.h>

#include "base/double_parts.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_trim.hpp"
#include "certify/checker/miss_tree.hpp"
#include "certify/checker/polar.hpp"

namespace ccdfuzz {

namespace {

struct Refusal {
  std::string what;
};

/// Parameters: of a triangle's part the ends of w, u and v, of a tensor's the lowest and highest.
using Corners = std::vector<Uv<Rational>>;

/// A part of a patch: its control points times 2^(depth·steps), a step for each blossom argument.
struct Part {
  const MovingNet<Integer>* net;
  int depth = 0;
  std::uint64_t id = 0;              ///< no two parts of a side have the same
  const Corners* corners = nullptr;  ///< those of trimmed patches alone
};

/// Makes the parts of one patch. Holds one family of siblings for each depth, which is what a walk
/// in pre-order needs. It stays until another part of its parent's depth is split.
class Parts {
 public:
  Parts(Work& work, bool rational) : work_(work), polar_(&work, rational) {}

  void load(const MovingPatch<double>& patch, MovingNet<Integer> net) {
    shape_ = patch.shape;
    root_ = std::move(net);
    if (patch.trim.empty()) return;
    root_corners_ = shape_.kind == ShapeKind::kTriangle ? Corners{{0, 0}, {1, 0}, {0, 1}}
                                                        : Corners{{0, 0}, {1, 1}};
  }
  Part root() const { return {&root_, 0, 0, is_trimmed() ? &root_corners_ : nullptr}; }
  bool is_trimmed() const { return !root_corners_.empty(); }
  int steps() const { return shape_.n + shape_.m; }
  int count() const { return shape_.child_count(); }

  /// The part of the domain as a convex polygon. Requires a trimmed patch.
  Corners polygon(const Part& part) const {
    const Corners& c = *part.corners;
    if (shape_.kind == ShapeKind::kTriangle) return c;
    return {c[0], {c[1][0], c[0][1]}, c[1], {c[0][0], c[1][1]}};
  }

  Part child(const Part& parent, int c) {
    const auto level = static_cast<size_t>(parent.depth);
    if (families_.size() <= level) families_.resize(level + 1);
    Family& family = families_[level];
    if (family.parent != parent.id || family.nets.empty()) fill(parent, family);
    const auto place = static_cast<size_t>(c);
    return {&family.nets[place], parent.depth + 1, family.first_id + place,
            is_trimmed() ? &family.corners[place] : nullptr};
  }

 private:
  struct Family {
    std::uint64_t parent = 0, first_id = 0;
    std::vector<MovingNet<Integer>> nets;
    std::vector<Corners> corners;
  };

  /// Doubled corners (origin, u end, v end) of a triangle's children as weights of w, u, v.
  static const Weights<Integer>& corner(int c, int which) {
    static const Weights<Integer> w = {2, 0, 0}, u = {0, 2, 0}, v = {0, 0, 2}, wu = {1, 1, 0},
                                  wv = {1, 0, 1}, uv = {0, 1, 1};
    static const std::array<std::array<const Weights<Integer>*, 3>, 4> children = {
        {{&w, &wu, &wv}, {&wu, &u, &uv}, {&wv, &uv, &v}, {&uv, &wv, &wu}}};
    return *children[static_cast<size_t>(c)][static_cast<size_t>(which)];
  }
  /// Doubled ends of the lower or upper half of a parameter as weights of its ends.
  static const Weights<Integer>& end(bool upper_half, bool upper_end) {
    static const std::array<Weights<Integer>, 3> at = {{{2, 0, 0}, {1, 1, 0}, {0, 2, 0}}};
    return at[static_cast<size_t>(upper_half) + static_cast<size_t>(upper_end)];
  }

  Corners child_corners(const Corners& parent, int c) const {
    Corners out = parent;
    for (size_t i = 0; i < out.size(); ++i) {
      for (size_t k = 0; k < 2; ++k) {
        const Weights<Integer>& weights = shape_.kind == ShapeKind::kTriangle
                                              ? corner(c, static_cast<int>(i))
                                              : end((c >> k & 1) != 0, i == 1);
        Rational sum = 0;
        for (size_t j = 0; j < parent.size(); ++j) {
          work_.charge(2 * product_work(parent[j][k], sum));
          sum += weights[j] * parent[j][k];
        }
        out[i][k] = sum / 2;
      }
    }
    return out;
  }

  void fill(const Part& parent, Family& family) {
    const MovingNet<Integer>& net = *parent.net;
    family.parent = parent.id;
    family.first_id = next_id_;
    next_id_ += static_cast<std::uint64_t>(count());
    family.nets.resize(static_cast<size_t>(count()));
    family.corners.clear();
    for (int c = 0; c < count() && is_trimmed(); ++c) {
      family.corners.push_back(child_corners(*parent.corners, c));
    }
    const bool triangle = shape_.kind == ShapeKind::kTriangle;
    std::vector<Weights<Integer>> first(static_cast<size_t>(shape_.n)),
        second(static_cast<size_t>(shape_.m));
    for (int c = 0; c < count(); ++c) {
      MovingNet<Integer>& child = family.nets[static_cast<size_t>(c)];
      child.resize(net.size());
      for_each_control(shape_, [&](int i, int j) {
        for (int k = 0; k < shape_.n; ++k) {
          first[static_cast<size_t>(k)] = triangle ? corner(c, k < i       ? 1
                                                               : k < i + j ? 2
                                                                           : 0)
                                                   : end((c & 1) != 0, k < i);
        }
        for (int k = 0; k < shape_.m; ++k) {
          second[static_cast<size_t>(k)] = end((c & 2) != 0, k < j);
        }
        child[static_cast<size_t>(shape_.index(i, j))] = polar_(shape_, net, first, second);
      });
    }
  }

  Work& work_;
  Shape shape_;
  MovingNet<Integer> root_;
  Corners root_corners_;  ///< none: the patch is whole
  std::vector<Family> families_;
  std::uint64_t next_id_ = 1;
  Polar<Integer> polar_;
};

class Walk {
 public:
  /// With until = a/b and every double a multiple of 2^unit, b·kTimeSteps·position·2^-unit and
  /// a·velocity·2^-unit are integers P and V, and P + m·V is a positive multiple of the control
  /// point at time m. The separation is a multiple as positions are. Where a patch is rational P
  /// and V are times the weight, itself a multiple that is an integer, and it divides at the end.
  Walk(const Query& query, const Rational& until, std::string_view tree, Work& work)
      : work_(work),
        query_(query),
        reader_(tree),
        is_rational_(is_rational(query)),
        sides_{Parts(work, is_rational_), Parts(work, is_rational_)} {
    int unit = 0, unit_of_weights = 0;
    const auto note = [](int& least, double x) { least = std::min(least, parts_of(x).exponent); };
    for (const MovingPatch<double>& patch : query.patches) {
      for_each_coordinate(patch, [&](double x) { note(unit, x); });
      for (const double w : patch.weights) note(unit_of_weights, w);
    }
    unit = std::min(unit, parts_of(query.separation).exponent);
    separation_ = integer_of(query.separation, unit) * until.get_den() * Integer(kTimeSteps);
    for (size_t s = 0; s < 2; ++s) {
      const auto integer = [&](double x, bool velocity) {
        const Integer value = integer_of(x, unit);
        return velocity ? Integer(value * until.get_num())
                        : Integer(value * until.get_den() * Integer(kTimeSteps));
      };
      const auto weight = [&](double w) { return integer_of(w, unit_of_weights); };
      sides_[s].load(query.patches[s], moving_net<Integer>(query.patches[s], integer, weight));
    }
  }

  std::uint64_t run() {
    node(sides_[0].root(), sides_[1].root(), 0, kTimeSteps, 0);
    if (!reader_.at_end()) throw Refusal{"goes on after its last node"};
    return nodes_;
  }

 private:
  void node(const Part& a, const Part& b, std::uint64_t lo, std::uint64_t hi, int depth) {
    if (depth > kMaxTreeDepth) throw Refusal{fmt::format("is deeper than {} nodes", kMaxTreeDepth)};
    const std::optional<TreeNode> here = reader_.next();
    if (!here) throw Refusal{fmt::format("ends within node {}", nodes_)};
    const std::uint64_t number = nodes_++;
    switch (here->kind) {
      case TreeNodeKind::kLeaf:
        if (!separates(here->axis, a, b, lo, hi)) {
          throw Refusal{fmt::format("node {}: axis ({}, {}, {}) does not separate", number,
                                    here->axis[0], here->axis[1], here->axis[2])};
        }
        return;
      case TreeNodeKind::kTime:
        if (!(lo < here->time && here->time < hi)) {
          throw Refusal{
              fmt::format("node {}: time {} is not inside ({}, {})", number, here->time, lo, hi)};
        }
        node(a, b, lo, here->time, depth + 1);
        node(a, b, here->time, hi, depth + 1);
        return;
      case TreeNodeKind::kOutside:
        if (is_outside(here->side, here->side == 0 ? a : b)) return;
        throw Refusal{fmt::format("node {}: the part of patches[{}] is not outside of its trim",
                                  number, here->side)};
      case TreeNodeKind::kSplit:
        break;
    }
    Parts& side = sides_[static_cast<size_t>(here->side)];
    if (side.count() == 1) throw Refusal{fmt::format("node {}: a point has no parts", number)};
    if ((here->side == 0 ? a : b).depth == kMaxPartDepth) {
      throw Refusal{
          fmt::format("node {}: a part is split more than {} times", number, kMaxPartDepth)};
    }
    for (int c = 0; c < side.count(); ++c) {
      if (here->side == 0) node(side.child(a, c), b, lo, hi, depth + 1);
      if (here->side == 1) node(a, side.child(b, c), lo, hi, depth + 1);
    }
  }

  bool is_outside(int side, const Part& part) {
    const Parts& parts = sides_[static_cast<size_t>(side)];
    if (!parts.is_trimmed()) return false;
    const Trim& trim = query_.patches[static_cast<size_t>(side)].trim;
    return region_of(trim, parts.polygon(part), work_) == Region::kOutside;
  }

  /// True iff max l·p < min l·q over the control points of a and b, at both times, by more than the
  /// separation times |l|.
  bool separates(const TreeAxis& axis, const Part& a, const Part& b, std::uint64_t lo,
                 std::uint64_t hi) {
    extremes(axis, a, lo, hi, 1, max_, weight_of_max_);
    extremes(axis, b, lo, hi, -1, min_, weight_of_min_);
    const int up_a = sides_[1].steps() * b.depth, up_b = sides_[0].steps() * a.depth;
    for (size_t end = 0; end < 2; ++end) {
      if (is_rational_) {  // n/w < m/v iff n·v < m·w
        multiply(max_[end], weight_of_min_[end]);
        multiply(min_[end], weight_of_max_[end]);
      } else {
        if (up_a > up_b) max_[end] <<= static_cast<mp_bitcnt_t>(up_a - up_b);
        if (up_b > up_a) min_[end] <<= static_cast<mp_bitcnt_t>(up_b - up_a);
      }
      if (max_[end] >= min_[end]) return false;
      if (separation_ == 0) continue;
      // (min − max)² > d²·|l|², all in the units of the parts.
      value_ = separation_;
      if (is_rational_) {
        multiply(value_, weight_of_max_[end]);
        multiply(value_, weight_of_min_[end]);
      } else {
        value_ <<= static_cast<mp_bitcnt_t>(std::max(up_a, up_b));
      }
      position_ = min_[end] - max_[end];
      work_.charge(product_work(value_, value_) + product_work(position_, position_));
      velocity_ = 0;
      for (const std::int64_t x : axis)
        velocity_ += Integer(static_cast<long>(x)) * static_cast<long>(x);
      if (position_ * position_ <= value_ * value_ * velocity_) return false;
    }
    return true;
  }

  /// x·2^-unit. Requires that this is whole.
  static Integer integer_of(double x, int unit) {
    const DoubleParts parts = parts_of(x);
    Integer value(static_cast<long>(parts.mantissa));
    value <<= static_cast<mp_bitcnt_t>(parts.exponent - unit);
    return value;
  }

  void multiply(Integer& x, const Integer& by) {
    work_.charge(product_work(x, by));
    x *= by;
  }

  /// The order of value_/weight and of x/w.
  int compare_value(const Integer& weight, const Integer& x, const Integer& w) {
    if (!is_rational_) return cmp(value_, x);
    left_ = value_, right_ = x;
    multiply(left_, w);
    multiply(right_, weight);
    return cmp(left_, right_);
  }

  /// The largest (sign 1) or smallest (sign −1) l·(P + m·V) at m = lo and m = hi, over its weight.
  void extremes(const TreeAxis& axis, const Part& part, std::uint64_t lo, std::uint64_t hi,
                int sign, std::array<Integer, 2>& out, std::array<Integer, 2>& weight) {
    bool first = true;
    for (const Moving<Integer>& p : *part.net) {
      for (const Integer& x : std::span(p).first<kWeight>()) work_.charge(2 * product_work(x, 1.0));
      position_ = 0, velocity_ = 0;
      for (size_t k = 0; k < 3; ++k) {
        add_product(position_, p[k], axis[k]);
        add_product(velocity_, p[k + 3], axis[k]);
      }
      for (const size_t end : {size_t{0}, size_t{1}}) {
        value_ = position_;
        mpz_addmul_ui(value_.get_mpz_t(), velocity_.get_mpz_t(), end == 0 ? lo : hi);
        if (!first && compare_value(p[kWeight], out[end], weight[end]) * sign <= 0) continue;
        out[end] = value_;
        if (is_rational_) weight[end] = p[kWeight];
      }
      first = false;
    }
  }

  static void add_product(Integer& sum, const Integer& x, std::int64_t y) {
    if (y >= 0) mpz_addmul_ui(sum.get_mpz_t(), x.get_mpz_t(), static_cast<unsigned long>(y));
    if (y < 0) mpz_submul_ui(sum.get_mpz_t(), x.get_mpz_t(), static_cast<unsigned long>(-y));
  }

  Work& work_;
  const Query& query_;
  TreeReader reader_;
  bool is_rational_;
  std::array<Parts, 2> sides_;
  std::uint64_t nodes_ = 0;
  Integer separation_;  ///< as positions are
  std::array<Integer, 2> max_, min_, weight_of_max_, weight_of_min_;
  Integer left_, right_;
  Integer position_, velocity_, value_;
};

}  // namespace

Result<std::uint64_t> check_tree(const Query& query, const Rational& until, std::string_view tree,
                                 std::uint64_t most_work) {
  if (until < 0) {
    return input_error("truth.certificate.clear.until", "{} is negative", abbreviated(until));
  }
  constexpr const char* kWhere = "truth.certificate.clear.tree";
  try {
    return within_work(kWhere, most_work, [&](Work& work) -> Result<std::uint64_t> {
      return Walk(query, until, tree, work).run();
    });
  } catch (const Refusal& refusal) {
    return input_error(kWhere, refusal.what);
  }
}

}  // namespace ccdfuzz
