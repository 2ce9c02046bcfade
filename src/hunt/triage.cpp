#include "hunt/triage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ccd/witness_trace/loss_signature.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "eval/horizons.hpp"
#include "files/case_json.hpp"
#include "generators/contact.hpp"
#include "io/serve.hpp"
#include "properties/against_oracle.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kOracle = "oracle";

struct Errand {
  std::string name, method;
  Case value;

  static void fields(auto& archive, auto& errand) {
    archive("errand", errand.name);
    archive("method", errand.method);
    archive("case", errand.value);
  }
};

Case decided_with_little_effort(const Case& candidate) {
  OracleOptions little;
  little.max_pops = kEnoughPops;
  little.max_tree_nodes = 10 * kEnoughPops;  // as decide_briefly
  Decision decision = decide(candidate.query, little);
  Case known = candidate;
  known.truth = std::move(decision.truth);
  if (const auto q = contact_of(known)) {
    known.origin.contact = name_of(contact_class_of(*q));
    known.origin.kind = name_of(CaseKind::kRP);
  }
  return known;
}

std::string refutation_by_sound_methods(const Case& known) {
  const std::optional<Witness>& witness = known.truth.witness;
  if (witness && witness->t <= exact(known.query.t_max)) {
    for (const std::string& method : miss_nothing()) {
      const auto made = value_or_throw(make_method(method));
      const Trace& trace = made->trace(known.query, *witness, {});
      if (!trace.lost) continue;
      return fmt::format("the witness trace of {} loses the contact (ccdfuzz trace shows it): {}",
                         method, loss_signature(trace));
    }
  }
  try {
    claim_all_agree(known.query, kRefutationPops, kRefutationSearch);
  } catch (const Refuted& why) {
    return why.what();
  }
  return "";
}

}  // namespace

struct Triage::Told {
  std::string text;
  std::optional<Case> decided;

  static void fields(auto& archive, auto& told) {
    archive.optional("text", told.text);
    archive.optional("decided", told.decided);
  }
};

std::string served_errand(const std::string& question) {
  const auto [name, method, value] = value_or_throw(from_json<Errand>(question, "the question"));
  if (name == "decide") return to_json(Triage::Told{"", decided_with_little_effort(value)});
  if (name == "refute") return to_json(Triage::Told{refutation_by_sound_methods(value), {}});
  return to_json(Triage::Told{cause_of_loss(method, value), {}});
}

Triage::Triage(Store& store, TriageOptions options)
    : options_(std::move(options)),
      asker_(make_asker()),
      intake_(
          store, [this] { return make_asker(); }, [this] { return make_asker(); }) {}

Asker Triage::make_asker() {
  return Asker(limited(options_.search), MethodSet(options_.make),
               [this](const std::string& method, const Case& value) {
                 return told("loss", value, method).value_or(Told()).text;
               });
}

Result<void> Triage::add(const Case& candidate, const Found& found) {
  ++tally_.inputs;
  const auto decided = with_truth(candidate);
  const Case& known = decided.value_or(candidate);
  std::vector<std::string> methods = options_.methods;
  if (!decided && std::ranges::find(methods, kOracle) == methods.end()) methods.push_back(kOracle);
  bool fails = false, sound_fails = false;
  for (const std::string& method : methods) {
    if (options_.stop()) return {};
    const std::optional<Find> confirmed = confirm(method, known);
    if (!confirmed && !decided && method == kOracle) {
      options_.warn(fmt::format("nobody knows the truth, since the oracle came to grief: {}: {}",
                                decided.error().name, decided.error().note));
    }
    if (!confirmed) continue;
    fails = true;
    sound_fails = sound_fails || method == kOracle ||
                  std::ranges::find(miss_nothing(), method) != miss_nothing().end();
    ++tally_.failures;
    CCDFUZZ_TRY(const bool is_known, intake_.has(confirmed->failure));
    if (is_known) {
      ++tally_.known;
      continue;
    }
    CCDFUZZ_TRY(const std::optional<Case> find, take_in(*confirmed));
    if (find) found(confirmed->failure, *find);
  }
  if (!fails) ++tally_.harmless;
  if (sound_fails) return {};
  const auto refutation = told("refute", known);
  if (refutation && refutation->text.empty()) return {};
  ++tally_.refuting;
  options_.warn(fmt::format("no full run of a sound method fails, but: {}",
                            refutation ? refutation->text : refutation.error().name));
  return {};
}

Result<std::optional<Case>> Triage::take_in(const Find& confirmed) {
  const Failure& failure = confirmed.failure;
  Case find =
      minimise(confirmed.value, failure, asker_, {options_.shrink_trials, options_.stop}).value;
  if (failure.who != kOracle) find = with_truth(find).value_or(find);
  // A find that is not shrunk to the end is left to a later run, which finds it anew. A hang is
  // kept, as it would take as long again.
  if (options_.stop() && failure.cause != "hang") return std::nullopt;
  asker_.ask_others(find, options_.methods);
  const Judged judged = asker_.ask_how_deep(failure, checked_or_unknown(find));
  intake_.offer(failure, find, judged);
  return intake_.store_all().map([&] { return std::optional(std::move(find)); });
}

tl::expected<Triage::Told, Fault> Triage::told(const char* errand, const Case& value,
                                               const std::string& method) {
  if (!errands_) {
    errands_.emplace(value_or_throw(served_child(options_.errands, kServedLimits)));
  }
  return ask_served<Told>(*errands_, to_json(Errand{errand, method, value}));
}

tl::expected<Case, Fault> Triage::with_truth(const Case& candidate) {
  if (candidate.truth.collides) return candidate;
  return told("decide", candidate).map([](const Told& told) { return told.decided.value(); });
}

std::optional<Find> Triage::confirm(const std::string& method, const Case& known) {
  const CheckedCase checked = checked_or_unknown(known);
  std::vector<CheckedCase> forms = forms_of(checked);
  const auto is_as_it_stands = [&](const CheckedCase& form) {
    return form.query().t_max == known.query.t_max;
  };
  // A fuzzer may have left any t_max.
  if (std::ranges::none_of(forms, is_as_it_stands)) forms.push_back(checked);
  std::optional<Find> best;
  for (const CheckedCase& asked : forms) {
    if (best && options_.stop()) break;
    auto failure = asker_.failure(method, asked.value(), asker_.ask(method, asked));
    if (!failure || (best && failure->setting >= best->failure.setting)) continue;
    best = Find{.failure = *std::move(failure), .value = asked.value()};
    if (best->failure.setting == Setting::kOrdinary) break;
  }
  return best;
}

}  // namespace ccdfuzz
