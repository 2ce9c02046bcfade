#include <fmt/format.h>

#include <cmath>

#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_tree.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/checker/miss_tree.hpp"
#include "files/case_json.hpp"
#include "generators/draw_patch.hpp"
#include "io/json_real.hpp"
#include "properties/case_file.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

bool names(const InputError& error, std::string_view part) {
  return error.message().find(part) != std::string::npos;
}

/// A patch whose control points are (i, j, height + something), moving up or down.
MovingPatch<double> patch_at(Draw& choices, const Shape& shape, double height) {
  MovingPatch<double> patch;
  patch.shape = shape;
  for (int i = 0; i < shape.control_count(); ++i) {
    const auto small = [&]() -> double { return choices.integer(1, 8); };
    patch.positions.emplace_back(small(), small(), height + small());
    patch.velocities.emplace_back(small(), small(), -std::copysign(small(), height));
  }
  return patch;
}

Query query_of(Draw& choices, const Shape& a, const Shape& b) {
  return {{patch_at(choices, a, -16), patch_at(choices, b, 16)}, 1};
}

void check_limits_of_a_file(Draw& d) {
  const std::uint64_t past = d.choose(1);
  Case value;
  value.query = query_of(d, Shape::point(), Shape::point());
  std::string text, limit;
  switch (d.choose(2)) {
    case 0: {
      const std::string digits(kMaxRationalDigits + past, static_cast<char>('1' + d.choose(8)));
      Rational t{Integer(digits)};
      if (d.coin()) t = 1 / t;
      value.truth.witness = Witness{t, {}};
      text = to_json(value);
      limit = fmt::format("truth.witness.t: has a numerator or denominator of {} digits",
                          digits.size());
      break;
    }
    case 1: {
      value.truth.contact_root = ContactRoot{{}, 0, 1};
      value.truth.contact_root->polynomial.assign(kMaxRootDegree + 1 + past, 1);
      text = to_json(value);
      limit = fmt::format("truth.certificate.root.polynomial: has {} coefficients",
                          kMaxRootDegree + 1 + past);
      break;
    }
    default: {
      constexpr std::string_view kTMax = "\"t_max\":1", kBefore = "0x1.", kAfter = "p0";
      const std::string zeros(kMaxNumberLength + past - kBefore.size() - kAfter.size(), '0');
      text = to_json(value);
      const std::size_t at = text.find(kTMax);
      CLAIM(at != std::string::npos);
      text.replace(at, kTMax.size(), fmt::format("\"t_max\":\"{}{}{}\"", kBefore, zeros, kAfter));
      limit = fmt::format("has {} characters", kMaxNumberLength + past);
    }
  }
  const Result<Case> read = show(d, "read", parse_case(text, "file"));
  show(d, "limit", limit);
  CLAIM(read.has_value() == (past == 0));
  CLAIM(read || names(read.error(), limit));
}

/// A double printed to any number of digits: enough to tell it from other doubles or not, or more,
/// or all that there are.
void check_long_decimals(Draw& d) {
  const double x = show(d, "double", std::abs(d.finite_double()));
  const int digits = d.integer(1, 60);  // behind the first
  const auto printed = [x](int count) { return fmt::format("{:.{}e}", x, count); };
  const std::string text = show(d, "printed", printed(digits));
  // No double has more than 767 significant digits.
  const std::string all = printed(800);
  const std::string rest =
      all.substr(0, all.find('e')).substr(static_cast<std::size_t>(2 + digits));
  const bool is_all = rest.find_first_not_of('0') == std::string::npos;
  const Result<double> read = show(d, "read", parse_exact_real({JsonKind::kNumber, text, {}, {}}));
  if (read) {
    CLAIM(digits <= 16 || is_all);
    CLAIM(digits < 16 || *read == x);
  } else {
    suppose(digits >= 16 || !names(read.error(), "range"));  // rounded out of it
    CLAIM(digits > 16 && !is_all);
  }
}

/// A certificate with a number of many words, which its check must multiply by others as long.
void check_work_is_counted(Draw& d) {
  const std::uint64_t words = show(d, "words", 16 + d.choose(48)), square = words * words;
  const Rational most = power_of_two(static_cast<long>(64 * words));
  const Rational big = (most - 1) / most;
  const Witness witness{big, {Uv<Rational>{big / 2, 1 - big}, Uv<Rational>{big, big}}};
  const ContactRoot root{{-big.get_num(), big.get_den()}, 0, 1};
  TreeBits tree;
  tree.leaf({0, 0, 1});
  enum Kind : std::size_t { kWitness, kPlane, kTree, kLinear, kRoot };
  const auto kind = static_cast<Kind>(d.choose(kRoot));
  show(d, "certificate", static_cast<int>(kind));
  const Query query = kind >= kLinear ? query_of(d, Shape::point(), Shape::triangle(1))
                                      : query_of(d, Shape::triangle(2), Shape::tensor(2, 2));
  // Less than what any query costs. The least is a triangle that is as good as a point, whose
  // normals are 0: three dot products d of four products, each of more than `words` words.
  const std::uint64_t budget =
      std::array{256 * square, 64 * square, 32 * words, 12 * square, 40 * square}[kind];
  const auto check = [&](std::uint64_t most_work) -> Result<void> {
    switch (kind) {
      case kWitness:
        return check_contact(query, witness, most_work);
      case kPlane:
        return check_plane(query, {big, {big, 0, 1}, 0}, most_work);
      case kTree:
        return check_tree(query, big, tree.bytes(), most_work).map([](std::uint64_t) {});
      case kLinear:
        return check_linear_clearance(query, {big, true}, most_work);
      case kRoot:
        return check_contact_root(query, root, most_work);
    }
    return {};
  };
  const Result<void> within = show(d, "within", check(budget));
  const Result<void> freely = show(d, "freely", check(kMostWork));
  CLAIM(!within);
  CLAIM(names(within.error(), fmt::format("exceeds the work budget of {} ", budget)));
  CLAIM(freely || !names(freely.error(), "work budget"));
}

void check_splits(Draw& d) {
  const std::uint64_t past = d.choose(1);
  const int side = show(d, "side", d.coin() ? 1 : 0);
  const Query query = query_of(d, Shape::curve(1), Shape::curve(1));
  TreeBits tree;
  for (std::uint64_t i = 0; i < kMaxPartDepth + past; ++i) tree.split(side);
  for (std::uint64_t i = 0; i < kMaxPartDepth + past + 1; ++i) tree.leaf({0, 0, 1});
  const auto checked = show(d, "checked", check_tree(query, 1, tree.bytes()));
  const bool is_refused =
      !checked && names(checked.error(), fmt::format("split more than {} times", kMaxPartDepth));
  show(d, "splits", kMaxPartDepth + past);
  CLAIM(is_refused == (past == 1));
}

/// Up to kMaxRationalDigits of them, most of them the same.
Integer draw_long_integer(Draw& choices) {
  const std::size_t length =
      choices.choose(3) == 0 ? 1 + choices.choose(kMaxRationalDigits - 1) : 1 + choices.choose(20);
  std::string digits(length, static_cast<char>('0' + choices.choose(9)));
  digits.back() = static_cast<char>('0' + choices.choose(9));
  digits.front() = static_cast<char>('1' + choices.choose(8));  // not 0 where it is the only one
  return Integer(digits);
}

Rational draw_long_fraction(Draw& choices) {
  const Integer below = draw_long_integer(choices);
  Rational x(draw_long_integer(choices), below);
  x.canonicalize();
  if (x > 1 && choices.coin()) x = 1 / x;
  return choices.choose(7) == 0 ? Rational(-x) : x;
}

/// A tree's bytes: any, or all splits down to some depth and the same leaf throughout.
std::string draw_any_tree(Draw& choices) {
  constexpr std::size_t kLongest = 4000;
  if (choices.coin()) return choices.text(kLongest);
  TreeBits tree;
  for (std::uint64_t splits = choices.choose(1000); splits > 0; --splits) {
    if (choices.choose(63) == 0) tree.time(kTimeSteps >> (1 + choices.choose(50)));
    tree.split(static_cast<int>(splits % 2));
  }
  for (std::uint64_t leaves = choices.choose(4000); leaves > 0; --leaves) tree.leaf({1, 2, -3});
  return tree.bytes();
}

/// A tree's parts have many small numbers, and sanitizers look at each: this takes 2 s under them.
constexpr std::uint64_t kMostTreeWork = 1 << 26;

/// What a file may say, up to the limits of the reader. Nothing is claimed but that it is read, and
/// that the checker answers. How long it takes, and how much memory, is the driver's to see.
void check_any_case(Draw& d) {
  const int most_degree = d.coin() ? 1 : kMaxDegree;
  std::array<double, 6> numbers{};
  for (double& x : numbers) x = d.finite_double();
  // Each number a few times over, in an order that depends on the choices.
  std::size_t step = 1 + d.choose(4), at = 0;
  const auto next = [&](Draw&) {
    if (at % 5 == 4) ++step;
    return numbers[(at += step) % numbers.size()];
  };
  Case value;
  value.query = draw_query(d, most_degree, next);
  value.query.t_max = std::abs(numbers[0]);
  value.truth = draw_any_truth(d, value.query, draw_long_fraction);
  const std::string tree = draw_any_tree(d);
  if (clearance_of<MissTree>(value.truth) != nullptr) {
    std::get<MissTree>(*value.truth.clearance).tree = {tree};
  }
  const Result<Case> read = show(d, "read", parse_case(to_json(value), "file"));
  CLAIM(read.has_value());
  (void)check_truth(*read);
  if (const auto* clear = clearance_of<MissTree>(read->truth)) {
    (void)check_tree(read->query, clear->until, clear->tree.bytes, kMostTreeWork);
  } else if (read->truth.clearance) {
    (void)check_clearance(read->query, *read->truth.clearance);
  }
}

}  // namespace

std::vector<Property> limits_claims() {
  return {
      {"limits.of_any_case",
       "Whatever a case says within the limits of the reader, the checker answers",
       "src/certify/checker/work.hpp", check_any_case},
      {"limits.of_a_file",
       "A case at a limit of the reader is read, and one past it is refused, naming field and "
       "limit",
       "the case format", check_limits_of_a_file},
      {"limits.of_a_decimal",
       "A decimal of more than 17 significant digits is read iff it is a double exactly",
       "the case format", check_long_decimals},
      {"limits.of_work",
       "A certificate with long numbers is refused within a small budget, which names the budget",
       "src/certify/checker/work.hpp", check_work_is_counted},
      {"limits.of_splits", "A part of a miss tree is split 60 times and no more",
       "src/certify/checker/miss_tree.hpp", check_splits},
  };
}

}  // namespace ccdfuzz
