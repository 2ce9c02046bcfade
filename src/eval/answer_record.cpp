#include "eval/answer_record.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <vector>

#include "base/table.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array<std::string_view, 14> kAnswerColumns = {
    "index", "case",    "class", "kind",    "collides", "t_max_factor", "method",
    "t_max", "verdict", "toi",   "outcome", "pops",     "bytes",        "seconds"};

/// The fields of a line of CSV (RFC 4180); fields hold no line breaks.
std::vector<std::string> csv_fields(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      // A quote within quotes is written twice.
      if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
        fields.back() += '"';
        ++i;
      } else {
        quoted = !quoted;
      }
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

template <class Number>
std::optional<Number> number_in(const std::string& field) {
  Number x{};
  const auto [end, status] = std::from_chars(field.data(), field.data() + field.size(), x);
  if (status != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return x;
}

/// The value of an enumeration whose name the field is.
template <class Enum, size_t N>
std::optional<Enum> named_in(const std::string& field, const std::array<Enum, N>& all) {
  for (const Enum e : all) {
    if (name_of(e) == field) return e;
  }
  return std::nullopt;
}

std::string optional_text(const std::optional<double>& x) {
  return x ? fmt::format("{}", *x) : "";
}

}  // namespace

std::string answer_csv_header() {
  return fmt::format("{}", fmt::join(kAnswerColumns, ","));
}

std::string to_csv(const AnswerRecord& r) {
  const char* const collides = !r.collides ? "" : *r.collides ? "true" : "false";
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", r.index, csv_field(r.id),
                     csv_field(r.contact), csv_field(r.kind), collides, optional_text(r.factor),
                     csv_field(r.method), r.t_max, name_of(r.verdict), optional_text(r.toi),
                     name_of(r.outcome), r.pops, r.bytes, r.seconds);
}

Result<AnswerRecord> parse_answer_csv(std::string_view line, const std::string& where) {
  const std::vector<std::string> fields = csv_fields(line);
  if (fields.size() != kAnswerColumns.size()) {
    return input_error(where,
                       fmt::format("has {} fields, not {}", fields.size(), kAnswerColumns.size()));
  }
  AnswerRecord r;
  size_t bad = fields.size();
  const auto take = [&](size_t column, const auto& value, auto& into) {
    value ? static_cast<void>(into = *value) : static_cast<void>(bad = std::min(bad, column));
  };
  const auto take_optional = [&](size_t column, std::optional<double>& into) {
    if (!fields[column].empty()) take(column, number_in<double>(fields[column]), into);
  };
  take(0, number_in<std::uint64_t>(fields[0]), r.index);
  r.id = fields[1];
  r.contact = fields[2];
  r.kind = fields[3];
  if (fields[4] == "true" || fields[4] == "false") {
    r.collides = fields[4] == "true";
  } else if (!fields[4].empty()) {
    bad = std::min<size_t>(bad, 4);
  }
  take_optional(5, r.factor);
  r.method = fields[6];
  take(7, number_in<double>(fields[7]), r.t_max);
  take(8, named_in(fields[8], kVerdicts), r.verdict);
  take_optional(9, r.toi);
  take(10, named_in(fields[10], kAllOutcomes), r.outcome);
  take(11, number_in<std::uint64_t>(fields[11]), r.pops);
  take(12, number_in<std::uint64_t>(fields[12]), r.bytes);
  take(13, number_in<double>(fields[13]), r.seconds);
  if (bad < fields.size()) {
    return input_error(where, fmt::format("{}: \"{}\" is not what this column holds",
                                          kAnswerColumns[bad], fields[bad]));
  }
  return r;
}

}  // namespace ccdfuzz
