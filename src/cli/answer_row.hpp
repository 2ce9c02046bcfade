#pragma once

#include <optional>
#include <string>

#include "method/ask.hpp"

namespace ccdfuzz {

/// A method's answer to a case and its judgement, as a row of the JSON output.
struct AnswerRow {
  const std::string& id;
  const std::string& method;
  const Judged& judged;

  static void fields(auto& archive, auto& row) {
    const Answer& answer = row.judged.answer;
    const bool is_hit = answer.verdict == Verdict::kHit;
    archive("case", row.id);
    archive("method", row.method);
    archive("verdict", answer.verdict);
    archive("toi", answer.has_toi() ? answer.toi : std::nullopt);
    archive("uv", is_hit && answer.has_uv ? std::optional(answer.uv) : std::nullopt);
    archive("outcome", row.judged.outcome);
    archive.optional("late_by", row.judged.late_by);
    archive.optional("depth", row.judged.depth);
    if (is_false_negative(row.judged.outcome)) {
      archive.optional("depth_tolerance", row.judged.depth_tolerance);
      archive.optional("time_tolerance", row.judged.time_tolerance);
    }
    archive("pops", answer.pops);
    archive("seconds", answer.seconds);
    archive.optional("error", row.judged.error);
    archive.optional("note", answer.note);
  }
};

}  // namespace ccdfuzz
