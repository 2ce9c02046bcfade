#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "ccd/certified/tdibm_c.hpp"
#include "ccd/rational/tdibm_rational.hpp"
#include "ccd/tdibm.hpp"
#include "ccd/traditional.hpp"
#include "method/method.hpp"
#include "method/parameter.hpp"

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

using MadeMethod = Result<std::unique_ptr<Method>>;

struct Family {
  MethodInfo info;
  std::function<MadeMethod(const std::string& spec)> make;
};

template <class Solver, class... Args>
Family family(MethodInfo info, Args... args) {
  return {std::move(info), [args...](const std::string&) -> MadeMethod {
            return std::make_unique<BuiltIn<Solver>>(args...);
          }};
}

/// A family whose spec ends in ":F", a pull-apart factor.
template <class Policy>
Family pull_apart_family(MethodInfo info) {
  return {std::move(info), [](const std::string& spec) {
            return parse_pull_apart(spec).and_then([](double factor) -> MadeMethod {
              return std::make_unique<BuiltIn<Tdibm<Policy>>>(Policy(factor));
            });
          }};
}

const std::vector<Family>& families() {
  constexpr const char* kChen = "Chen et al. 2024";
  constexpr const char* kErrorBounds =
      "Floating-Point Robustness in Parametric Surface CCD, Section 4.6";
  constexpr const char* kSnyder = "Snyder 1992; Von Herzen et al. 1990";
  static const std::vector<Family> all = {
      family<Traditional>(
          {"trad", kSnyder,
           "inclusion in time and parameters, oriented boxes, as Chen et al. have it", false},
          BoxKind::kOriented),
      family<Traditional>({"trad:aabb", kSnyder, "the same with axis-aligned boxes", false},
                          BoxKind::kAxisAligned),
      family<Tdibm<Plain>>(
          {"tdibm", kChen, "time-dependent inclusion in floating point, without guard", false}),
      pull_apart_family<PullApart>(
          {"tdibm-h:F", kChen, "tdibm with its envelopes pulled apart by the length F", false}),
      pull_apart_family<RelativePullApart>(
          {"tdibm-h-rel:F", "released code of Chen et al. 2024",
           "tdibm with its envelopes pulled apart by F times each intercept", false}),
      family<Tdibm<ErrorBoundIntended>>(
          {"tdibm-e", kErrorBounds, "tdibm with error bounds, eps_Phi's sign as Fig. 2 intends",
           true}),
      family<Tdibm<ErrorBoundPrinted>>({"tdibm-e-literal", kErrorBounds,
                                        "tdibm with error bounds, eps_Phi's sign as printed",
                                        true}),
      family<TdibmRational>({"tdibm-rational", "this project",
                             "tdibm decided in exact arithmetic, rounded only outward", true}),
      family<TdibmC>({"tdibm-c", "src/ccd/certified/DERIVATION.md",
                      "ours: separation certified at both ends of a window", true}),
  };
  return all;
}

std::string known_specs() {
  std::string specs;
  for (const Family& f : families()) {
    if (!specs.empty()) specs += ", ";
    specs += f.info.spec;
  }
  return specs;
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

Result<MethodInfo> method_info(const std::string& spec) {
  return find_family(spec).map([](const Family* found) { return found->info; });
}

Result<std::unique_ptr<Method>> make_method(const std::string& spec) {
  return find_family(spec).and_then([&](const Family* found) { return found->make(spec); });
}

Result<std::vector<std::string>> parse_method_list(const std::string& list) {
  std::vector<std::string> specs;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const std::string spec = list.substr(begin, end - begin);
    if (auto method = make_method(spec); !method) return tl::unexpected(method.error());
    if (std::ranges::find(specs, spec) != specs.end()) {
      return input_error("--methods", fmt::format("\"{}\" is named twice", spec));
    }
    specs.push_back(spec);
    begin = end + 1;
  }
  return specs;
}

}  // namespace ccdfuzz
