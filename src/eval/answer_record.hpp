#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"
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

  friend bool operator==(const AnswerRecord&, const AnswerRecord&) = default;
};

/// The names of the columns.
std::string answer_csv_header();
/// Without an end of line.
std::string to_csv(const AnswerRecord& record);
/// Errors: another number of fields, or one that is not what its column holds; naming `where`, the
/// column and the value.
Result<AnswerRecord> parse_answer_csv(std::string_view line, const std::string& where);

}  // namespace ccdfuzz
