#include "method/served_method.hpp"

#include <algorithm>
#include <cmath>

#include "files/case_json.hpp"
#include "io/fields.hpp"
#include "io/serve.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/plugin_method.hpp"

namespace ccdfuzz {

namespace {

/// A question of the line protocol, but for the query, which stands as in a case.
struct Question {
  std::string ask;
  std::uint64_t id = 0;
  SearchOptions options;

  static void fields(auto& archive, auto& question) {
    archive("ask", question.ask);
    archive.optional("id", question.id);
    limit_fields(archive, question.options);
  }
};

}  // namespace

std::string served_answer(const std::string& spec, Method& method, const std::string& question) {
  const auto asked =
      value_or_throw(from_json<Question>(question, "the question", Unknown::kIgnore));
  if (asked.ask == "describe") {
    const Result<MethodInfo> info = method_info(spec);
    return to_json([&](auto& description) {
      description("protocol", 1);
      description("name", spec);
      description("conservative", info && info->claims_no_false_negative);
      for (const FeatureClaim& claim : kFeatureClaims) {
        description(claim.field, info && info->features.*claim.feature);
      }
    });
  }
  const Query query = value_or_throw(parse_query(question, "the question"));
  const Answer answer = timed_answer(method, query, asked.options);
  const bool is_finite =
      std::ranges::all_of(std::array{answer.toi.value_or(0), answer.uv[0][0], answer.uv[0][1],
                                     answer.uv[1][0], answer.uv[1][1], answer.seconds},
                          [](double x) { return std::isfinite(x); });
  if (!is_finite) throw std::range_error("the answer holds a number that is not finite");
  return to_json([&](auto& said) {
    said("id", asked.id);
    said("verdict", word_of(answer.verdict));
    said("toi", answer.toi);
    said("uv", std::array{std::array{answer.uv[0][0], answer.uv[0][1]},
                          std::array{answer.uv[1][0], answer.uv[1][1]}});
    said("iterations", answer.pops);
    said("bytes", answer.bytes);
    said("seconds", answer.seconds);
    said("message", answer.note);
  });
}

Result<std::unique_ptr<Method>> served_method(const std::string& spec, const ChildLimits& limits) {
  return served_child({spec}, limits).map([&](ChildProgram program) {
    KnownPlugin plugin;
    plugin.spec.text = spec;
    plugin.spec.repeats = false;
    plugin.spec.seconds = SearchOptions::kNoTimeLimit;
    plugin.program = std::move(program);
    plugin.is_ours = true;
    return make_plugin_method(std::make_shared<const KnownPlugin>(std::move(plugin)));
  });
}

Result<std::unique_ptr<Method>> make_served_method(const std::string& spec) {
  Result<std::unique_ptr<Method>> made = make_method(spec);
  if (!made || (*made)->runs_elsewhere()) return made;
  return served_method(spec, kServedLimits);
}

}  // namespace ccdfuzz
