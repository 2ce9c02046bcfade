#pragma once

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>

#include "case/case.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

/// The causes of failures: what lost a contact (loss_signature.hpp), and kinds of bodies.
inline constexpr std::array<std::string_view, 9> kCauses = {
    "hull", "left root",      "right root", "both roots", "whole window",
    "mesh", "one-sided mesh", "spin",       "turn"};

/// What is wrong with such a cause beside the outcome; empty if nothing is. An error has a cause of
/// any name.
inline std::string fault_of_cause(Outcome outcome, const std::string& cause) {
  if (cause.empty() || outcome == Outcome::kError) return "";
  if (!is_failure(outcome)) return "stands beside an outcome that has no cause";
  if (std::ranges::find(kCauses, cause) != kCauses.end()) return "";
  return fmt::format("is none of: {}", fmt::join(kCauses, ", "));
}

/// Where there is no cause, its outcome alone.
template <>
struct JsonForm<Expected> {
  struct Record {
    Outcome outcome = Outcome::kUnknown;
    std::string cause;

    static void fields(auto& archive, auto& record) {
      archive("outcome", record.outcome);
      archive("cause", record.cause,
              [&](const std::string& cause) { return fault_of_cause(record.outcome, cause); });
    }
  };

  static void write(std::string& json, const Expected& expected) {
    if (expected.cause.empty()) return write_json(json, expected.outcome);
    write_json(json, Record{expected.outcome, expected.cause});
  }
  static void read(const JsonCursor& from, Expected& expected) {
    if (from.value().kind == JsonKind::kObject) {
      const auto record = read_json<Record>(from);
      expected = {record.outcome, record.cause};
    } else {
      expected = read_json<Outcome>(from);
    }
  }
};

}  // namespace ccdfuzz
