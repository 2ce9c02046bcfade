#pragma once

#include <optional>
#include <string>

#include "method/ask.hpp"

namespace ccdfuzz {

/// What a method says of a case and how that is judged, as a row of the JSON output.
struct AnswerRow {
  std::string id, method;
  Verdict verdict = Verdict::kUndecided;
  std::optional<double> toi;
  std::optional<std::array<Uv<double>, 2>> uv;  ///< of a hit
  Outcome outcome = Outcome::kUnknown;
  double late_by = 0;
  std::uint64_t pops = 0;
  double seconds = 0;
  std::string error, note;

  AnswerRow(std::string case_id, std::string method_spec, const Judged& judged);

  /// "late by 0.25".
  std::string outcome_text() const;

  static void fields(auto& archive, auto& row) {
    archive("case", row.id);
    archive("method", row.method);
    archive("verdict", row.verdict);
    archive("toi", row.toi);
    archive("uv", row.uv);
    archive("outcome", row.outcome);
    archive.optional("late_by", row.late_by);
    archive("pops", row.pops);
    archive("seconds", row.seconds);
    archive.optional("error", row.error);
    archive.optional("note", row.note);
  }
};

}  // namespace ccdfuzz
