#include "hunt/triage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/serve.hpp"
#include "case/case_json.hpp"
#include "case/horizons.hpp"
#include "case/tree_file.hpp"
#include "ccd/witness_trace/loss_signature.hpp"
#include "certify/oracle/oracle.hpp"
#include "finds/failure.hpp"
#include "fuzz/mutator/witnessed_query.hpp"
#include "hunt/expect_of_others.hpp"
#include "hunt/shrink.hpp"
#include "properties/against_oracle.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kOracle = "oracle";

struct Errand {
  std::string name, method;
  std::string value;  ///< a case, as JSON

  static void fields(auto& archive, auto& errand) {
    archive("errand", errand.name);
    archive("method", errand.method);
    archive("case", errand.value);
  }
};

struct Told {
  std::string text;

  static void fields(auto& archive, auto& told) { archive("text", told.text); }
};

std::string loss_by(const std::string& method, const Case& value) {
  TracerSet tracers;
  Tracer* const tracer = tracers.find(method);
  return tracer == nullptr ? "" : loss_cause(tracer->trace(value.query, *value.truth.witness, {}));
}

}  // namespace

Case decided_with_little_effort(const Case& candidate) {
  OracleOptions little;
  little.max_pops = kEnoughPops;
  little.max_tree_nodes = 10 * kEnoughPops;  // as decide_briefly
  Decision decision = decide(candidate.query, little);
  drop_tree(decision.truth);
  Case known = candidate;
  known.truth = std::move(decision.truth);
  if (const auto q = witnessed_query(known)) {
    known.origin.contact = name_of(contact_class_of(*q));
    known.origin.kind = name_of(CaseKind::kRP);
  }
  return known;
}

std::string refutation_by_sound_methods(const Case& known) {
  const std::optional<Witness>& witness = known.truth.witness;
  if (witness && witness->t <= exact(known.query.t_max)) {
    TracerSet tracers;
    for (const char* method : kMissNothing) {
      const Trace& trace = tracers[method].trace(known.query, *witness, {});
      if (!trace.lost) continue;
      return fmt::format("the witness trace of {} loses the contact (ccdfuzz trace shows it): {}",
                         method, loss_signature(trace));
    }
  }
  const Check check = claims_agree(known.query, kRefutationPops, kRefutationSearch);
  return check.status == Check::Status::kFails ? check.text : "";
}

Triage::Triage(Store& store, TriageOptions options)
    : store_(store), options_(std::move(options)), methods_(options_.make) {}

void Triage::know(const Case& entry) {
  for (const auto& [method, expected] : entry.expect) {
    if (!is_failure(expected.outcome)) continue;
    Judged judged;
    judged.outcome = expected.outcome;
    if (judged.outcome == Outcome::kError) judged.error = expected.cause;
    had_.insert(signature_of(method, entry, judged));
  }
}

Result<void> Triage::add(const Case& candidate,
                         const std::function<void(const TriageFind&)>& found) {
  ++tally_.inputs;
  const auto decided = with_truth(candidate);
  const Case& known = decided.value_or(candidate);
  std::vector<std::string> methods = options_.methods;
  if (!decided && std::ranges::find(methods, kOracle) == methods.end()) methods.push_back(kOracle);
  bool fails = false, sound_fails = false;
  for (const std::string& method : methods) {
    if (options_.stop()) return {};
    const std::optional<Failure> failure = confirm(method, known);
    if (!failure && !decided && method == kOracle) {
      options_.warn(fmt::format("nobody knows the truth, since the oracle came to grief: {}: {}",
                                decided.error().name, decided.error().note));
    }
    if (!failure) continue;
    fails = true;
    sound_fails = sound_fails || method == kOracle ||
                  std::ranges::find(kMissNothing, method) != kMissNothing.end();
    ++tally_.failures;
    const Signature signature = signature_of(method, failure->asked, failure->judged);
    if (had_.contains(signature)) {
      ++tally_.known;
      continue;
    }
    Case small = shrink(failure->asked, method, methods_[method], failure->judged, options_.search,
                        {options_.shrink_trials, options_.stop})
                     .value;
    if (method != kOracle) small = with_truth(small).value_or(small);
    // What is not shrunk to the end is left to another time, which would find it anew; but not a
    // hang, which would take as long again.
    if (options_.stop() && failure->judged.error != "hang") continue;
    // Shrinking may make one loss into another. Only what is stored is had: the next failure that
    // looks like this one did may come down to a third.
    const Signature shrunk = signature_of(method, small, failure->judged);
    if (!had_.insert(shrunk).second) {
      ++tally_.known;
      continue;
    }
    TriageFind find{method, failure->judged.outcome, failure->judged.error,
                    std::get<kLossPlace>(shrunk), small};
    if (!find.loss.empty()) find.value.expect[method].cause = find.loss;
    complete(find.value);
    if (const auto added = store_.add(find.value); !added) return tl::unexpected(added.error());
    found(find);
  }
  if (!fails) ++tally_.saved;
  if (sound_fails) return {};
  const auto refutation = told("refute", known);
  if (refutation && refutation->empty()) return {};
  ++tally_.refuting;
  options_.warn(fmt::format("no full run of a sound method fails, but: {}",
                            refutation ? *refutation : refutation.error().name));
  return {};
}

std::string TriageErrands::done(const std::string& question) const {
  const Errand errand = from_json<Errand>(question, "the question").value();
  const Case value = parse_case(errand.value, "the question").value();
  if (errand.name == "decide") return to_json(Told{to_json(decide(value))});
  if (errand.name == "refute") return to_json(Told{refute(value)});
  return to_json(Told{loss_by(errand.method, value)});
}

tl::expected<std::string, Fault> Triage::told(const char* errand, const Case& value,
                                              const std::string& method) {
  if (!errands_) {
    errands_.emplace(value_or_throw(served_child(options_.errands, kServedLimits)));
  }
  return ask_served<Told>(*errands_, to_json(Errand{errand, method, to_json(value)}))
      .map([](const Told& told) { return told.text; });
}

tl::expected<Case, Fault> Triage::with_truth(const Case& candidate) {
  if (candidate.truth.collides) return candidate;
  return told("decide", candidate).map([](const std::string& json) {
    return parse_case(json, "what the oracle decided").value();
  });
}

std::optional<Triage::Failure> Triage::confirm(const std::string& method, const Case& known) {
  const auto asked_alike = [&](const Case& asked) -> std::optional<Failure> {
    Judged judged = ask(methods_[method], asked, options_.search);
    if (!is_failure(judged.outcome)) return std::nullopt;
    return Failure{asked, std::move(judged)};
  };
  bool as_it_stands = false;  // was asked: a fuzzer may have left any t_max
  for (const double factor : kHorizonFactors) {
    const std::optional<Case> asked = at_horizon(known, factor);  // none without a witness
    if (!asked) continue;
    if (auto failure = asked_alike(*asked)) return failure;
    as_it_stands = as_it_stands || asked->query.t_max == known.query.t_max;
  }
  if (as_it_stands) return std::nullopt;
  return asked_alike(with_t_max(known, known.query.t_max));
}

Triage::Signature Triage::signature_of(const std::string& method, const Case& value,
                                       const Judged& judged) {
  if (judged.outcome == Outcome::kError) return {method, "", judged.outcome, judged.error, ""};
  return {method, value.origin.contact, judged.outcome, judged.error, loss_of(method, value)};
}

std::string Triage::loss_of(const std::string& method, const Case& value) {
  const std::optional<Witness>& witness = value.truth.witness;
  if (!witness || witness->t > exact(value.query.t_max)) return "";
  // It answers the query, but the trace may look further than the search did.
  return told("loss", value, method).value_or("");
}

void Triage::complete(Case& value) {
  expect_of_others(value, options_.methods, methods_, options_.search, "",
                   [&](const std::string& method, const Judged& judged) {
                     if (!is_failure(judged.outcome)) return;
                     const Signature signature = signature_of(method, value, judged);
                     had_.insert(signature);
                     const std::string& loss = std::get<kLossPlace>(signature);
                     if (!loss.empty()) value.expect[method].cause = loss;
                   });
}

}  // namespace ccdfuzz
