#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"
#include "share.hpp"

namespace ccdfuzz {

/// A case and what it is meant to be.
struct MixedCase {
  std::string name;
  Case value;
  /// Contacts are crossings, which a small change keeps: hits and misses must be decided.
  bool transversal = false;
};

/// Random patches, near enough to each other that many touch.
class RandomQueries {
 public:
  explicit RandomQueries(std::uint64_t seed) : random_(seed) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  double between(double lo, double hi) {
    return lo + (hi - lo) * std::ldexp(static_cast<double>(random_() >> 11), -53);
  }

  Shape shape(int max_degree, bool surface) {
    const int n = 1 + static_cast<int>(below(max_degree)),
              m = 1 + static_cast<int>(below(max_degree));
    switch (surface ? 2 + below(2) : below(4)) {
      case 0:
        return Shape::point();
      case 1:
        return Shape::curve(n);
      case 2:
        return Shape::triangle(n);
      default:
        return Shape::tensor(n, m);
    }
  }

  /// A bent patch of size about 1, facing any of the axes.
  MovingPatch<double> patch(const Shape& shape, double offset) {
    MovingPatch<double> p{shape, {}, {}};
    const Eigen::Index turn = static_cast<Eigen::Index>(below(3));
    const auto vector = [&](double size) {
      const double z = between(-size, size), y = between(-size, size);
      return Vec3<double>(between(-size, size), y, z);
    };
    const Vec3<double> centre = vector(offset), velocity = vector(2);
    for (int i = 0; i <= shape.n; ++i) {
      for (int j = 0; j <= (shape.kind == ShapeKind::kTriangle ? shape.n - i : shape.m); ++j) {
        Vec3<double> flat = {shape.n == 0 ? 0.0 : i / static_cast<double>(shape.n),
                             j / static_cast<double>(std::max(shape.m, std::max(shape.n, 1))), 0};
        Vec3<double> turned;
        for (Eigen::Index k = 0; k < 3; ++k) turned[(k + turn) % 3] = flat[k];
        p.positions.emplace_back(centre + turned + vector(0.2));
        p.velocities.emplace_back(velocity + vector(0.4));
      }
    }
    return p;
  }

  Query query(int max_degree, bool surfaces) {
    Query q;
    for (auto& p : q.patches) p = patch(shape(max_degree, surfaces), 1.2);
    q.t_max = between(0.2, 3);
    return q;
  }

  /// Small integers: touching, flat, static and degenerate patches abound.
  Query lattice() {
    Query q;
    for (auto& p : q.patches) {
      p.shape = shape(2, false);
      for (auto* points : {&p.positions, &p.velocities}) {
        for (int i = 0; i < p.shape.control_count(); ++i) {
          const auto x = [&] { return static_cast<double>(below(5)) - 2; };
          const double a = x(), b = x(), c = x();
          points->push_back({a, b, c});
        }
      }
    }
    q.t_max = static_cast<double>(below(3));
    return q;
  }

  /// Moves every number by up to 2^exponent.
  void perturb(Query& q, int exponent) {
    for (auto& p : q.patches) {
      for (auto* points : {&p.positions, &p.velocities}) {
        for (auto& x : *points) {
          for (int k = 0; k < 3; ++k) x[k] += std::ldexp(between(-1, 1), exponent);
        }
      }
    }
  }

 private:
  std::mt19937_64 random_;
};

/// Calls visit on about 70·each cases: every class and kind of both constructions; the stress
/// families; contacts perturbed into crossings; random patches of all shapes up to
/// degree 4; small integers.
inline void for_each_mixed_case(int each, std::uint64_t seed,
                                const std::function<void(const MixedCase&)>& visit) {
  RandomQueries random(seed);
  const auto made = [&](GeneratorOptions options, int i) {
    options.seed = seed;
    return generate(options, static_cast<std::uint64_t>(i)).value;
  };
  for (const ContactClass contact : kContactClasses) {
    const std::string name(name_of(contact));
    for (int i = 0; i < each; ++i) {
      for (const Construction construction : kConstructions) {
        for (const CaseKind kind : kCaseKinds) {
          const bool grazing = kind == CaseKind::kNHP || kind == CaseKind::kNMN;
          if (grazing && (i > 0 || construction == Construction::kPaper || kOneIn > 1))
            continue;  // they take long
          GeneratorOptions o;
          o.contact = contact, o.kind = kind, o.construction = construction;
          visit({name + " " + std::string(name_of(kind)), made(o, i), false});
        }
      }
      for (const Family family : {Family::kFlatGrazing, Family::kCommonVelocity, Family::kScaled,
                                  Family::kTwins, Family::kInteriorTime}) {
        if ((i + static_cast<int>(family)) % 4 != 0) continue;
        GeneratorOptions o;
        o.contact = contact, o.family = family;
        visit({std::string(name_of(family)), made(o, i), false});
      }
      GeneratorOptions o;
      o.contact = contact, o.construction = Construction::kOneSided;
      Case c = made(o, i + 1000);
      c.truth = {};
      random.perturb(c.query, -20 - static_cast<int>(random.below(10)));
      c.query.t_max = 1.5;
      visit({"perturbed " + name, c, true});
    }
  }
  for (int i = 0; i < 10 * each; ++i) {
    visit({"random shapes", {random.query(4, false), {}, {}, {}}, true});
    visit({"random surfaces", {random.query(3, true), {}, {}, {}}, true});
  }
  for (int i = 0; i < 10 * each; ++i) visit({"lattice", {random.lattice(), {}, {}, {}}, false});
}

}  // namespace ccdfuzz
