#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/answer.hpp"
#include "case/outcome.hpp"

namespace ccdfuzz {

/// A method's answer to a case, up to one time.
struct GivenAnswer {
  std::optional<double> factor;  ///< t_max by the contact's time; absent where asked unchanged
  std::string method;
  double t_max = 0;
  Verdict verdict = Verdict::kUndecided;
  std::optional<double> toi;  ///< absent after a miss
  Outcome outcome = Outcome::kUnknown;
  std::uint64_t pops = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;

  static void fields(auto& archive, auto& answer) {
    archive("t_max_factor", answer.factor);
    archive("method", answer.method);
    archive("t_max", answer.t_max);
    archive("verdict", answer.verdict);
    archive("toi", answer.toi);
    archive("outcome", answer.outcome);
    archive("pops", answer.pops);
    archive("bytes", answer.bytes);
    archive("seconds", answer.seconds);
  }

  friend bool operator==(const GivenAnswer&, const GivenAnswer&) = default;
};

/// A case of an evaluation with all answers to it: a line of answers.jsonl, of which all tables are
/// made.
struct EvaluatedCase {
  std::uint64_t index = 0;  ///< the case's in the data set, from 0
  std::string id;           ///< file and line
  std::string contact;      ///< "-" if the case does not say
  std::string kind;
  std::optional<bool> collides;  ///< the truth
  std::vector<GivenAnswer> answers;

  static void fields(auto& archive, auto& evaluated) {
    archive("index", evaluated.index);
    archive("case", evaluated.id);
    archive("class", evaluated.contact);
    archive("kind", evaluated.kind);
    archive("collides", evaluated.collides);
    archive("answers", evaluated.answers);
  }

  friend bool operator==(const EvaluatedCase&, const EvaluatedCase&) = default;
};

}  // namespace ccdfuzz
