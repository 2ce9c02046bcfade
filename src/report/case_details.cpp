#include "report/case_details.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "ccd/witness_trace/loss_signature.hpp"
#include "files/case_json.hpp"
#include "files/test_snippet.hpp"
#include "finds/content_address.hpp"
#include "finds/failure.hpp"
#include "report/loss.hpp"

namespace ccdfuzz {

namespace {

using Json = nlohmann::ordered_json;

/// The number as a text of `digits` digits says it: shorter, for what is only drawn.
double shortened(double x, int digits = 6) {
  return std::strtod(fmt::format("{:.{}g}", x, digits).c_str(), nullptr);
}

/// x − t, rounded once.
double from(const Rational& t, double x) {
  return Rational(exact(x) - t).get_d();
}

Json or_null(const auto& x) {
  return x ? Json(*x) : Json();
}

Json pair_of(double a, double b) {
  return Json::array({a, b});
}

Json cells_json(const TracePlace& place) {
  Json cells = Json::array();
  for (const Cell& cell : place.cells) {
    cells.push_back(Json::array({cell.i, cell.j, cell.inverted ? 1 : 0}));
  }
  return cells;
}

Json axis_json(const ExcludedInterval& by) {
  return {{"axis", by.axis},
          {"direction", {by.direction[0], by.direction[1], by.direction[2]}},
          {"below", by.below},
          {"excluded", {by.times.lo, by.times.hi}},
          {"cut", {by.times.has_lo, by.times.has_hi}}};
}

Json loss_json(const Case& known, const Trace::Loss& loss) {
  Json row = {{"level", loss.place.level},
              {"cells", cells_json(loss.place)},
              {"window", pair_of(loss.place.window.lo, loss.place.window.hi)},
              {"left", nullptr}};
  if (loss.left) row["left"] = pair_of(loss.left->lo, loss.left->hi);
  if (loss.by.axis < 0) return row;
  row.update(axis_json(loss.by));
  const LossFacts facts = facts_of(known.query, *known.truth.witness, loss);
  row["overlap"] = facts.overlap ? Json(facts.overlap->length) : Json();
  row["height_ulp"] = facts.overlap ? Json(facts.overlap->height_ulp) : Json();
  row["ulps_past"] = or_null(facts.ulps_past);
  return row;
}

/// [level, window from t*, to t*, cells, ulps, axis, direction, below, excluded from t*]
Json step_json(const Rational& t, const Trace::Step& step) {
  Json row = Json::array(
      {step.place.level,
       pair_of(shortened(from(t, step.place.window.lo)), shortened(from(t, step.place.window.hi))),
       cells_json(step.place), nullptr, nullptr, nullptr, nullptr, nullptr});
  if (!step.margin) return row;
  const ExcludedInterval& by = step.margin->by;
  row[3] = shortened(static_cast<double>(step.margin->ulps), 4);
  row[4] = by.axis;
  row[5] = Json::array();
  for (int k = 0; k < 3; ++k) row[5].push_back(shortened(by.direction[k], 7));
  row[6] = by.below;
  row[7] = pair_of(shortened(from(t, by.times.lo)), shortened(from(t, by.times.hi)));
  return row;
}

Json trace_json(const Case& known, const std::string& method, const Trace& trace) {
  Json row = {{"method", method}, {"lost", trace.lost}, {"levels", trace.levels}};
  if (trace.loss) row["loss"] = loss_json(known, *trace.loss);
  if (trace.margin) {
    row["margin"] = {{"level", trace.margin->place.level}, {"ulps", trace.margin->ulps}};
  }
  row["steps"] = Json::array();
  for (const Trace::Step& step : trace.steps) {
    row["steps"].push_back(step_json(known.truth.witness->t, step));
  }
  return row;
}

/// [method, level, axis, ulps in time]
Json worst_json(const std::string& method, const Json& loss) {
  return Json::array(
      {method, loss["level"], loss.value("axis", -1), loss.value("ulps_past", Json())});
}

/// The steps' cells are the same for every method that follows the same path: each is written once.
void share_cells(Json& traces, Json& cells) {
  for (Json& trace : traces) {
    for (Json& step : trace["steps"]) {
      const auto level = step[0].get<size_t>();
      while (cells.size() <= level) cells.push_back(nullptr);
      if (cells[level].is_null()) cells[level] = step[2];
      if (cells[level] == step[2]) step[2] = nullptr;
    }
  }
}

/// c correct, m missed, l late, f false positive, u undecided, ? unknown, e error, - not asked.
char letter_of(Outcome outcome) {
  constexpr std::string_view kLetters = "cmlfu?e-";
  static_assert(kLetters.size() == kAllOutcomes.size());
  return kLetters[static_cast<size_t>(outcome)];
}

}  // namespace

std::string json_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

CaseText describe(const ReportedCase& reported, const std::vector<std::string>& methods,
                  bool trace_all) {
  const Case& known = reported.value;
  const bool failed = reported.has_failure();
  const auto& witness = known.truth.witness;
  const bool traceable = witness && witness->t <= exact(known.query.t_max);
  std::string outcomes(methods.size(), '-');
  Json answers = Json::object(), traces = Json::array(), causes = Json::object(), worst;
  for (const Failure& failure : failures_of(known)) {
    if (!failure.cause.empty()) causes[failure.who] = failure.cause;
  }
  for (const GivenAnswer& answer : reported.answers) {
    const auto at = std::ranges::find(methods, answer.method);
    if (at == methods.end()) continue;
    outcomes[static_cast<size_t>(at - methods.begin())] = letter_of(answer.outcome);
    answers[answer.method] = {{"outcome", name_of(answer.outcome)}, {"toi", or_null(answer.toi)}};
    if (!traceable || (failed && !trace_all && !is_failure(answer.outcome))) continue;
    if (answer.outcome == Outcome::kError || answer.outcome == Outcome::kNotAsked) {
      continue;  // it would do here what it did there
    }
    const auto method = make_method(answer.method);
    if (!method || !(*method)->is_traceable() || is_of_bodies(known.query))
      continue;  // a plug-in, of which nothing is seen but its answer
    const Trace& traced =
        (*method)->trace(known.query, *witness, {reported.precision, false, true});
    traces.push_back(trace_json(known, answer.method, traced));
    const Json& trace = traces.back();
    if (!is_failure(answer.outcome)) continue;
    causes.emplace(answer.method, loss_cause(traced));
    if (worst.is_null() && trace.contains("loss")) worst = worst_json(answer.method, trace["loss"]);
  }
  Json cells = Json::array();
  share_cells(traces, cells);
  constexpr TestFramework kGoogleTest = TestFramework::kGoogleTest;
  const Result<std::string> test = test_snippet({reported.id, known}, 1, kGoogleTest);
  const Json details = {
      {"reproduce", reported.reproduce},
      {"gtest", test ? test_preamble(kGoogleTest) + *test : "// " + test.error().message() + "\n"},
      {"answers", answers},
      {"cells", cells},
      {"traces", traces}};
  const Origin& origin = known.origin;
  std::string text = json_text(details);
  text.pop_back();
  return {Json::array({reported.id, origin.contact, origin.kind, origin.generator, outcomes,
                       or_null(reported.is_new), worst, name_of(setting_of(known)),
                       size_of(known.query).significant_bits, causes}),
          text + ",\"case\":" + to_json(known) + "}"};
}

}  // namespace ccdfuzz
