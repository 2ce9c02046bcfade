#include "finds/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "base/text.hpp"
#include "ccd/witness_trace/loss_signature.hpp"
#include "certify/checker/check_case.hpp"
#include "io/hash_name.hpp"
#include "io/json_write.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

/// The fields of an origin that say what a judge measured and allowed.
constexpr std::array kMeasured = {"depth", kDepthAllowed, kTimeAllowed};

/// The text with each character replaced that a file name should not have. What the replacements
/// cannot tell apart, a hash does.
std::string plain(const std::string& text) {
  std::string out;
  bool is_ambiguous = text.starts_with('.');
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 128 && (std::isalnum(byte) != 0 || c == '.' || c == '-');
    is_ambiguous = is_ambiguous || (!is_plain && c != ':');
    out += is_plain ? c : c == ':' ? '_' : '-';
  }
  constexpr size_t kLongest = 60;
  is_ambiguous = is_ambiguous || out.size() > kLongest;
  if (!is_ambiguous) return out;
  constexpr size_t kHashDigits = 12;
  const size_t begin = out.size() - std::min(out.size(), kLongest - kHashDigits);
  return fmt::format("{}-{}", hash_name(text).substr(0, kHashDigits), out.substr(begin));
}

/// With dashes for spaces. A text with dashes of its own stays different, where it may be any.
std::string dashed(std::string text, bool is_any = true) {
  if (is_any) std::ranges::replace(text, '-', '/');
  std::ranges::replace(text, ' ', '-');
  return text;
}

/// 0: correct; 1: nothing is claimed; 2: a failure.
int badness(Outcome outcome) {
  if (is_failure(outcome)) return 2;
  return outcome == Outcome::kCorrect ? 0 : 1;
}

/// "mesh", "one-sided mesh", "spin" or "turn"; empty for other bodies.
std::string kind_of_bodies(const Query& query) {
  for (const MovingPatch<double>& body : query.patches) {
    if (!body.faces.empty()) return body.one_sided ? "one-sided mesh" : "mesh";
  }
  return has_spins(query) ? "spin" : has_turns(query) ? "turn" : "";
}

}  // namespace

Failure failure_of(const Case& value, const std::string& method, const Expected& expected) {
  const auto& [outcome, cause] = expected;
  if (outcome == Outcome::kError) return {method, outcome, "", cause, Setting::kOrdinary};
  return {method, outcome, value.origin.contact, cause, setting_of(value)};
}

void say_version(Case& find, const std::string& method, const Judged& judged) {
  auto& more = find.origin.more;
  more.erase("version");
  for (const char* name : kMeasured) more.erase(name);
  const auto info = method_info(method);
  if (!info || info->version.empty()) return;
  more["version"] = json_string(info->version);
  const auto say = [&](const char* name, double x) {
    if (x > 0) more[name] = fmt::format("{}", x);
  };
  if (judged.outcome == Outcome::kFalsePositive) return;
  say("depth", judged.depth);
  say(kDepthAllowed, is_of_bodies(find.query) ? judged.terms.depth_tolerance : 0);  // as outcome_of
  say(kTimeAllowed, judged.terms.time_tolerance);
}

void say_depth(Case& find, const std::string& method, const Judged& judged) {
  Case said = find;
  say_version(said, method, judged);
  auto &before = find.origin.more, &now = said.origin.more;
  if (before.contains("version") && now["version"] == before["version"]) {
    find = std::move(said);
  }
}

void take_depth(Case& find, const Case& other) {
  const auto &before = find.origin.more, &measured = other.origin.more;
  const auto version = before.find("version"), of_other = measured.find("version");
  if (version == before.end() || of_other == measured.end() || *version != *of_other) return;
  for (const char* name : kMeasured) {
    const auto field = measured.find(name);
    if (field != measured.end()) find.origin.more.insert(*field);
  }
}

std::vector<Failure> failures_of(const Case& value) {
  std::vector<Failure> failures;
  for (const auto& [method, expected] : value.expect) {
    if (is_failure(expected.outcome)) failures.push_back(failure_of(value, method, expected));
  }
  return failures;
}

std::string to_text(const Failure& failure) {
  std::vector<std::string_view> details;
  for (const std::string* text : {&failure.contact, &failure.cause}) {
    if (!text->empty()) details.push_back(*text);
  }
  if (failure.setting != Setting::kOrdinary) details.push_back(name_of(failure.setting));
  return details.empty() ? fmt::format("{} by {}", name_of(failure.outcome), failure.who)
                         : fmt::format("{} by {} ({})", name_of(failure.outcome), failure.who,
                                       fmt::join(details, ", "));
}

std::string file_stem(const Failure& failure) {
  std::string stem = fmt::format("{}-{}", plain(failure.who), name_of(failure.outcome));
  if (!failure.contact.empty()) stem += "-" + plain(dashed(failure.contact));
  // The name of an error may be any text, and other causes are few: kCauses.
  const bool is_any = failure.outcome == Outcome::kError;
  if (!failure.cause.empty()) stem += "-" + plain(dashed(failure.cause, is_any));
  if (failure.setting != Setting::kOrdinary) {
    stem += "-" + dashed(std::string(name_of(failure.setting)));
  }
  return stem;
}

Change change_of(const Expected& expected, const Expected& got) {
  if (expected.outcome == got.outcome) {
    const bool is_alike = expected.cause.empty() || expected.cause == got.cause;
    return is_alike ? Change::kNone : Change::kOther;
  }
  if (got.outcome == Outcome::kNotAsked) return Change::kNotAsked;
  const int before = badness(expected.outcome), now = badness(got.outcome);
  const bool is_unjudged = before == 0 && got.outcome == Outcome::kUnknown;
  if (before == now || is_unjudged) return Change::kOther;
  return before < now ? Change::kRegression : Change::kImprovement;
}

std::string wrong_by(const Judged& judged) {
  return beside_tolerance(judged.depth, "deep", judged.terms.depth_tolerance) +
         beside_tolerance(judged.apart, "apart", judged.terms.space_tolerance);
}

std::string to_text(const Expected& expected, double late_by) {
  std::string text(expected.outcome == Outcome::kNotAsked ? "not asked"
                                                          : name_of(expected.outcome));
  if (late_by > 0) text += fmt::format(" by {:.3g}", late_by);
  if (!expected.cause.empty()) text += fmt::format(" ({})", expected.cause);
  return text;
}

Asked asked_with(const SearchOptions& search) {
  return {search.precision, std::max(search.max_pops, Asked().max_pops)};
}

std::string cause_of_loss(const std::string& method, const Case& value) {
  const std::optional<Witness>& witness = value.truth.witness;
  if (!witness || witness->t > exact(value.query.t_max) || is_of_bodies(value.query)) return "";
  const auto made = make_method(method);
  if (!made || !(*made)->is_traceable()) return "";
  return loss_cause((*made)->trace(value.query, *witness, {}));
}

Judged Asker::ask_how_deep(const Failure& failure, const CheckedCase& known) {
  if (failure.outcome == Outcome::kError) return {};
  Judged judged = ask(failure.who, known);
  judged.depth = depth_of(known, judged).value_or(0);
  return judged;
}

Expected Asker::expected(const std::string& method, const Case& value, const Judged& judged) {
  if (judged.outcome == Outcome::kError) return {judged.outcome, judged.error};
  if (!is_failure(judged.outcome)) return judged.outcome;
  if (is_of_bodies(value.query)) return {judged.outcome, kind_of_bodies(value.query)};
  if (!is_false_negative(judged.outcome)) return judged.outcome;
  return {judged.outcome, cause_(method, value)};
}

std::optional<Failure> Asker::failure(const std::string& method, const Case& value,
                                      const Judged& judged) {
  const Expected shown = expected(method, value, judged);
  return is_failure(shown.outcome) ? std::optional(failure_of(value, method, shown)) : std::nullopt;
}

Expected Asker::expected_as_asked(const std::string& method, const CheckedCase& known) {
  SearchOptions own = search_;
  own.precision = known.value().asked.precision;
  own.max_pops = std::min(own.max_pops, known.value().asked.max_pops);
  return expected(method, known.value(), ask(method, known, own));
}

bool Asker::differs(const std::string& method, const CheckedCase& known, const Expected& shown,
                    const SearchOptions& search) {
  if (!names_plugin(method) || shown.cause == "hang") return false;
  constexpr int kTimes = 3;
  for (int i = 0; i < kTimes; ++i) {
    if (!(expected(method, known.value(), ask(method, known, search)) == shown)) return true;
  }
  return false;
}

void Asker::ask_others(Case& find, const std::vector<std::string>& methods) {
  SearchOptions few = search_;
  few.max_pops = std::min(few.max_pops, kEnoughPops);
  const CheckedCase known = checked_or_unknown(find);
  for (const std::string& method : methods) {
    if (find.expect.contains(method)) continue;
    const Judged judged = ask(method, known, few);
    if (judged.outcome == Outcome::kUndecided || judged.outcome == Outcome::kNotAsked) continue;
    find.expect[method] = expected(method, find, judged);
  }
}

}  // namespace ccdfuzz
