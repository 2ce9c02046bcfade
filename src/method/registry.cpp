#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "base/number_text.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "base/verify.hpp"
#include "ccd/certified/tdibm_c.hpp"
#include "ccd/rational/pair_test.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "ccd/tdibm.hpp"
#include "ccd/traditional.hpp"
#include "ccd/unoptimised.hpp"
#include "ccd/witness_trace/certified_tracer.hpp"
#include "ccd/witness_trace/inclusion_tracer.hpp"
#include "certify/oracle/oracle.hpp"
#include "method/method.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/plugin_method.hpp"
#include "method/plugin/plugin_spec.hpp"
#include "method/taken_query.hpp"

namespace ccdfuzz {

namespace {

/// Any class with `Answer answer(const Query&, const SearchOptions&)` as a Method, and one with
/// `const Trace& trace(const Query&, const Witness&, const TraceOptions&)` that traces it.
template <class Solver, class Follower>
class BuiltIn : public Method {
 public:
  template <class... Args>
  explicit BuiltIn(const Features& features, const Args&... args)
      : features_(features), solver_(args...), follower_(args...) {}

  Answered answer(const Query& query, const SearchOptions& options) override {
    const TakenQuery taken(query, features_);
    if (taken.query() != nullptr) return {solver_.answer(*taken.query(), options)};
    return no_answer(Verdict::kRefused, taken.why());
  }

  bool is_traceable() const override { return true; }
  const Trace& trace(const Query& query, const Witness& witness,
                     const TraceOptions& options) override {
    const TakenQuery taken(query, features_);
    CCDFUZZ_VERIFY(taken.query() != nullptr);
    return follower_.trace(*taken.query(), witness, options);
  }

 private:
  const Features features_;
  Solver solver_;
  Follower follower_;
};

/// "tdibm-h:1e-12@absolute@unit-axes" in its parts: a spec, and how it is to be read.
struct SwitchedSpec {
  std::string spec;                   ///< "tdibm-h:1e-12"
  std::vector<std::string> switches;  ///< "absolute", "unit-axes"

  explicit SwitchedSpec(const std::string& text) : switches(texts_between(text, '@')) {
    spec = switches.front();
    switches.erase(switches.begin());
  }
  bool has(std::string_view name) const {
    return std::ranges::find(switches, name) != switches.end();
  }
};

using Made = Result<std::unique_ptr<Method>>;

struct Family {
  MethodInfo info;
  std::function<Made(const Features&, const SwitchedSpec&)> make;
};

/// Solver answers, and Follower traces. Both are made of the parts.
template <class Solver, class Follower>
std::unique_ptr<Method> built_in(const Features& features, const auto&... parts) {
  return std::make_unique<BuiltIn<Solver, Follower>>(features, parts...);
}

/// A method that has no options.
template <class Solver, class Follower>
Family family(MethodInfo info) {
  return {std::move(info), [](const Features& features, const SwitchedSpec&) -> Made {
            return built_in<Solver, Follower>(features);
          }};
}

constexpr std::array kSwitches = {
    MethodSwitch{"unoptimised", "as written down from the paper; the answers are the same"},
    MethodSwitch{"unit-axes", "each separating axis has unit length"},
    MethodSwitch{"exact-windows",
                 "Steps II and III look at a window alone, not 1e-6 past its ends"},
    MethodSwitch{"slip", "v of patch 2's box moves as u does, as typed in the released code"},
    MethodSwitch{"absolute", "each intercept is pulled apart by the length F"},
    MethodSwitch{"count-pairs", "I of I\u03b4 counts pairs of lines, not the steps between them"}};

/// A reading with what the switches of a spec change of it.
Reading reading_of(const SwitchedSpec& spec, Reading reading) {
  if (spec.has("unit-axes")) reading.axes.length = AxisReading::Length::kUnit;
  if (spec.has("exact-windows")) reading.window_margin = 0;
  if (spec.has("slip")) reading.axes.spans = AxisReading::Spans::kSidesWithSlip;
  return reading;
}

/// tdibm-h:F. Errors: F is no number ≥ 0.
Result<PullApart> pull_apart_of(const SwitchedSpec& spec) {
  const size_t colon = spec.spec.find(':');
  const std::string text = colon == std::string::npos ? "" : spec.spec.substr(colon + 1);
  const Result<double> factor = parse_number("", text);
  if (factor && *factor >= 0 && !text.starts_with('-')) {
    return PullApart(*factor, spec.has("absolute") ? PullUnit::kLength : PullUnit::kIntercept);
  }
  return input_error("method", "\"{}\" needs a pull-apart factor ≥ 0, as in tdibm-h:1e-12{}",
                     spec.spec, text.empty() || factor ? "" : "; " + factor.error().what);
}

/// A family of TdibmInclusion. policy_of: of a spec.
template <class Policy>
Family tdibm_family(MethodInfo info, Result<Policy> (*policy_of)(const SwitchedSpec&)) {
  return {std::move(info), [policy_of](const Features& features, const SwitchedSpec& spec) {
            return policy_of(spec).map([&](const Policy& policy) {
              using Follower = InclusionTracer<TdibmInclusion<Policy>>;
              const Reading reading = reading_of(spec, Policy::kReading);
              return spec.has("unoptimised")
                         ? built_in<UnoptimisedTdibm<Policy>, Follower>(features, policy, reading)
                         : built_in<Tdibm<Policy>, Follower>(features, policy, reading);
            });
          }};
}

template <class Bound>
Result<Bound> error_bound_of(const SwitchedSpec& spec) {
  Bound bound;
  if (spec.has("count-pairs")) bound.count = PullCount::kPairs;
  return bound;
}

Family traditional_family(MethodInfo info, BoxKind kind) {
  return {std::move(info), [kind](const Features& features, const SwitchedSpec& spec) -> Made {
            const AxisReading axes = reading_of(spec, {kTraditionalAsReleased}).axes;
            return built_in<Traditional, InclusionTracer<TraditionalInclusion>>(features, kind,
                                                                                axes);
          }};
}

const std::vector<Family>& families() {
  constexpr const char* kChen = "released code of Chen et al. 2024";
  constexpr const char* kErrorBounds =
      "Floating-Point Robustness in Parametric Surface CCD, Section 4.6";
  constexpr const char* kSnyder = "Snyder 1992; Von Herzen et al. 1990";
  const std::vector<std::string> none, axes = {"unit-axes"};
  const std::vector<std::string> released = {"unoptimised", "unit-axes", "exact-windows", "slip"};
  std::vector<std::string> pulled = released;
  pulled.emplace_back("absolute");
  const std::vector<std::string> bounded = {"unoptimised", "unit-axes", "count-pairs"};
  // Sub-patches with their weights divided out are as good as others.
  constexpr Features kDivided = {.weights = true, .trims = true};
  constexpr bool kProven = true;
  static const std::vector<Family> all = {
      traditional_family(
          {"trad", kSnyder,
           "inclusion in time and parameters, oriented boxes, as Chen et al. have it", false, axes,
           kDivided},
          BoxKind::kOriented),
      traditional_family(
          {"trad:aabb", kSnyder, "the same with axis-aligned boxes", false, none, kDivided},
          BoxKind::kAxisAligned),
      tdibm_family<Plain>(
          {"tdibm", kChen, "time-dependent inclusion in floating point, without guard", false,
           released, kDivided},
          [](const SwitchedSpec&) -> Result<Plain> { return Plain(); }),
      tdibm_family<PullApart>(
          {"tdibm-h:F", kChen, "tdibm with its envelopes pulled apart by F times each intercept",
           false, pulled, kDivided},
          pull_apart_of),
      tdibm_family<ErrorBoundIntended>(
          {"tdibm-e", kErrorBounds, "tdibm with error bounds, eps_Phi's sign as Fig. 2 intends",
           true, bounded, kDivided},
          error_bound_of<ErrorBoundIntended>),
      tdibm_family<ErrorBoundPrinted>(
          {"tdibm-e-literal", kErrorBounds, "tdibm with error bounds, eps_Phi's sign as printed",
           true, bounded, kDivided},
          error_bound_of<ErrorBoundPrinted>),
      family<TdibmRational, InclusionTracer<exact_ccd::PairTest>>(
          {"tdibm-rational", "this project",
           "tdibm decided in exact arithmetic, rounded only outward", true, none, kPatchFeatures,
           kProven}),
      family<TdibmC, CertifiedTracer>({"tdibm-c", "src/ccd/certified/DERIVATION.md",
                                       "ours: separation certified at both ends of a window", true,
                                       none, kPatchFeatures, kProven}),
      // What it searches with is tdibm-c, so that is what a witness is followed through.
      family<Oracle, CertifiedTracer>(
          {"oracle", "src/certify/oracle/oracle.hpp",
           "ours: says nothing that an independent checker has not proven; slower", true, none,
           kAllFeatures, kProven}),
  };
  return all;
}

struct Found {
  const Family* family;
  SwitchedSpec spec;
};

/// The family with this very spec, or the one that takes a parameter under its name, and what
/// stands behind it. Errors: an unknown method; a switch that it does not take, or takes once.
Result<Found> find_family(const std::string& text) {
  Found found{nullptr, SwitchedSpec(text)};
  const std::string name = found.spec.spec.substr(0, found.spec.spec.find(':'));
  for (const Family& f : families()) {
    if (f.info.spec == found.spec.spec || f.info.spec == name + ":F") found.family = &f;
  }
  if (found.family == nullptr) {
    std::vector<std::string> specs;
    for (const Family& f : families()) specs.push_back(f.info.spec);
    std::error_code none;
    const char* const prefix = text.ends_with(".so") ? kPluginPrefix : kPluginProgramPrefix;
    const std::string named = kPluginPrefix + text;
    // The paper writes TDIBM-E.
    std::string lower = text;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string meant = is_admitted(named)                             ? named
                              : std::filesystem::is_regular_file(text, none) ? prefix + text
                              : lower != text && find_family(lower)          ? lower
                                                                             : "";
    return input_error(
        "method",
        "unknown method \"{}\"{}; known are {}, plugin:PATH, "
        "plugin-exec:PATH",
        text, meant.empty() ? did_you_mean(lower, specs) : fmt::format("; did you mean {}?", meant),
        fmt::join(specs, ", "));
  }
  const std::vector<std::string>& known = found.family->info.switches;
  std::vector<std::string> left = known;
  for (const std::string& name_of_switch : found.spec.switches) {
    if (std::erase(left, name_of_switch) != 0) continue;
    return input_error(
        "method", "\"{}\": {} takes {}", text, found.family->info.spec,
        known.empty() ? "no @switches" : fmt::format("each once, @{}", fmt::join(known, ", @")));
  }
  return found;
}

}  // namespace

Answered timed_answer(Method& method, const Query& query, const SearchOptions& options) {
  const Stopwatch watch;
  Answered answer = method.answer(query, options);
  const double passed = watch.seconds();
  if (answer.seconds == 0) answer.seconds = passed;
  return answer;
}

const Trace& Method::trace(const Query&, const Witness&, const TraceOptions&) {
  throw InternalError("this method cannot be traced");
}

std::span<const MethodSwitch> method_switches() {
  return kSwitches;
}

const std::vector<MethodInfo>& registered_methods() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> out;
    for (const Family& f : families()) out.push_back(f.info);
    return out;
  }();
  return infos;
}

std::string spec_of(const MethodInfo& info) {
  std::string spec = info.spec;
  if (spec.ends_with(":F")) spec.replace(spec.size() - 1, 1, "1e-12");
  return spec;
}

std::vector<std::string> every_method_but(const std::vector<std::string>& named,
                                          bool MethodInfo::*mark) {
  std::vector<std::string> specs;
  for (const MethodInfo& info : registered_methods()) {
    if (mark != nullptr && !(info.*mark)) continue;
    const std::string spec = spec_of(info);
    if (std::ranges::find(named, spec) == named.end()) specs.push_back(spec);
  }
  return specs;
}

Result<MethodInfo> method_info(const std::string& spec) {
  if (names_plugin(spec)) {
    return know_plugin(spec).map([](const auto& known) { return plugin_info(*known); });
  }
  return find_family(spec).map([](const Found& found) { return found.family->info; });
}

bool claims_no_false_negative(const std::string& spec) {
  const Result<MethodInfo> info = method_info(spec);
  return info && info->claims_no_false_negative;
}

Result<void> check_taken(const std::string& spec, const Query& query) {
  return method_info(spec).and_then([&](const MethodInfo& info) -> Result<void> {
    const TakenQuery taken(query, info.features);
    if (taken.query() != nullptr) return {};
    return input_error(spec, taken.why());
  });
}

Result<std::unique_ptr<Method>> make_method(const std::string& spec) {
  if (names_plugin(spec)) return know_plugin(spec).map(make_plugin_method);
  return find_family(spec).and_then([](const Found& found) {
    return found.family->make(found.family->info.features, found.spec);
  });
}

Result<std::string> parse_method(const std::string& where, const std::string& spec) {
  const auto at = [&](const InputError& error) { return InputError{where, error.what}; };
  CCDFUZZ_TRY_VOID(admit_plugin(spec).map_error(at));
  CCDFUZZ_TRY_VOID(make_method(spec).map_error(at));
  return spec;
}

}  // namespace ccdfuzz
