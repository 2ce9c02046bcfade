#include "method/plugin/line_protocol.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "io/fields.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/line_values.hpp"

namespace ccdfuzz {

template <>
struct JsonForm<BodyKind> {
  static void fields(auto& archive, auto& kind) {
    archive.optional("least_points", kind.least_points);
    archive.optional("most_points", kind.most_points);
    archive.optional("radius", kind.radius);
  }
};

namespace {

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

/// A side of a pair in `accepts`.
struct AcceptedShape {
  ShapeKind shape = ShapeKind::kPoint;
  std::uint64_t max_degree = kMaxControls;

  static void fields(auto& archive, auto& accepted) {
    archive("shape", accepted.shape);
    archive.optional("max_degree", accepted.max_degree);
  }
};

enum class NumberWidth : std::uint8_t { k64, k32 };
constexpr std::array<std::string_view, 2> names_of(NumberWidth) {
  return {"binary64", "binary32"};
}

/// A claim about bodies, of which it takes none: it would claim nothing.
std::optional<PluginRefusal> idle_claim(const Features& claimed) {
  for (const FeatureClaim& claim : kFeatureClaims) {
    if (claimed.bodies || kPatchFeatures.*claim.feature || !(claimed.*claim.feature)) continue;
    return PluginRefusal{fmt::format("claims {} without takes_bodies", claim.field)};
  }
  return std::nullopt;
}

/// A claim so loose that it would excuse any answer.
std::optional<PluginRefusal> too_loose(const PluginDescription& d) {
  const bool relative = d.tolerance_kind == ToleranceKind::kTimeRelative ||
                        d.tolerance_kind == ToleranceKind::kSpaceRelative;
  const auto refusal = [](const char* field, double value, double most) {
    return PluginRefusal{fmt::format("claims {} {}, which is not in [0, {}]", field, value, most)};
  };
  const double most = relative ? kMostRelativeTolerance : kMostTolerance;
  if (d.tolerance > most) return refusal("tolerance", d.tolerance, most);
  if (d.minimum_separation > kMostTolerance) {
    return refusal("minimum_separation", d.minimum_separation, kMostTolerance);
  }
  return std::nullopt;
}

/// [lower, upper], or one number.
tl::expected<void, Fault> read_toi(const JsonValue* value, double t_max, PluginAnswer& out) {
  const JsonValue* lower = value;
  const JsonValue* upper = nullptr;
  if (value != nullptr && value->kind == JsonKind::kArray && value->items.size() == 2) {
    lower = &value->items[0];
    upper = &value->items[1];
  }
  const std::optional<double> toi = number_of(lower);
  if (!toi) return answer_fault("toi missing", "hit without a time of impact");
  if (std::isnan(*toi)) return answer_fault("toi NaN", "hit at the time NaN");
  if (std::isinf(*toi))
    return answer_fault("toi infinite", fmt::format("hit at the time {}", *toi));
  if (*toi < 0 || *toi > t_max) {
    return answer_fault("toi outside",
                        fmt::format("hit at the time {}, and t_max is {}", *toi, t_max));
  }
  out.answer.toi = *toi;
  if (is_given(upper)) {
    const std::optional<double> last = number_of(upper);
    if (!last) return garbage_answer(fmt::format("hit until {}, which is no time", shown(*upper)));
    if (std::isinf(*last)) {
      return answer_fault("toi infinite", fmt::format("hit until the time {}", *last));
    }
    out.toi_upper = *last;
  }
  if (out.toi_upper < *toi) {
    return answer_fault("toi order", fmt::format("hit between {} and {}", *toi, out.toi_upper));
  }
  return {};
}

/// [[u, v], [u, v]] with numbers, or with null where it does not know; left out or null.
tl::expected<void, Fault> read_uv(const JsonValue* value, PluginAnswer& out) {
  out.answer.has_uv = false;
  if (!is_given(value)) return {};
  if (value->kind != JsonKind::kArray || value->items.size() != 2)
    return garbage_answer("uv is not [[u, v], [u, v]]");
  out.answer.has_uv = true;
  for (size_t side = 0; side < 2; ++side) {
    const JsonValue& uv = value->items[side];
    if (uv.kind != JsonKind::kArray || uv.items.size() > 2) {
      return garbage_answer("uv is not [[u, v], [u, v]]");
    }
    for (size_t k = 0; k < uv.items.size(); ++k) {
      const std::optional<double> number = number_of(&uv.items[k]);
      if (number && std::isnan(*number)) return answer_fault("uv NaN", "hit at the parameter NaN");
      if (!number || std::isinf(*number)) out.answer.has_uv = false;
      out.answer.uv[side][k] = number.value_or(0);
    }
  }
  if (!out.answer.has_uv) out.answer.uv = {};
  return {};
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

/// Reads what decides what it is asked, and how its answers are judged. A claim that cannot be
/// read is none that may be guessed at; one that is misspelt would claim nothing.
template <>
struct JsonForm<PluginDescription> {
  static void fields(auto& archive, auto& d) {
    Domain& domain = d.domain;
    double protocol = 1;
    archive("protocol", protocol);
    archive.optional("name", d.name);
    archive.optional("version", d.version);
    archive.optional("promise", d.promise);
    std::vector<std::array<AcceptedShape, 2>> accepts;
    archive.optional("accepts", accepts);
    for (const std::array<AcceptedShape, 2>& pair : accepts) {
      Domain::Pair& read = domain.pairs.emplace_back();
      for (size_t side = 0; side < 2; ++side) {
        const auto& [shape, degree] = pair[side];
        const std::uint64_t most = shape == ShapeKind::kHull ? kMaxControls : kMaxDegree;
        read.shapes[side] = shape;
        read.max_degrees[side] = static_cast<int>(std::min(degree, most));
      }
    }
    archive.optional("bodies", domain.body_kinds, {}, Each{[](const BodyKind& kind) {
                       const auto& [least, most, radius] = kind;
                       return 1 <= least && least <= most && least <= kMaxControls
                                  ? ""
                                  : fmt::format("has {} to {} points", least, most);
                     }});
    for (const FeatureClaim& claim : kFeatureClaims) {
      archive.optional(claim.field, d.features.*claim.feature);
    }
    archive.optional("conservative", d.conservative);
    archive.optional("closed_t_max", d.closed_t_max);
    archive.optional("contact_at_zero", d.contact_at_zero);
    archive.optional("tolerance_kind", d.tolerance_kind);
    archive.optional("tolerance", d.tolerance, {}, not_negative);
    archive.optional("minimum_separation", d.minimum_separation, {}, not_negative);
    archive.optional("nan_policy", d.nan_policy);
    archive.optional("ordinary", domain.ordinary);
    archive.optional("plane", domain.plane);
    NumberWidth width = NumberWidth::k64;
    archive.optional("numbers", width);
    domain.binary32 = width == NumberWidth::k32;
    constexpr std::uint64_t kWidestScale = 1074;  // 2^-1074 is the least double
    std::uint64_t scale = 0;
    archive.optional("within", scale);
    if (scale > 0) domain.scale = static_cast<int>(std::min(scale, kWidestScale));
  }
};

bool PluginAnswer::agrees_with(const PluginAnswer& other) const {
  if (answer.verdict != other.answer.verdict) return false;
  if (answer.verdict != Verdict::kHit) return true;
  return same_bits(*answer.toi, *other.answer.toi) && answer.uv == other.answer.uv;
}

std::string describe_request(const std::string& options) {
  return fmt::format("{{\"ask\":\"describe\",\"protocol\":1,\"options\":{}}}",
                     json_string(options));
}

std::string query_request(const Query& query, const SearchOptions& options, double max_seconds,
                          std::uint64_t id) {
  std::string out = fmt::format("{{\"ask\":\"query\",\"id\":{},\"patches\":[", id);
  append_patch(out, query.patches[0]);
  out += ',';
  append_patch(out, query.patches[1]);
  const std::string separation =
      query.separation > 0 ? ",\"separation\":" + json_number(query.separation) : "";
  return out + fmt::format(
                   "],\"t_max\":{}{},\"precision\":{},\"max_iterations\":{},"
                   "\"max_seconds\":{},\"max_bytes\":{}}}",
                   json_number(query.t_max), separation, json_number(options.precision),
                   options.max_pops, json_number(max_seconds), options.max_bytes);
}

Described read_description(const std::string& line) {
  CCDFUZZ_TRY(const auto object, parse_object(line));
  if (const JsonValue* refused = object.find("refused"); refused != nullptr) {
    return tl::unexpected(PluginRefusal{text_of(object, "message")});
  }
  if (const JsonValue* named = object.find("fault"); named != nullptr) {
    return tl::unexpected(Fault{named->text, text_of(object, "message")});
  }
  if (number_of(object.find("protocol")) != 1.0) {
    return tl::unexpected(
        Fault{"garbage", "does not describe itself with \"protocol\": 1: " + line.substr(0, 80)});
  }
  Result<PluginDescription> read = from_json<PluginDescription>(line, "its description");
  if (!read) return tl::unexpected(PluginRefusal{read.error().message()});
  const PluginDescription& out = *read;
  if (auto refusal = idle_claim(out.features)) return tl::unexpected(*std::move(refusal));
  if (auto refusal = too_loose(out)) return tl::unexpected(*std::move(refusal));
  return *std::move(read);
}

tl::expected<PluginAnswer, Fault> read_answer(const std::string& line, std::uint64_t id,
                                              double t_max) {
  CCDFUZZ_TRY(const auto object, parse_object(line));
  const std::string message = text_of(object, "message");
  if (const JsonValue* named = object.find("fault"); named != nullptr) {
    return answer_fault(named->text, message);
  }
  if (const JsonValue* echoed = object.find("id"); whole_of(echoed) != id) {
    return answer_fault("stale", fmt::format("answered question {} when asked question {}",
                                             echoed == nullptr ? "none" : shown(*echoed), id));
  }
  PluginAnswer out;
  out.answer.note = message;
  constexpr double kAnyTolerance = std::numeric_limits<double>::infinity();
  constexpr double kLongestAnswer = 1e9;
  CCDFUZZ_TRY_VOID(read_count(object, "iterations", out.answer.pops));
  CCDFUZZ_TRY_VOID(read_count(object, "bytes", out.answer.bytes));
  CCDFUZZ_TRY_VOID(read_measure(object, "tolerance", kAnyTolerance, out.tolerance));
  CCDFUZZ_TRY(out.has_seconds, read_measure(object, "seconds", kLongestAnswer, out.answer.seconds));
  const std::string verdict = text_of(object, "verdict");
  if (verdict == "error") return answer_fault("error", "says that it failed: " + message);
  if (verdict == "miss") {
    out.answer.verdict = Verdict::kMiss;
  } else if (verdict == "refused") {
    out.answer.verdict = Verdict::kRefused;
  } else if (verdict == "hit") {
    out.answer.verdict = Verdict::kHit;
    CCDFUZZ_TRY_VOID(read_toi(object.find("toi"), t_max, out));
    CCDFUZZ_TRY_VOID(read_uv(object.find("uv"), out));
  } else if (verdict != "inconclusive") {
    return garbage_answer(fmt::format("gives no verdict that there is: {}", line.substr(0, 80)));
  } else if (const auto toi = number_of(object.find("toi")); toi && *toi >= 0 && *toi <= t_max) {
    out.answer.toi = *toi;
  }
  return out;
}

}  // namespace ccdfuzz
