#include "report/gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "bezier/blossom.hpp"
#include "query/json_text.hpp"
#include "report/pack.hpp"
#include "report/tessellate.hpp"

namespace ccdfuzz {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kGltfSteps = 32;

// Numbers of the specification.
enum Component { kUnsignedInt = 5125, kFloat = 5126 };
enum Target { kVertices = 34962, kElements = 34963, kNone = 0 };
enum Mode { kPointsMode = 0, kLinesMode = 1, kLineStripMode = 3, kTrianglesMode = 4 };

/// The one buffer, with its views and accessors.
class Binary {
 public:
  int add_points(const Points<double>& points, bool with_bounds) {
    std::array<float, 3> least{}, most{};
    for (size_t i = 0; i < points.size(); ++i) {
      for (size_t k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(points[i][static_cast<Eigen::Index>(k)]);
        least[k] = i == 0 ? x : std::min(least[k], x);
        most[k] = i == 0 ? x : std::max(most[k], x);
        append(x);
      }
    }
    Json accessor = {{"componentType", kFloat}, {"count", points.size()}, {"type", "VEC3"}};
    if (with_bounds) accessor.update({{"min", least}, {"max", most}});
    return finish(std::move(accessor), kVertices);
  }

  int add_scalars(const std::vector<float>& values) {
    for (const float x : values) append(x);
    return finish({{"componentType", kFloat},
                   {"count", values.size()},
                   {"type", "SCALAR"},
                   {"min", Json::array({*std::ranges::min_element(values)})},
                   {"max", Json::array({*std::ranges::max_element(values)})}},
                  kNone);
  }

  template <size_t n>
  int add_indices(const std::vector<std::array<std::uint32_t, n>>& rows) {
    for (const auto& row : rows) {
      for (const std::uint32_t index : row) append(index);
    }
    return finish({{"componentType", kUnsignedInt}, {"count", n * rows.size()}, {"type", "SCALAR"}},
                  kElements);
  }

  void write_to(Json& gltf) const {
    gltf["accessors"] = accessors_;
    gltf["bufferViews"] = views_;
    const Json buffer = {{"byteLength", bytes_.size()},
                         {"uri", "data:application/octet-stream;base64," + base64(bytes_)}};
    gltf["buffers"] = Json::array({buffer});
  }

 private:
  template <class T>
  void append(T x) {
    static_assert(sizeof(T) == 4);
    std::array<char, 4> raw;
    std::memcpy(raw.data(), &x, sizeof(T));
    bytes_.append(raw.data(), raw.size());
  }

  int finish(Json accessor, Target target) {
    Json view = {{"buffer", 0}, {"byteOffset", start_}, {"byteLength", bytes_.size() - start_}};
    if (target != kNone) view["target"] = target;
    accessor["bufferView"] = views_.size();
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    start_ = bytes_.size();
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_;
  size_t start_ = 0;
  Json views_ = Json::array(), accessors_ = Json::array();
};

/// Where the picture's lengths come from.
struct Frame {
  Vec3<double> origin;
  int exponent = 0;  ///< lengths are multiplied by 2^exponent

  Points<double> operator()(Points<double> points) const {
    for (Vec3<double>& p : points) {
      for (int k = 0; k < 3; ++k) p[k] = std::ldexp(p[k] - origin[k], exponent);
    }
    return points;
  }
};

Frame frame_of(const Case& value, const std::vector<double>& times) {
  const auto& patches = value.query.patches;
  Frame frame{patches[0].positions[0], 0};
  if (const auto& witness = value.truth.witness) {
    const Vec3<Rational> at =
        evaluate(exact_patch<Rational>(patches[0]), witness->uv[0], witness->t);
    for (int k = 0; k < 3; ++k) frame.origin[k] = at[k].get_d();
  }
  double largest = 0;
  for (const MovingPatch<double>& patch : patches) {
    for (const double t : times) {
      for (const Vec3<double>& p : frame(patch.at(t))) {
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
      }
    }
  }
  // What people's programs show well stays as it is.
  constexpr int kComfortable = 14;
  const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  if (std::abs(exponent) > kComfortable) frame.exponent = -exponent;
  return frame;
}

class Gltf {
 public:
  explicit Gltf(const Frame& frame) : frame_(frame) {}

  /// One patch and its net, at t_0; with a second shape at t_1 if that differs.
  void add_patch(const MovingPatch<double>& patch, int side, double t_0, double t_1,
                 const std::string& name) {
    const Tessellation mesh = tessellate(patch.shape, kGltfSteps);
    const bool surface = !mesh.triangles.empty();
    const int mode = surface                                 ? kTrianglesMode
                     : patch.shape.kind == ShapeKind::kCurve ? kLineStripMode
                                                             : kPointsMode;
    const auto shape_at = [&](double t) {
      const Points<double> vertices = frame_(vertices_at(patch, mesh, t));
      return std::array{vertices, surface ? normals_of(mesh, vertices) : Points<double>()};
    };
    Json primitive = {{"mode", mode}, {"material", 2 * side}};
    if (surface) primitive["indices"] = binary_.add_indices(mesh.triangles);
    add_shapes(primitive, shape_at(t_0), t_0 == t_1 ? std::nullopt : std::optional(shape_at(t_1)));
    Json primitives = Json::array({primitive});
    if (const auto lines = net_lines(patch.shape); !lines.empty()) {
      Json net = {{"mode", kLinesMode}, {"material", 2 * side + 1}};
      net["indices"] = binary_.add_indices(lines);
      const auto controls_at = [&](double t) {
        return std::array{frame_(patch.at(t)), Points<double>()};
      };
      add_shapes(net, controls_at(t_0),
                 t_0 == t_1 ? std::nullopt : std::optional(controls_at(t_1)));
      // All primitives of a mesh need the same number of shapes: the net is a mesh of its own.
      add_mesh(Json::array({net}), name + ", control net", t_0 != t_1);
    }
    add_mesh(primitives, name, t_0 != t_1);
  }

  void add_point(const std::string& name) { nodes_.push_back(Json::object({{"name", name}})); }

  /// From the first shape to the second, within a second.
  void animate() {
    if (moving_.empty()) return;
    const int times = binary_.add_scalars({0, 1}), weights = binary_.add_scalars({0, 1});
    Json channels = Json::array();
    for (const size_t node : moving_) {
      channels.push_back({{"sampler", 0}, {"target", {{"node", node}, {"path", "weights"}}}});
    }
    const Json sampler = {{"input", times}, {"output", weights}};
    animation_ = Json::object();
    animation_["name"] = "the step";
    animation_["samplers"] = Json::array({sampler});
    animation_["channels"] = channels;
  }

  std::string text(const Json& extras) const {
    Json root_nodes = Json::array();
    for (size_t i = 0; i < nodes_.size(); ++i) root_nodes.push_back(i);
    Json scene = Json::object(), gltf = Json::object();
    scene["nodes"] = root_nodes;
    gltf["asset"] = {{"version", "2.0"}, {"generator", "ccdfuzz"}, {"extras", extras}};
    gltf["scene"] = 0;
    gltf["scenes"] = Json::array({scene});
    gltf["nodes"] = nodes_;
    gltf["meshes"] = meshes_;
    gltf["materials"] = materials();
    if (!animation_.is_null()) gltf["animations"] = Json::array({animation_});
    binary_.write_to(gltf);
    return json_text(gltf);
  }

 private:
  using ShapeData = std::array<Points<double>, 2>;  ///< vertices, normals

  void add_shapes(Json& primitive, const ShapeData& first, const std::optional<ShapeData>& second) {
    const auto attributes = [&](const ShapeData& shape) {
      Json one = {{"POSITION", binary_.add_points(shape[0], true)}};
      if (!shape[1].empty()) one["NORMAL"] = binary_.add_points(shape[1], false);
      return one;
    };
    primitive["attributes"] = attributes(first);
    if (!second) return;
    ShapeData change = *second;
    for (size_t which = 0; which < 2; ++which) {
      for (size_t i = 0; i < change[which].size(); ++i) change[which][i] -= first[which][i];
    }
    primitive["targets"] = Json::array({attributes(change)});
  }

  void add_mesh(const Json& primitives, const std::string& name, bool moves) {
    if (moves) moving_.push_back(nodes_.size());
    nodes_.push_back({{"name", name}, {"mesh", meshes_.size()}});
    meshes_.push_back({{"name", name}, {"primitives", primitives}});
    if (moves) meshes_.back()["weights"] = Json::array({0});
  }

  static Json materials() {
    Json all = Json::array();
    const auto add = [&](const char* name, double r, double g, double b) {
      all.push_back({{"name", name},
                     {"doubleSided", true},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", {r, g, b, 1.0}},
                       {"metallicFactor", 0},
                       {"roughnessFactor", 0.6}}}});
    };
    add("patch 1", .05, .21, .52);
    add("net of patch 1", .02, .1, .3);
    add("patch 2", .74, .25, .03);
    add("net of patch 2", .45, .13, .01);
    return all;
  }

  const Frame& frame_;
  Binary binary_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), animation_;
  std::vector<size_t> moving_;
};

}  // namespace

std::string to_gltf(const Case& value, const std::vector<double>& times) {
  const double t_max = value.query.t_max;
  const Frame frame = frame_of(value, times.empty() ? std::vector<double>{0, t_max} : times);
  Gltf gltf(frame);
  for (int side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = value.query.patches[static_cast<size_t>(side)];
    const std::string name = fmt::format("patch {}", side + 1);
    if (times.empty()) gltf.add_patch(patch, side, 0, t_max, name);
    for (const double t : times) {
      gltf.add_patch(patch, side, t, t, fmt::format("{} at t = {}", name, t));
    }
  }
  if (value.truth.witness) gltf.add_point("contact");
  gltf.animate();
  Json extras = {{"origin", {frame.origin[0], frame.origin[1], frame.origin[2]}},
                 {"scale_exponent", frame.exponent},
                 {"t_max", t_max}};
  if (value.truth.witness) extras["contact_t"] = to_text(value.truth.witness->t);
  return gltf.text(extras);
}

}  // namespace ccdfuzz
