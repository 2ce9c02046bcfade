#pragma once

#include <string>

#include "case/case.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

/// Where there is no cause, its outcome alone.
template <>
struct JsonForm<Expected> {
  struct Record {
    Outcome outcome = Outcome::kUnknown;
    std::string cause;

    static void fields(auto& archive, auto& record) {
      archive("outcome", record.outcome);
      archive("cause", record.cause);
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
