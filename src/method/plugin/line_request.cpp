#include <fmt/format.h>

#include <array>
#include <cmath>

#include "io/fields.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {

namespace {

/// A number, or a list of such; what is not finite is a word.
std::string any(double x) {
  return std::isfinite(x) ? json_number(x) : fmt::format("\"{}\"", x);
}
std::string any(const auto& numbers) {
  std::string out = "[";
  for (const auto& x : numbers) out += (out.size() == 1 ? "" : ",") + any(x);
  return out + ']';
}

auto asked_patch(const MovingPatch<double>& patch) {
  return [&patch](auto& archive) {
    const Shape& shape = patch.shape;
    const bool is_tensor = shape.kind == ShapeKind::kTensor;
    archive("shape", shape.kind);
    archive.when(is_tensor, "degree", std::array{shape.n, shape.m});
    archive.when(!is_tensor && shape.parameter_count() > 0, "degree", shape.n);
    archive("positions", RawJson{any(patch.positions)});
    archive(patch.has_ends() ? "ends" : "velocities", RawJson{any(patch.moves())});
    archive.optional("weights", patch.weights);
    archive.optional("trim", patch.trim);
    archive.when(shape.kind == ShapeKind::kHull, "radius", RawJson{any(patch.radius)});
    archive.optional("faces", patch.faces);
    archive.when(!patch.faces.empty(), "sides", patch.one_sided ? 1 : 2);
    if (!patch.turn) return;
    const BodyTurn& turn = *patch.turn;
    archive(turn.is_spin() ? "spin" : "turn", [&turn](auto& turning) {
      turning.when(turn.is_spin(), "velocity", RawJson{any(turn.spin)});
      turning.when(!turn.is_spin(), "from", RawJson{any(turn.from)});
      turning.when(!turn.is_spin(), "to", RawJson{any(turn.to)});
      turning("centre", RawJson{any(turn.centre)});
    });
  };
}

}  // namespace

std::string describe_request(const std::string& options) {
  return fmt::format("{{\"ask\":\"describe\",\"protocol\":1,\"options\":{}}}",
                     json_string(options));
}

std::string query_request(const Query& query, const SearchOptions& options, std::uint64_t id,
                          bool has_work) {
  return to_json([&](auto& question) {
    question.constant("ask", "query");
    question("id", id);
    question("patches", std::array{asked_patch(query.patches[0]), asked_patch(query.patches[1])});
    question("t_max", query.t_max);
    question.optional("separation", query.separation);
    limit_fields(question, options, has_work);
  });
}

}  // namespace ccdfuzz
