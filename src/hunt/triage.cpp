#include "hunt/triage.hpp"

#include <algorithm>

#include "ccd/witness_trace/loss_signature.hpp"
#include "certify/oracle/oracle.hpp"
#include "corpus/failure.hpp"
#include "eval/horizons.hpp"
#include "fuzz/mutator/witnessed_query.hpp"
#include "hunt/expect_of_others.hpp"
#include "hunt/shrink.hpp"

namespace ccdfuzz {

namespace {

/// The truth of a case that has none, as far as little effort gives one.
Case with_truth(const Case& candidate) {
  if (candidate.truth.collides) return candidate;
  OracleOptions little;
  little.max_pops = 2000;
  little.max_tree_nodes = 20'000;
  Decision decision = decide(candidate.query, little);
  // A tree stands in a file beside its case: without it, it proves nothing.
  if (decision.truth.clearance && std::holds_alternative<MissTree>(*decision.truth.clearance)) {
    decision.truth.clearance.reset();
    decision.truth.clear_until.reset();
    if (decision.truth.collides == false) decision.truth.proof = "rational-tdibm";
  }
  Case known = candidate;
  known.truth = std::move(decision.truth);
  if (const auto q = witnessed_query(known)) {
    known.origin.contact = name_of(contact_class_of(*q));
    known.origin.kind = name_of(CaseKind::kRP);
  }
  return known;
}

}  // namespace

void Triage::know(const Case& entry) {
  for (const auto& [method, outcome] : entry.expect) {
    if (!is_failure(outcome)) continue;
    Judged judged;
    judged.outcome = outcome;
    judged.error = error_name(entry, method);
    had_.insert(signature_of(method, entry, judged));
  }
}

Result<void> Triage::add(const Case& candidate,
                         const std::function<void(const TriageFind&)>& found) {
  ++tally_.inputs;
  const Case known = with_truth(candidate);
  bool fails = false;
  for (const std::string& method : options_.methods) {
    const std::optional<Failure> failure = confirm(method, known);
    if (!failure) continue;
    fails = true;
    ++tally_.failures;
    const auto is_new = [&](const Case& value) {
      return had_.insert(signature_of(method, value, failure->judged)).second;
    };
    if (!is_new(failure->asked)) {
      ++tally_.known;
      continue;
    }
    const Case small = shrink(failure->asked, method, methods_[method], failure->judged,
                              options_.search, {options_.shrink_trials, options_.stop})
                           .value;
    // What is not shrunk to the end is left to another time, which would find it anew.
    if (options_.stop()) continue;
    // Shrinking may make one loss into another, which was had.
    if (!(small.query == failure->asked.query) && !is_new(small)) {
      ++tally_.known;
      continue;
    }
    TriageFind find{method, failure->judged.outcome, loss_of(method, small), small};
    set_loss(find.value, method, find.loss);
    complete(find.value);
    if (const auto added = store_.add(find.value); !added) return tl::unexpected(added.error());
    found(find);
  }
  if (!fails) ++tally_.saved;
  return {};
}

std::optional<Triage::Failure> Triage::confirm(const std::string& method, const Case& known) {
  const auto asked_alike = [&](const Case& asked) -> std::optional<Failure> {
    Judged judged = ask(methods_[method], asked, options_.search);
    if (!is_failure(judged.outcome)) return std::nullopt;
    return Failure{asked, std::move(judged)};
  };
  if (!known.truth.witness) return asked_alike(with_t_max(known, known.query.t_max));
  for (const double factor : kHorizonFactors) {
    const std::optional<Case> asked = at_horizon(known, factor);
    if (!asked) continue;
    if (auto failure = asked_alike(*asked)) return failure;
  }
  return std::nullopt;
}

Triage::Signature Triage::signature_of(const std::string& method, const Case& value,
                                       const Judged& judged) {
  return {method, value.origin.contact, judged.outcome, judged.error, loss_of(method, value)};
}

std::string Triage::loss_of(const std::string& method, const Case& value) {
  const std::optional<Witness>& witness = value.truth.witness;
  if (!witness || witness->t > exact(value.query.t_max)) return "";
  Tracer* const tracer = tracers_.find(method);
  return tracer ? loss_signature(tracer->trace(value.query, *witness, {})) : "";
}

void Triage::complete(Case& value) {
  expect_of_others(value, options_.methods, methods_, options_.search,
                   [&](const std::string& method, const Judged& judged) {
                     if (!is_failure(judged.outcome)) return;
                     had_.insert(signature_of(method, value, judged));
                     set_loss(value, method, loss_of(method, value));
                   });
}

}  // namespace ccdfuzz
