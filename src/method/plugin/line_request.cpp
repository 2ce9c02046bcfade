#include <fmt/format.h>

#include <cmath>

#include "io/fields.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {

namespace {

/// One that is not finite is a word.
std::string any_number(double x) {
  return std::isfinite(x) ? json_number(x) : fmt::format("\"{}\"", x);
}

std::string any_numbers(const auto& numbers) {
  std::string out = "[";
  for (const double x : numbers) out += (out.size() == 1 ? "" : ",") + any_number(x);
  return out + ']';
}

void append_points(std::string& out, const char* name, const Points<double>& points) {
  out += fmt::format(",\"{}\":[", name);
  for (size_t i = 0; i < points.size(); ++i) {
    out += (i == 0 ? "" : ",") + any_numbers(points[i]);
  }
  out += ']';
}

void append_patch(std::string& out, const MovingPatch<double>& patch) {
  const Shape& shape = patch.shape;
  out += fmt::format("{{\"shape\":\"{}\"", name_of(shape.kind));
  if (shape.kind == ShapeKind::kTensor) {
    out += fmt::format(",\"degree\":[{},{}]", shape.n, shape.m);
  } else if (shape.parameter_count() > 0) {
    out += fmt::format(",\"degree\":{}", shape.n);
  }
  append_points(out, "positions", patch.positions);
  patch.has_ends() ? append_points(out, "ends", patch.ends)
                   : append_points(out, "velocities", patch.velocities);
  if (!patch.weights.empty()) out += ",\"weights\":" + to_json(patch.weights);
  if (!patch.trim.empty()) out += ",\"trim\":" + to_json(patch.trim);
  if (shape.kind == ShapeKind::kHull) {
    out += fmt::format(",\"radius\":{}", any_number(patch.radius));
  }
  if (!patch.faces.empty()) {
    out += fmt::format(",\"faces\":{},\"sides\":{}", to_json(patch.faces), patch.one_sided ? 1 : 2);
  }
  if (patch.turn) {
    out += patch.turn->is_spin()
               ? fmt::format(",\"spin\":{{\"velocity\":{}", any_numbers(patch.turn->spin))
               : fmt::format(",\"turn\":{{\"from\":{},\"to\":{}", any_numbers(patch.turn->from),
                             any_numbers(patch.turn->to));
    out += ",\"centre\":" + any_numbers(patch.turn->centre) + '}';
  }
  out += '}';
}

}  // namespace

std::string describe_request(const std::string& options) {
  return fmt::format("{{\"ask\":\"describe\",\"protocol\":1,\"options\":{}}}",
                     json_string(options));
}

std::string query_request(const Query& query, const SearchOptions& options, double max_seconds,
                          std::uint64_t id, bool tells_work) {
  std::string out = fmt::format("{{\"ask\":\"query\",\"id\":{},\"patches\":[", id);
  append_patch(out, query.patches[0]);
  out += ',';
  append_patch(out, query.patches[1]);
  const std::string separation =
      query.separation > 0 ? ",\"separation\":" + json_number(query.separation) : "";
  const std::string work = tells_work ? fmt::format(",\"max_work\":{}", options.max_work) : "";
  return out + fmt::format(
                   "],\"t_max\":{}{},\"precision\":{},\"max_iterations\":{},"
                   "\"max_seconds\":{},\"max_bytes\":{}{}}}",
                   json_number(query.t_max), separation, json_number(options.precision),
                   options.max_pops, json_number(max_seconds), options.max_bytes, work);
}

}  // namespace ccdfuzz
