#include "method/plugin/line_protocol.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "io/fields.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/line_values.hpp"

namespace ccdfuzz {

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

/// The fields of a description: those that are looked up are all that there are.
class DescriptionFields {
 public:
  explicit DescriptionFields(const JsonValue& object) : object_(object) {}

  /// The object, to look this field up in it.
  const JsonValue& with(std::string_view key) {
    known_.push_back(key);
    return object_;
  }
  const JsonValue* find(std::string_view key) { return with(key).find(key); }
  std::string text(std::string_view key) { return text_of(with(key), key); }

  /// A field that was not looked up: misspelt, it would claim nothing.
  std::optional<PluginRefusal> unknown() const {
    for (const std::string& key : object_.keys) {
      if (std::ranges::find(known_, key) != known_.end()) continue;
      return PluginRefusal{fmt::format("describes itself by \"{}\", which is no field", key)};
    }
    return std::nullopt;
  }

 private:
  const JsonValue& object_;
  std::vector<std::string_view> known_;
};

/// Reads a claim that may be left out. A claim that cannot be read is none that may be guessed at.
tl::expected<void, Fault> read_flag(DescriptionFields& object, std::string_view key, bool& out) {
  const JsonValue* found = object.find(key);
  if (found == nullptr) return {};
  if (found->kind != JsonKind::kBool) {
    return garbage_answer(
        fmt::format("claims {} {}, which is neither true nor false", key, shown(*found)));
  }
  out = found->text == "true";
  return {};
}

template <class Value>
tl::expected<void, Fault> read_word(auto& object, std::string_view key, const auto& words,
                                    Value& out) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return {};
  const auto found =
      std::find(words.begin(), words.end(), value->kind == JsonKind::kString ? value->text : "");
  if (found == words.end()) {
    return garbage_answer(fmt::format("claims {} {}, which is none of {}", key, shown(*value),
                                      fmt::join(words, ", ")));
  }
  out = static_cast<Value>(found - words.begin());
  return {};
}

tl::expected<void, Fault> read_length(DescriptionFields& object, std::string_view key,
                                      double& out) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return {};
  out = number_of(value).value_or(std::numeric_limits<double>::quiet_NaN());
  if (out >= 0 && std::isfinite(out)) return {};
  return garbage_answer(fmt::format("claims {} {}, which is no number >= 0", key, shown(*value)));
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

tl::expected<Domain::Pair, Fault> read_pair(const JsonValue& value) {
  Domain::Pair pair{};
  if (value.kind != JsonKind::kArray || value.items.size() != 2) {
    return garbage_answer("accepts something that is no pair of shapes");
  }
  for (size_t side = 0; side < 2; ++side) {
    const std::string shape = text_of(value.items[side], "shape");
    const auto kind = enum_named<ShapeKind>(shape);
    if (!kind) {
      return garbage_answer(fmt::format("accepts a shape \"{}\" that there is not", shape));
    }
    pair.shapes[side] = *kind;
    const std::uint64_t most = *kind == ShapeKind::kHull ? kMaxControls : kMaxDegree;
    std::uint64_t degree = most;
    CCDFUZZ_TRY_VOID(read_count(value.items[side], "max_degree", degree));
    pair.max_degrees[side] = static_cast<int>(std::min(degree, most));
  }
  return pair;
}

tl::expected<BodyKind, Fault> read_body_kind(const JsonValue& value) {
  if (value.kind != JsonKind::kObject) return garbage_answer("takes bodies that are no kind");
  BodyKind kind;
  std::uint64_t least = kind.least_points, most = kind.most_points;
  CCDFUZZ_TRY_VOID(read_count(value, "least_points", least));
  CCDFUZZ_TRY_VOID(read_count(value, "most_points", most));
  CCDFUZZ_TRY_VOID(read_word(value, "radius", names_of(kind.radius), kind.radius));
  if (least < 1 || least > most || least > kMaxControls) {
    return garbage_answer(fmt::format("takes bodies of {} to {} points", least, most));
  }
  kind.least_points = static_cast<std::uint32_t>(least);
  kind.most_points = static_cast<std::uint32_t>(std::min<std::uint64_t>(most, kMaxControls));
  return kind;
}

/// Calls read on each item of an array that may be left out, and adds what it gives.
template <class Item, class Read>
tl::expected<void, Fault> read_items(DescriptionFields& object, std::string_view key,
                                     const Read& read, std::vector<Item>& out) {
  const JsonValue* items = object.find(key);
  if (items == nullptr || items->kind != JsonKind::kArray) return {};
  for (const JsonValue& value : items->items) {
    CCDFUZZ_TRY(const auto item, read(value));
    out.push_back(item);
  }
  return {};
}

/// What decides what it is asked, and how its answers are judged.
tl::expected<void, Fault> read_claims(DescriptionFields& object, PluginDescription& out) {
  constexpr std::array<std::string_view, 2> kNumbers = {"binary64", "binary32"};
  constexpr std::uint64_t kWidestScale = 1074;  // 2^-1074 is the least double
  std::uint64_t scale = 0;
  CCDFUZZ_TRY_VOID(read_items(object, "accepts", read_pair, out.domain.pairs));
  CCDFUZZ_TRY_VOID(read_items(object, "bodies", read_body_kind, out.domain.body_kinds));
  for (const FeatureClaim& claim : kFeatureClaims) {
    CCDFUZZ_TRY_VOID(read_flag(object, claim.field, out.features.*claim.feature));
  }
  CCDFUZZ_TRY_VOID(read_flag(object, "conservative", out.conservative));
  CCDFUZZ_TRY_VOID(read_flag(object, "closed_t_max", out.closed_t_max));
  CCDFUZZ_TRY_VOID(read_flag(object, "contact_at_zero", out.contact_at_zero));
  CCDFUZZ_TRY_VOID(
      read_word(object, "tolerance_kind", names_of(out.tolerance_kind), out.tolerance_kind));
  CCDFUZZ_TRY_VOID(read_length(object, "tolerance", out.tolerance));
  CCDFUZZ_TRY_VOID(read_length(object, "minimum_separation", out.minimum_separation));
  CCDFUZZ_TRY_VOID(read_word(object, "nan_policy", names_of(out.nan_policy), out.nan_policy));
  CCDFUZZ_TRY_VOID(read_flag(object, "ordinary", out.domain.ordinary));
  CCDFUZZ_TRY_VOID(read_flag(object, "plane", out.domain.plane));
  CCDFUZZ_TRY_VOID(read_word(object, "numbers", kNumbers, out.domain.binary32));
  CCDFUZZ_TRY_VOID(read_count(object.with("within"), "within", scale));
  if (scale > 0) out.domain.scale = static_cast<int>(std::min(scale, kWidestScale));
  return {};
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
  DescriptionFields fields(object);
  if (const auto version = number_of(fields.find("protocol")); version != 1.0) {
    return tl::unexpected(
        Fault{"garbage", "does not describe itself with \"protocol\": 1: " + line.substr(0, 80)});
  }
  PluginDescription out;
  out.name = fields.text("name");
  out.version = fields.text("version");
  out.promise = fields.text("promise");
  if (const auto read = read_claims(fields, out); !read) {
    return tl::unexpected(PluginRefusal{read.error().note});
  }
  if (auto refusal = fields.unknown()) return tl::unexpected(*std::move(refusal));
  if (auto refusal = idle_claim(out.features)) return tl::unexpected(*std::move(refusal));
  if (auto refusal = too_loose(out)) return tl::unexpected(*std::move(refusal));
  return out;
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
  constexpr double kMostSeconds = 1e9;
  CCDFUZZ_TRY_VOID(read_count(object, "iterations", out.answer.pops));
  CCDFUZZ_TRY_VOID(read_count(object, "bytes", out.answer.bytes));
  CCDFUZZ_TRY_VOID(read_measure(object, "tolerance", kAnyTolerance, out.tolerance));
  CCDFUZZ_TRY(out.has_seconds, read_measure(object, "seconds", kMostSeconds, out.answer.seconds));
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
