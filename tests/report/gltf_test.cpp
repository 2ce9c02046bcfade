#include "report/gltf.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/tessellate.hpp"

namespace ccdfuzz {
namespace {

using Json = nlohmann::json;

Case flat_triangle_and_point(double size) {
  Case value;
  value.query.patches[0] = {Shape::triangle(1),
                            {{0, 0, 0}, {0, size, 0}, {size, 0, 0}},
                            {{0, 0, size}, {0, 0, size}, {0, 0, size}}};
  value.query.patches[1] = {Shape::point(), {{0, 0, size}}, {{0, 0, 0}}};
  value.query.t_max = 2;
  value.truth.collides = true;
  value.truth.witness = Witness{1, {Uv<Rational>{0, 0}, Uv<Rational>{0, 0}}};
  return value;
}

TEST(Gltf, IsAnAnimationOfTheStepWithoutTimes) {
  const Json gltf = Json::parse(to_gltf(flat_triangle_and_point(1), {}));
  EXPECT_EQ(gltf["asset"]["version"], "2.0");
  EXPECT_EQ(gltf["asset"]["extras"]["contact_t"], "1");
  EXPECT_EQ(gltf["animations"][0]["channels"].size(), 3U) << "a surface, its net and a point";
  for (const Json& mesh : gltf["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) EXPECT_EQ(primitive["targets"].size(), 1U);
  }
}

TEST(Gltf, HasTheSurfacesAtEachTime) {
  const Json gltf = Json::parse(to_gltf(flat_triangle_and_point(1), {0, 1}));
  EXPECT_FALSE(gltf.contains("animations"));
  std::map<std::string, Json> bounds;
  for (const Json& mesh : gltf["meshes"]) {
    const size_t accessor = mesh["primitives"][0]["attributes"]["POSITION"];
    bounds[mesh["name"]] = gltf["accessors"][accessor];
  }
  // Relative to the contact at (0, 0, 1).
  EXPECT_EQ(bounds["patch 1 at t = 0"]["min"], (std::vector{0., 0., -1.}));
  EXPECT_EQ(bounds["patch 1 at t = 1"]["max"], (std::vector{1., 1., 0.}));
  EXPECT_EQ(bounds["patch 2 at t = 1"]["max"], (std::vector{0., 0., 0.}));
}

TEST(Gltf, LengthsStayInSinglePrecision) {
  const Json gltf = Json::parse(to_gltf(flat_triangle_and_point(0x1p-500), {0}));
  EXPECT_EQ(gltf["asset"]["extras"]["scale_exponent"], 500);
  double largest = 0;
  for (const Json& accessor : gltf["accessors"]) {
    if (!accessor.contains("max")) continue;
    for (const double x : accessor["max"]) largest = std::max(largest, x);
  }
  EXPECT_EQ(largest, 1);
}

TEST(Tessellation, CoversTheDomain) {
  for (const Shape& shape : {Shape::triangle(2), Shape::tensor(1, 2)}) {
    const Tessellation mesh = tessellate(shape, 4);
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Uv<double>&p = mesh.at[a], &q = mesh.at[b], &r = mesh.at[c];
      const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
      EXPECT_GT(twice, 0);
      area += twice / 2;
    }
    EXPECT_EQ(area, shape.kind == ShapeKind::kTriangle ? .5 : 1) << to_text(shape);
  }
  EXPECT_EQ(tessellate(Shape::curve(3), 4).at.size(), 5U);
  EXPECT_EQ(tessellate(Shape::point(), 4).at.size(), 1U);
}

TEST(Tessellation, NetLinesJoinNeighbours) {
  EXPECT_EQ(net_lines(Shape::triangle(1)).size(), 3U);
  EXPECT_EQ(net_lines(Shape::triangle(2)).size(), 9U);
  EXPECT_EQ(net_lines(Shape::tensor(2, 1)).size(), 7U);
  EXPECT_EQ(net_lines(Shape::curve(3)).size(), 3U);
  EXPECT_TRUE(net_lines(Shape::point()).empty());
}

}  // namespace
}  // namespace ccdfuzz
