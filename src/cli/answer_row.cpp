#include "cli/answer_row.hpp"

namespace ccdfuzz {

nlohmann::ordered_json answer_row(const std::string& case_id, const std::string& method,
                                  const Judged& judged) {
  const Answer& answer = judged.answer;
  nlohmann::ordered_json row = {{"case", case_id},
                                {"method", method},
                                {"verdict", name_of(answer.verdict)},
                                {"toi", nullptr},
                                {"uv", nullptr},
                                {"outcome", name_of(judged.outcome)},
                                {"pops", answer.pops},
                                {"seconds", answer.seconds}};
  if (answer.has_toi()) row["toi"] = *answer.toi;
  if (answer.verdict == Verdict::kHit) row["uv"] = answer.uv;
  if (!judged.error.empty()) row["error"] = judged.error;
  if (!answer.note.empty()) row["note"] = answer.note;
  return row;
}

}  // namespace ccdfuzz
