// What the contacts are that the families name, on their scenes, where nothing is rounded.
#include "generators/shaped/families.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bezier/blossom.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

constexpr std::array kSomeShapes = {Shape::triangle(1),  Shape::triangle(2),  Shape::triangle(4),
                                    Shape::tensor(1, 1), Shape::tensor(2, 2), Shape::tensor(4, 2),
                                    Shape::tensor(1, 3)};

/// Calls check on scenes of all pairs of these shapes that can have the contact.
template <class Check>
int for_each_extended_scene(Family family, const Check& check) {
  int scenes = 0;
  const FamilyRow& row = row_of(family);
  for (const ContactClass contact : row.classes[static_cast<size_t>(CaseKind::kRP)]) {
    for (const Shape& first : kSomeShapes) {
      for (const Shape& second : kSomeShapes) {
        if (!row.fits(contact, {first, second}) || ++scenes % kOneIn != 0) continue;
        SCOPED_TRACE(fmt::format("{} {} {} {}", name_of(family), name_of(contact), to_text(first),
                                 to_text(second)));
        Draw random{Random(static_cast<std::uint64_t>(scenes))};
        check(contact,
              std::get<FamilyRow::Make*>(row.made_by)(contact, {first, second}, random).scene);
      }
    }
  }
  return scenes;
}

Vec3<Dyadic> point_at(const ContactSide& side, const Uv<Dyadic>& uv) {
  return evaluate<Dyadic>(side.shape, side.points, uv);
}

/// Parameters of the domain that are multiples of 1/4.
std::vector<Uv<Dyadic>> lattice(const Shape& shape) {
  std::vector<Uv<Dyadic>> out;
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 4; ++j) {
      const Uv<Dyadic> uv = {Dyadic(i, -2), Dyadic(j, -2)};
      if (shape.contains(uv)) out.push_back(uv);
    }
  }
  return out;
}

/// How many points of the lattices of both patches coincide.
int coincidences(const ContactScene& scene) {
  std::array<Points<Dyadic>, 2> points;
  for (size_t s = 0; s < 2; ++s) {
    const ContactSide& side = scene.sides[s];
    for (const Uv<Dyadic>& uv : lattice(side.shape)) points[s].push_back(point_at(side, uv));
  }
  int count = 0;
  for (const Vec3<Dyadic>& p : points[0]) {
    for (const Vec3<Dyadic>& q : points[1]) count += p == q;
  }
  return count;
}

bool is_on_its_side(const ContactSide& side, size_t s) {
  for (const Uv<Dyadic>& uv : lattice(side.shape)) {
    const int z = point_at(side, uv)[2].sign();
    if (s == 0 ? z < 0 : z > 0) return false;
  }
  return true;
}

void expect_contact(const ContactScene& scene) {
  EXPECT_EQ(point_at(scene.sides[0], scene.sides[0].at),
            point_at(scene.sides[1], scene.sides[1].at));
  if (!scene.separated) return;
  for (size_t s = 0; s < 2; ++s) EXPECT_TRUE(is_on_its_side(scene.sides[s], s)) << "patch " << s;
}

/// True iff some edges of the patches, or parts of them that end at quarters, are the same curve.
bool shares_an_edge(const ContactScene& scene) {
  const auto& [one, two] = scene.sides;
  for (const ShapeEdge& a : edges_of(one.shape)) {
    for (const ShapeEdge& b : edges_of(two.shape)) {
      for (int from = 0; from <= 4; ++from) {
        for (int to = 0; to <= 4; ++to) {
          if (from == to) continue;
          const auto same = [&](const ContactSide& part, const ShapeEdge& edge,
                                const ContactSide& whole, const ShapeEdge& other) {
            for (int k = 0; k <= 8; ++k) {
              const Dyadic s(k, -3), t = Dyadic(from, -2) + s * Dyadic(to - from, -2);
              if (point_at(part, edge.at(s)) != point_at(whole, other.at(t))) return false;
            }
            return true;
          };
          if (same(one, a, two, b) || same(two, b, one, a)) return true;
        }
      }
    }
  }
  return false;
}

TEST(ExtendedContacts, EdgesAreShared) {
  EXPECT_GT(for_each_extended_scene(Family::kSharedEdge,
                                    [](ContactClass, const ContactScene& scene) {
                                      expect_contact(scene);
                                      EXPECT_TRUE(shares_an_edge(scene));
                                    }),
            50);
}

/// True iff z is 0 at `at` and at points on both sides, or one, of it along some direction.
bool has_zero_line(const ContactSide& side) {
  for (int du = -4; du <= 4; ++du) {
    for (int dv = -4; dv <= 4; ++dv) {
      if (du == 0 && dv == 0) continue;
      int inside = 0, zeros = 0;
      for (int k = -4; k <= 4; ++k) {
        const Uv<Dyadic> uv = {side.at[0] + Dyadic(k * du, -6), side.at[1] + Dyadic(k * dv, -6)};
        if (!side.shape.contains(uv)) continue;
        ++inside;
        zeros += point_at(side, uv)[2].sign() == 0;
      }
      if (inside >= 4 && zeros == inside) return true;
    }
  }
  return false;
}

TEST(ExtendedContacts, RuledOnesLieInThePlaneAlongALineOfOneAndAllOverTheOther) {
  const int scenes =
      for_each_extended_scene(Family::kRuled, [](ContactClass, const ContactScene& scene) {
        expect_contact(scene);
        for (const ContactSide& side : scene.sides) EXPECT_TRUE(has_zero_line(side));
        bool flat = false;
        for (const ContactSide& side : scene.sides) {
          flat |= std::ranges::all_of(side.points, [](const auto& p) { return p[2].sign() == 0; });
        }
        EXPECT_TRUE(flat);
      });
  EXPECT_GT(scenes, 50);
}

TEST(ExtendedContacts, SeveralPointsTouchAtOnce) {
  EXPECT_GT(for_each_extended_scene(Family::kSeveral,
                                    [](ContactClass, const ContactScene& scene) {
                                      expect_contact(scene);
                                      EXPECT_GE(coincidences(scene), 2);
                                    }),
            50);
}

TEST(ExtendedContacts, AreasCoincide) {
  bool curved = false;
  const int scenes =
      for_each_extended_scene(Family::kArea, [&](ContactClass, const ContactScene& scene) {
        expect_contact(scene);
        const auto& [part, whole] = scene.sides;
        // Where the part's first three corners are on the complete patch.
        std::array<std::optional<Uv<Dyadic>>, 3> corner;
        const std::vector<Uv<Dyadic>> corners = corners_of(part.shape);
        for (size_t k = 0; k < 3; ++k) {
          for (const Uv<Dyadic>& uv : lattice(whole.shape)) {
            if (point_at(part, corners[k]) == point_at(whole, uv)) corner[k] = uv;
          }
          ASSERT_TRUE(corner[k]) << k;
        }
        for (const Uv<Dyadic>& uv : lattice(part.shape)) {
          Uv<Dyadic> on_whole = *corner[0];
          for (size_t k = 0; k < 2; ++k) {
            on_whole[k] += uv[0] * ((*corner[1])[k] - (*corner[0])[k]) +
                           uv[1] * ((*corner[2])[k] - (*corner[0])[k]);
          }
          EXPECT_EQ(point_at(part, uv), point_at(whole, on_whole));
        }
        curved |= whole.points[0][2].sign() != 0;
      });
  EXPECT_GT(scenes, 30);
  EXPECT_TRUE(curved);
}

}  // namespace
}  // namespace ccdfuzz
