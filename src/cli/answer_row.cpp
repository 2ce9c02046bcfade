#include "cli/answer_row.hpp"

namespace ccdfuzz {

AnswerRow::AnswerRow(std::string case_id, std::string method_spec, const Judged& judged)
    : id(std::move(case_id)),
      method(std::move(method_spec)),
      verdict(judged.answer.verdict),
      outcome(judged.outcome),
      pops(judged.answer.pops),
      seconds(judged.answer.seconds),
      error(judged.error),
      note(judged.answer.note) {
  if (judged.answer.has_toi()) toi = judged.answer.toi;
  if (verdict == Verdict::kHit) uv = judged.answer.uv;
}

}  // namespace ccdfuzz
