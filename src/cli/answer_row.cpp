#include "cli/answer_row.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

AnswerRow::AnswerRow(std::string case_id, std::string method_spec, const Judged& judged)
    : id(std::move(case_id)),
      method(std::move(method_spec)),
      verdict(judged.answer.verdict),
      outcome(judged.outcome),
      late_by(judged.late_by),
      pops(judged.answer.pops),
      seconds(judged.answer.seconds),
      error(judged.error),
      note(judged.answer.note) {
  if (judged.answer.has_toi()) toi = judged.answer.toi;
  if (verdict == Verdict::kHit) uv = judged.answer.uv;
}

std::string AnswerRow::outcome_text() const {
  return outcome == Outcome::kLate ? fmt::format("late by {:.3g}", late_by)
                                   : std::string(name_of(outcome));
}

}  // namespace ccdfuzz
