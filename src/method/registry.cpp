#include <fmt/format.h>

#include <algorithm>
#include <functional>

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
#include "method/parameter.hpp"
#include "method/plugin/plugin_method.hpp"

namespace ccdfuzz {

namespace {

/// Any class with `Answer answer(const Query&, const SearchOptions&)` as a Method.
template <class Solver>
class BuiltIn : public Method {
 public:
  template <class... Args>
  explicit BuiltIn(Args&&... args) : solver_(std::forward<Args>(args)...) {}

  Answer answer(const Query& query, const SearchOptions& options) override {
    return solver_.answer(query, options);
  }

 private:
  Solver solver_;
};

/// Any class with `const Trace& trace(const Query&, const Witness&, const TraceOptions&)` as a
/// Tracer.
template <class Follower>
class BuiltInTracer : public Tracer {
 public:
  template <class... Args>
  explicit BuiltInTracer(Args&&... args) : follower_(std::forward<Args>(args)...) {}

  const Trace& trace(const Query& query, const Witness& witness,
                     const TraceOptions& options) override {
    return follower_.trace(query, witness, options);
  }

 private:
  Follower follower_;
};

using MadeMethod = Result<std::unique_ptr<Method>>;
using MadeTracer = Result<std::unique_ptr<Tracer>>;

struct Family {
  MethodInfo info;
  std::function<MadeMethod(const std::string& spec)> make;
  std::function<MadeTracer(const std::string& spec)> make_tracer;
  /// The same method as one would write it down from the paper; empty if there is no such form.
  std::function<MadeMethod(const std::string& spec)> make_unoptimised = nullptr;
};

/// Solver answers, Follower traces; both are made of the same arguments.
template <class Solver, class Follower, class... Args>
Family family(MethodInfo info, Args... args) {
  return {std::move(info),
          [args...](const std::string&) -> MadeMethod {
            return std::make_unique<BuiltIn<Solver>>(args...);
          },
          [args...](const std::string&) -> MadeTracer {
            return std::make_unique<BuiltInTracer<Follower>>(args...);
          }};
}

template <class Policy>
Family tdibm_family(MethodInfo info) {
  Family made =
      family<Tdibm<Policy>, InclusionTracer<TdibmInclusion<Policy>>>(std::move(info), Policy());
  made.make_unoptimised = [](const std::string&) -> MadeMethod {
    return std::make_unique<BuiltIn<UnoptimisedTdibm<Policy>>>();
  };
  return made;
}

/// A family whose spec ends in ":F", a pull-apart factor.
template <class Policy>
Family pull_apart_family(MethodInfo info) {
  return {std::move(info),
          [](const std::string& spec) {
            return parse_pull_apart(spec).and_then([](double factor) -> MadeMethod {
              return std::make_unique<BuiltIn<Tdibm<Policy>>>(Policy(factor));
            });
          },
          [](const std::string& spec) {
            return parse_pull_apart(spec).and_then([](double factor) -> MadeTracer {
              using Follower = InclusionTracer<TdibmInclusion<Policy>>;
              return std::make_unique<BuiltInTracer<Follower>>(Policy(factor));
            });
          },
          [](const std::string& spec) {
            return parse_pull_apart(spec).and_then([](double factor) -> MadeMethod {
              return std::make_unique<BuiltIn<UnoptimisedTdibm<Policy>>>(Policy(factor));
            });
          }};
}

const std::vector<Family>& families() {
  constexpr const char* kChen = "Chen et al. 2024";
  constexpr const char* kErrorBounds =
      "Floating-Point Robustness in Parametric Surface CCD, Section 4.6";
  constexpr const char* kSnyder = "Snyder 1992; Von Herzen et al. 1990";
  static const std::vector<Family> all = {
      family<Traditional, InclusionTracer<TraditionalInclusion>>(
          {"trad", kSnyder,
           "inclusion in time and parameters, oriented boxes, as Chen et al. have it", false},
          BoxKind::kOriented),
      family<Traditional, InclusionTracer<TraditionalInclusion>>(
          {"trad:aabb", kSnyder, "the same with axis-aligned boxes", false}, BoxKind::kAxisAligned),
      tdibm_family<Plain>(
          {"tdibm", kChen, "time-dependent inclusion in floating point, without guard", false}),
      pull_apart_family<PullApart>(
          {"tdibm-h:F", kChen, "tdibm with its envelopes pulled apart by the length F", false}),
      pull_apart_family<RelativePullApart>(
          {"tdibm-h-rel:F", "released code of Chen et al. 2024",
           "tdibm with its envelopes pulled apart by F times each intercept", false}),
      tdibm_family<ErrorBoundIntended>({"tdibm-e", kErrorBounds,
                                        "tdibm with error bounds, eps_Phi's sign as Fig. 2 intends",
                                        true}),
      tdibm_family<ErrorBoundPrinted>({"tdibm-e-literal", kErrorBounds,
                                       "tdibm with error bounds, eps_Phi's sign as printed", true}),
      family<TdibmRational, InclusionTracer<exact_ccd::PairTest>>(
          {"tdibm-rational", "this project",
           "tdibm decided in exact arithmetic, rounded only outward", true}),
      family<TdibmC, CertifiedTracer>({"tdibm-c", "src/ccd/certified/DERIVATION.md",
                                       "ours: separation certified at both ends of a window",
                                       true}),
      // What it searches with is tdibm-c, so that is what a witness is followed through.
      family<Oracle, CertifiedTracer>(
          {"oracle", "src/certify/oracle/oracle.hpp",
           "ours: says nothing that an independent checker has not proven; slower", true}),
  };
  return all;
}

std::string known_specs() {
  std::string specs;
  for (const Family& f : families()) {
    if (!specs.empty()) specs += ", ";
    specs += f.info.spec;
  }
  return specs + ", plugin:PATH, plugin-exec:PATH";
}

/// "tdibm-e@unoptimised" is {"tdibm-e", true}.
struct Form {
  std::string spec;
  bool unoptimised = false;
};

Form form_of(const std::string& spec) {
  if (!spec.ends_with(kUnoptimised)) return {spec, false};
  return {spec.substr(0, spec.size() - kUnoptimised.size()), true};
}

/// The family with this very spec, or the one that takes a parameter under its name.
Result<const Family*> find_family(const std::string& spec) {
  const std::string with_parameter = split_spec(spec).name + ":F";
  for (const Family& f : families()) {
    if (f.info.spec == spec || f.info.spec == with_parameter) return &f;
  }
  return input_error("--methods",
                     fmt::format("unknown method \"{}\"; known are {}", spec, known_specs()));
}

}  // namespace

const std::vector<MethodInfo>& registered_methods() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> out;
    for (const Family& f : families()) out.push_back(f.info);
    return out;
  }();
  return infos;
}

Result<void> admit_plugin(const std::string& spec) {
  if (!names_plugin(spec)) return {};
  return meet_plugin(spec).map([](const auto&) {});
}

bool is_admitted(const std::string& spec) {
  return !names_plugin(spec) || know_plugin(spec).has_value();
}

Result<MethodInfo> method_info(const std::string& spec) {
  if (names_plugin(spec)) {
    return know_plugin(spec).map([](const auto& known) { return plugin_info(*known); });
  }
  return find_family(form_of(spec).spec).map([](const Family* found) { return found->info; });
}

Result<std::unique_ptr<Method>> make_method(const std::string& spec) {
  if (names_plugin(spec)) return know_plugin(spec).map(make_plugin_method);
  const Form form = form_of(spec);
  if (!form.unoptimised) {
    return find_family(spec).and_then([&](const Family* found) { return found->make(spec); });
  }
  const Result<const Family*> found = find_family(form.spec);
  if (found && (*found)->make_unoptimised) {
    if (MadeMethod made = (*found)->make_unoptimised(form.spec)) return made;
  }
  return input_error("--methods", fmt::format("\"{}\" is not the spec of a method of the paper "
                                              "with \"{}\" after it",
                                              spec, kUnoptimised));
}

Result<std::unique_ptr<Tracer>> make_tracer(const std::string& spec) {
  if (names_plugin(spec)) {
    return input_error("--methods", fmt::format("\"{}\" is a plug-in: what it does inside cannot "
                                                "be traced",
                                                spec));
  }
  // Both forms answer alike.
  const std::string& plain = form_of(spec).spec;
  return find_family(plain).and_then(
      [&](const Family* found) { return found->make_tracer(plain); });
}

Result<std::vector<std::string>> parse_method_list(const std::string& list) {
  std::vector<std::string> specs;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const std::string spec = list.substr(begin, end - begin);
    const auto method = admit_plugin(spec).and_then([&] { return make_method(spec); });
    if (!method) return tl::unexpected(method.error());
    if (std::ranges::find(specs, spec) != specs.end()) {
      return input_error("--methods", fmt::format("\"{}\" is named twice", spec));
    }
    specs.push_back(spec);
    begin = end + 1;
  }
  return specs;
}

}  // namespace ccdfuzz
