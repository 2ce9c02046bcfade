#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case/answer.hpp"
#include "case/outcome.hpp"

namespace ccdfuzz {

/// One answer of an evaluation: a line of answers.csv, from which all tables are made. Reals are
/// written in the shortest form that reads back as the same double.
struct AnswerRecord {
  std::uint64_t index = 0;  ///< of the case in the data set, from 0
  std::string id;           ///< of the case: file and line
  std::string contact;      ///< "-" if the case does not say
  std::string kind;
  std::optional<bool> collides;  ///< the truth
  std::optional<double> factor;  ///< of the contact's time; absent where asked as it stands
  std::string method;
  double t_max = 0;
  Verdict verdict = Verdict::kUndecided;
  std::optional<double> toi;  ///< absent after a miss
  Outcome outcome = Outcome::kUnknown;
  std::uint64_t pops = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;

  static void fields(auto& archive, auto& record) {
    archive("index", record.index);
    archive("case", record.id);
    archive("class", record.contact);
    archive("kind", record.kind);
    archive("collides", record.collides);
    archive("t_max_factor", record.factor);
    archive("method", record.method);
    archive("t_max", record.t_max);
    archive("verdict", record.verdict);
    archive("toi", record.toi);
    archive("outcome", record.outcome);
    archive("pops", record.pops);
    archive("bytes", record.bytes);
    archive("seconds", record.seconds);
  }

  friend bool operator==(const AnswerRecord&, const AnswerRecord&) = default;
};

}  // namespace ccdfuzz
