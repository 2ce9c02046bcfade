#include "method/plugin/line_protocol.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <set>

#include "io/fields.hpp"
#include "io/json_real.hpp"
#include "method/plugin/feature_claims.hpp"

namespace ccdfuzz {

template <>
struct JsonForm<BodyKind> {
  static void fields(auto& archive, auto& kind) {
    archive.optional("least_points", kind.least_points);
    archive.optional("most_points", kind.most_points);
    archive.optional("radius", kind.radius);
  }
};

/// As it stands in a pair of `accepts`.
template <>
struct JsonForm<Domain::Side> {
  static void fields(auto& archive, auto& side) {
    archive("shape", side.shape);
    const std::uint32_t least = side.shape == ShapeKind::kPoint ? 0 : 1;
    const std::uint32_t most = side.shape == ShapeKind::kHull ? kMaxControls : kMaxDegree;
    side.max_degree = most;
    archive.optional("max_degree", side.max_degree, {}, Within{least, most});
  }
};

namespace {

enum class NumberWidth : std::uint8_t { k64, k32 };
constexpr std::array<std::string_view, 2> names_of(NumberWidth) {
  return {"binary64", "binary32"};
}

tl::unexpected<Fault> answer_fault(const std::string& name, const std::string& note) {
  return tl::unexpected(Fault{name, note});
}

/// Refused: a claim without another that it needs, which would claim nothing.
tl::expected<void, Fault> check_claims(const PluginDescription& d) {
  const auto refusal = [](std::string_view field, std::string_view needs = "takes_bodies") {
    return answer_fault(kRefusal, fmt::format("claims {} without {}", field, needs));
  };
  if (d.domain.initial_overlap && !d.contact_at_zero) {
    return refusal("initial_overlap", "contact_at_zero");
  }
  if (d.domain.initial_overlap && !d.domain.ordinary) return refusal("initial_overlap", "ordinary");
  if (const auto& most = d.domain.most_spin; most && !d.features.spins) {
    return refusal(*most == kSmallSpin ? "small_spins" : "short_spins", "takes_spins");
  }
  if (d.features.bodies) return {};
  if (d.domain.initial_overlap) return refusal("initial_overlap");
  constexpr Features kOfTwoBodies = {.turns = true, .angles = true, .spins = true};
  for (const FeatureClaim& claim : kFeatureClaims) {
    if (kOfTwoBodies.*claim.feature && d.features.*claim.feature) return refusal(claim.field);
  }
  if (d.domain.plane) return refusal("plane");
  if (!d.domain.body_kinds.empty() && !takes_bodies(d.features)) return refusal("bodies");
  return {};
}

// The values of a line that a plug-in answers with, which may hold anything.

constexpr const char* kFrom = "its answer";

/// Python and others write these where JSON has no word for them.
std::string with_quoted_non_finite(const std::string& line) {
  std::string out;
  bool in_string = false;
  for (size_t i = 0; i < line.size();) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) in_string = !in_string;
    size_t length = 0;
    for (const char* word : {"NaN", "-Infinity", "Infinity"}) {
      if (!in_string && length == 0 && line.compare(i, std::strlen(word), word) == 0) {
        length = std::strlen(word);
      }
    }
    if (length > 0) {
      out += fmt::format("\"{}\"", line.substr(i, length));
      i += length;
    } else {
      out += line[i++];
    }
  }
  return out;
}

/// It is no answer.
tl::unexpected<Fault> garbage_answer(const std::string& note) {
  return answer_fault("garbage", note);
}

/// The object that the line is; NaN and infinities may stand there bare. Errors: garbage.
tl::expected<JsonValue, Fault> parse_object(const std::string& line) {
  Result<JsonValue> parsed = parse_json(line, kFrom);
  if (!parsed) parsed = parse_json(with_quoted_non_finite(line), kFrom);
  if (!parsed) {
    return garbage_answer(fmt::format("{}: {}", parsed.error().message(), line.substr(0, 80)));
  }
  if (parsed->kind != JsonKind::kObject)
    return garbage_answer("is no object: " + line.substr(0, 80));
  return *std::move(parsed);
}

/// The text at the key; "" for none.
std::string text_of(const JsonValue& object, std::string_view key) {
  const JsonValue* found = object.find(key);
  return found != nullptr && found->kind == JsonKind::kString ? found->text : "";
}

/// The faults that worker.cpp tells of a library. A program that made up others could fill a corpus
/// with finds of its own.
constexpr std::array<std::string_view, 6> kToldFaults = {"error",  "exception", "garbage",
                                                         "memory", "sizes",     "unanswered"};

/// Errors: the fault that the object tells, by its name; garbage, where there is none of the name.
tl::expected<void, Fault> check_no_fault(const JsonValue& object) {
  if (object.find("fault") == nullptr) return {};
  const std::string name = text_of(object, "fault");
  return std::ranges::find(kToldFaults, name) == kToldFaults.end()
             ? garbage_answer(fmt::format("tells of no known fault: \"{}\"", name.substr(0, 80)))
             : answer_fault(name, text_of(object, "message"));
}

/// A number that need not be finite; absent for null, for nothing and for what is none.
std::optional<double> number_of(const JsonValue* value) {
  if (value == nullptr) return std::nullopt;
  if (value->kind == JsonKind::kString) {
    std::string word = value->text;
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf" || word == "infinity") return std::numeric_limits<double>::infinity();
    if (word == "-inf" || word == "-infinity") return -std::numeric_limits<double>::infinity();
  }
  const Result<double> real = parse_real(*value);
  return real ? std::optional(*real) : std::nullopt;
}

/// A whole number in [0, 2^63).
std::optional<std::uint64_t> whole_of(const JsonValue* value) {
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= 0 && *number < 0x1p63)) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(*number);
  return static_cast<double>(whole) == *number ? std::optional(whole) : std::nullopt;
}

/// False for null and for what is left out.
bool is_given(const JsonValue* value) {
  return value != nullptr && value->kind != JsonKind::kNull;
}

/// Reads a count that may be left out or null. Errors: garbage, for what is none.
tl::expected<void, Fault> read_count(const JsonValue& object, std::string_view key,
                                     std::uint64_t& out) {
  const JsonValue* value = object.find(key);
  if (!is_given(value)) return {};
  const std::optional<std::uint64_t> count = whole_of(value);
  if (!count) {
    return garbage_answer(
        fmt::format("says {} {}, which is no whole number in [0, 2^63)", key, shown(*value)));
  }
  out = *count;
  return {};
}

/// Reads what it may have measured: left out or null, NaN, or a number in [0, most]. Returns
/// whether there is one. Errors: garbage, for anything else.
tl::expected<bool, Fault> read_measure(const JsonValue& object, std::string_view key, double most,
                                       double& out) {
  const JsonValue* value = object.find(key);
  if (!is_given(value)) return false;
  const std::optional<double> number = number_of(value);
  if (!number || *number < 0 || *number > most) {
    return garbage_answer(
        fmt::format("says {} {}, which is no number in [0, {}]", key, shown(*value), most));
  }
  if (std::isnan(*number)) return false;
  out = *number;
  return true;
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
  if (!toi && is_given(value)) {
    return garbage_answer(fmt::format("hit at {}, which is no time", shown(*value)));
  }
  if (!toi) return answer_fault("toi missing", "hit without a time of impact");
  if (std::isnan(*toi)) return answer_fault("toi NaN", "hit at the time NaN");
  if (std::isinf(*toi))
    return answer_fault("toi infinite", fmt::format("hit at the time {}", *toi));
  if (*toi < 0 || *toi > t_max) {
    return answer_fault("toi outside",
                        fmt::format("hit at the time {}, and t_max is {}", *toi, t_max));
  }
  out.answer.toi = toi;
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
    archive.optional("accepts", domain.pairs);
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
    // Looser claims would excuse any answer.
    const bool is_relative = d.tolerance_kind == ToleranceKind::kTimeRelative ||
                             d.tolerance_kind == ToleranceKind::kSpaceRelative;
    const double most = is_relative ? kMostRelativeTolerance : kMostTolerance;
    archive.optional("tolerance", d.tolerance, {}, Within{0.0, most});
    archive.optional("minimum_separation", d.minimum_separation, {}, Within{0.0, kMostTolerance});
    archive.optional("nan_policy", d.nan_policy);
    archive.optional("ordinary", domain.ordinary);
    archive.optional("initial_overlap", domain.initial_overlap);
    archive.optional("plane", domain.plane);
    bool are_small = false, are_short = false;
    archive.optional("small_spins", are_small);
    archive.optional("short_spins", are_short);
    if (are_small || are_short) domain.most_spin = are_small ? kSmallSpin : kShortSpin;
    NumberWidth width = NumberWidth::k64;
    archive.optional("numbers", width);
    domain.binary32 = width == NumberWidth::k32;
    constexpr std::uint64_t kWidestScale = 1074;  // 2^-1074 is the least double
    std::uint64_t scale = 0;
    archive.optional("within", scale, {}, Within{std::uint64_t{0}, kWidestScale});
    if (scale > 0) domain.scale = static_cast<int>(scale);
  }
};

bool PluginAnswer::agrees_with(const PluginAnswer& other) const {
  if (answer.verdict != other.answer.verdict) return false;
  if (answer.verdict != Verdict::kHit) return true;
  return same_bits(*answer.toi, *other.answer.toi) && answer.uv == other.answer.uv;
}

tl::expected<PluginDescription, Fault> read_description(const std::string& line) {
  CCDFUZZ_TRY(const auto object, parse_object(line));
  if (object.find("refused") != nullptr) {
    const std::string what = text_of(object, "refused");  // as worker.cpp says
    const bool is_away = what == "program" || what == "library" || what == "version";
    return answer_fault(is_away ? kAway : kRefusal, text_of(object, "message"));
  }
  CCDFUZZ_TRY_VOID(check_no_fault(object));
  if (number_of(object.find("protocol")) != 1.0) {
    return garbage_answer("does not describe itself with \"protocol\": 1: " + line.substr(0, 80));
  }
  PluginDescription description;
  const Result<void> read = read_json_tree(
      object, "its description", [&](const JsonCursor& top) { read_json(top, description); });
  if (!read) return answer_fault(kRefusal, read.error().message());
  CCDFUZZ_TRY_VOID(check_claims(description));
  // Patches that are as near from the start need no hit of one that counts no contact at 0.
  if (description.conservative && description.contact_at_zero && !description.features.separation) {
    description.features.kept_separation = description.minimum_separation;
  }
  description.line = line;
  return description;
}

std::string changes_between(const std::string& before, const std::string& after) {
  const JsonValue was = *parse_object(before), is = *parse_object(after);
  std::set<std::string> keys(was.keys.begin(), was.keys.end());
  keys.insert(is.keys.begin(), is.keys.end());
  std::vector<std::string> changes;
  for (const std::string& key : keys) {
    const JsonValue *const first = was.find(key), *const then = is.find(key);
    if (first != nullptr && then != nullptr && *first == *then) continue;
    changes.push_back(fmt::format("{} ({}, then {})", key, first ? shown(*first) : "nothing",
                                  then ? shown(*then) : "nothing"));
  }
  return fmt::format("{}", fmt::join(changes, ", "));
}

tl::expected<PluginAnswer, Fault> read_answer(const std::string& line, std::uint64_t id,
                                              double t_max) {
  CCDFUZZ_TRY(const auto object, parse_object(line));
  CCDFUZZ_TRY_VOID(check_no_fault(object));
  if (const JsonValue* echoed = object.find("id"); whole_of(echoed) != id) {
    return answer_fault("stale", fmt::format("answered with the id {} when asked with the id {}",
                                             echoed == nullptr ? "missing" : shown(*echoed), id));
  }
  PluginAnswer out;
  out.answer.note = text_of(object, "message");
  constexpr double kAnyTolerance = std::numeric_limits<double>::infinity();
  constexpr double kLongestAnswer = 1e9;
  CCDFUZZ_TRY_VOID(read_count(object, "iterations", out.answer.pops));
  CCDFUZZ_TRY_VOID(read_count(object, "bytes", out.answer.bytes));
  CCDFUZZ_TRY_VOID(read_measure(object, "tolerance", kAnyTolerance, out.tolerance));
  CCDFUZZ_TRY(out.has_seconds, read_measure(object, "seconds", kLongestAnswer, out.answer.seconds));
  const std::string verdict = text_of(object, "verdict");
  if (verdict == "error") return answer_fault("error", "says that it failed: " + out.answer.note);
  const auto verdicts = all_of(Verdict{});
  const auto* const said = std::ranges::find(verdicts, verdict, word_of);
  if (said == verdicts.end()) {
    return garbage_answer("its verdict is none of hit, miss, inconclusive, refused, error: " +
                          line.substr(0, 80));
  }
  out.answer.verdict = *said;
  const auto toi = number_of(object.find("toi"));
  if (*said == Verdict::kHit) {
    CCDFUZZ_TRY_VOID(read_toi(object.find("toi"), t_max, out));
    CCDFUZZ_TRY_VOID(read_uv(object.find("uv"), out));
  } else if (*said == Verdict::kUndecided && toi && *toi >= 0 && *toi <= t_max) {
    out.answer.toi = toi;
  }
  return out;
}

}  // namespace ccdfuzz
