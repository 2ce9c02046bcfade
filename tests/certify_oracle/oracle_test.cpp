#include "certify/oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "bezier/orientation.hpp"
#include "certify/oracle/build_tree.hpp"
#include "files/case_json.hpp"
#include "generators/generate.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

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
    for_each_control(shape, [&](int i, int j) {
      Vec3<double> flat = {shape.n == 0 ? 0.0 : i / static_cast<double>(shape.n),
                           j / static_cast<double>(std::max(shape.m, std::max(shape.n, 1))), 0};
      Vec3<double> turned;
      for (Eigen::Index k = 0; k < 3; ++k) turned[(k + turn) % 3] = flat[k];
      p.positions.emplace_back(centre + turned + vector(0.2));
      p.velocities.emplace_back(velocity + vector(0.4));
    });
    return p;
  }

  Query query(int max_degree, bool surfaces) {
    Query q;
    for (auto& p : q.patches) p = patch(shape(max_degree, surfaces), 1.2);
    q.t_max = between(0.2, 3);
    return q;
  }

 private:
  std::mt19937_64 random_;
};

Query planted(ContactClass contact, std::uint64_t index) {
  GeneratorOptions options;
  options.contact = contact, options.construction = Construction::kOneSided;
  return generate(options, index).value.query;
}

/// A planted contact, every number of which is moved by up to 2^-20.
Query crossing(ContactClass contact, std::uint64_t index, RandomQueries& random) {
  Query q = planted(contact, index);
  for (MovingPatch<double>& patch : q.patches) {
    for_each_coordinate(patch, [&](double& x) { x += random.between(-0x1p-20, 0x1p-20); });
  }
  q.t_max = 1.5;
  return q;
}

TEST(Oracle, DecidesCrossingsWithEveryKindOfCertificate) {
  RandomQueries random(1);
  std::map<std::string, int> count;
  const auto must_decide = [&](const Query& query) {
    const Decision decision = decide(query);
    const Truth& truth = decision.truth;
    ASSERT_TRUE(truth.collides) << decision.note << "\n" << to_json({query, {}, {}, {}});
    ++count[*truth.collides ? "hit" : "miss"];
    if (truth.witness) ++count["W"];
    if (truth.contact_box) ++count["M"];
    if (truth.clearance) ++count[std::string(proof_word(*truth.clearance))];
  };
  for (const ContactClass contact : kContactClasses) {
    must_decide(crossing(contact, 0, random));
    must_decide(crossing(contact, 1, random));
    must_decide(random.query(4, false));
    must_decide(random.query(3, true));
    must_decide(planted(contact, 0));
  }
  for (const char* kind : {"hit", "miss", "W", "M", "T", "P"}) EXPECT_GE(count[kind], 1) << kind;
}

TEST(Oracle, BracketsACrossingClosely) {
  RandomQueries random(3);
  int brackets = 0;
  for (int i = 0; i < 60; ++i) {
    const Query query = random.query(3, true);
    const Truth truth = decide(query).truth;
    if (truth.collides != true || !truth.clear_until) continue;
    ++brackets;
    EXPECT_LT(*truth.clear_until, *truth.contact_by());
    EXPECT_LT(Rational(*truth.contact_by() - *truth.clear_until), exact(query.t_max * 0x1p-10))
        << to_json({query, truth, {}, {}});
  }
  EXPECT_GE(brackets, 3);
}

TEST(BuildMissTree, ProvesByOneAxisThatFlatFacesJustMiss) {
  RandomQueries random(1);
  const auto vector = [&] {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    return Vec3<double>(x, y, random.between(-1, 1));
  };
  for (int i = 0; i < 20; ++i) {
    const Vec3<double> zero(0, 0, 0), u = vector(), v = vector();
    Query query;
    query.patches.fill({Shape::triangle(1), {zero, v, u}, {zero, zero, zero}});
    query.t_max = 1;
    query.separation = 0x1p-10;
    // An axis whose largest component is 2^30 is off by half at most in the others. Along edges,
    // whose components are at most 2, that is 2, which 2^30 times the distance makes up for.
    for (Vec3<double>& p : query.patches[1].positions) {
      p += cross(u, v).normalized() * (query.separation + 0x1p-29);
    }
    EXPECT_TRUE(build_miss_tree(query, 1, 1)) << i;
  }
}

TEST(Oracle, IsUndecidedWithinTooSmallABudget) {
  GeneratorOptions o;
  o.contact = ContactClass::kFF, o.kind = CaseKind::kRN;
  const Case known = generate(o, 0).value;
  OracleOptions options;
  options.max_pops = 3;
  options.max_tree_nodes = 3;
  const Decision decision = decide(known.query, options);
  EXPECT_EQ(decision.truth.collides, std::nullopt);
  EXPECT_NE(decision.note, "");
}

TEST(Oracle, AnswersAsAMethod) {
  GeneratorOptions o;
  o.contact = ContactClass::kVF;
  Oracle oracle;
  const Case positive = generate(o, 0).value;
  const Answer hit = oracle.answer(positive.query, {});
  EXPECT_EQ(hit.verdict, Verdict::kHit);
  EXPECT_LE(exact(*hit.toi), positive.truth.witness->t);
  o.kind = CaseKind::kRN;
  EXPECT_EQ(oracle.answer(generate(o, 0).value.query, {}).verdict, Verdict::kMiss);
}

/// Static patches that touch: the contact is there at once.
TEST(Oracle, FindsContactsAtTheBeginning) {
  Query query;
  const Vec3<double> o = {0, 0, 0};
  query.patches[0] = {Shape::triangle(1), {{-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}}, {o, o, o}};
  query.patches[1] = {Shape::curve(1), {{0.1, 0.2, -1}, {0.3, 0.1, 1.25}}, {o, o}};
  for (const double t_max : {0.0, 1.0}) {
    query.t_max = t_max;
    const Truth truth = decide(query).truth;
    EXPECT_EQ(truth.collides, true);
    EXPECT_EQ(*truth.contact_by(), 0);
  }
  query.patches[1].positions[1] = {0.3, 0.1, -0x1p-30};
  EXPECT_EQ(decide(query).truth.collides, false);
}

// The parameters have 53 bits, and no box about them is inside of the region.
TEST(Oracle, FindsContactsOnSlantedEdgesOfTrims) {
  const Vec3<double> o = {0, 0, 0};
  for (const auto& [u, v, du, dv] : {std::array{0.3, 0.4, 0x1p-3, -0x1p-4},
                                     {0.3, 0.4, 0x1p-5, 0x1p-6},
                                     {0.7, 0.1, -0x1p-7, 0x1p-6}}) {
    for (const double share : {1.0, 0.5}) {
      const std::array<Uv<double>, 2> edge = {Uv<double>{u - du, v - dv},
                                              {u + share * du, v + share * dv}};
      ASSERT_EQ(orientation(edge[0], edge[1], {u, v}), 0);
      Query query;
      query.patches[0] = {Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {o, o, o}};
      query.patches[0].trim = {{edge[0], edge[1], {0, 0}}};
      query.patches[1] = {Shape::point(), {{u, v, 1}}, {{0, 0, -1}}};
      const Truth truth = decide(query).truth;
      ASSERT_EQ(truth.collides, true) << u << " " << v << " " << share;
      EXPECT_EQ(truth.witness->t, 1);
      EXPECT_EQ(truth.witness->uv[0], (Uv<Rational>{exact(u), exact(v)}));
    }
  }
}

/// A wavy patch at rest, its control points this much higher.
MovingPatch<double> wavy(double height) {
  MovingPatch<double> patch{Shape::tensor(8, 8), {}, Points<double>(81, {0, 0, 0})};
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const bool inside = 0 < i && i < 8 && 0 < j && j < 8;
      const double wave = inside ? ((i * i * 7 + j * 5) % 16 - 8) / 32.0 : 0;
      patch.positions.push_back({i / 8.0, j / 8.0, wave + height});
    }
  }
  return patch;
}

TEST(Oracle, LeavesUndecidedWhatTakesTheCheckerTooLong) {
  OracleOptions options;
  options.max_pops = 71'000;
  const Decision decision = decide({{wavy(0), wavy(0x1p-9)}, 1}, options);
  EXPECT_FALSE(decision.truth.collides);
  EXPECT_FALSE(decision.truth.clearance);
  EXPECT_NE(decision.note.find("exceeds the work budget"), std::string::npos) << decision.note;
}

TEST(Oracle, LeavesUndecidedBodiesWhosePlanesTakeTheCheckerTooLong) {
  Query query;
  for (int s = 0; s < 2; ++s) {
    MovingPatch<double>& body = query.patches[static_cast<size_t>(s)];
    for (int i = 0; i < 81; ++i) body.positions.emplace_back(i % 3, i / 3 % 3 + 8 * s, i / 9 - 4);
    body.velocities = {{0, -16.0 * s, 0}};
    body.shape = Shape::hull(81);
    // Ways from such a centre have a thousand bits.
    body.turn = BodyTurn{{}, {}, {0x3p-1060, 0x1p-1070, 0x5p-1050}, {0.25, 0.5, 0.125}};
  }
  const Decision decision = decide(query);
  EXPECT_FALSE(decision.truth.collides);
  EXPECT_FALSE(decision.truth.clearance);
  EXPECT_NE(decision.note.find("exceeds the work budget"), std::string::npos) << decision.note;
}

}  // namespace
}  // namespace ccdfuzz
