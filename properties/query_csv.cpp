#include "files/query_csv.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include "io/descriptor.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// What was read exactly and is doubles is written as rows that say the same.
bool is_written_alike(const CsvQuery& read) {
  std::uint64_t rounded = 0;
  const Result<Query> query = to_query(read, true, rounded);
  if (!query || rounded > 0) return true;
  const Result<CsvQuery> again = to_csv_query(*query, "query", true, rounded);
  return again && (rounded > 0 || (again->start == read.start && again->end == read.end));
}

/// Queries in the layout, one byte of which may be another.
std::string draw_rows(Draw& choices, CsvLayout layout) {
  std::string text;
  // Thirds are rounded: what is written alike is all the rest.
  const std::uint64_t last = choices.coin() ? 2 : 3;
  for (std::uint64_t queries = choices.choose(2); queries > 0; --queries) {
    const std::string_view label = choices.pick(std::array<std::string_view, 3>{"", ",0", ",1"});
    int points = 0;
    for (const Shape& shape : csv_shapes(layout)) points += 2 * shape.control_count();
    for (; points > 0; --points) {
      for (int k = 0; k < 3; ++k) {
        const std::int64_t numerator = choices.integer(-9, 9);
        constexpr std::array kDenominators = {1, 2, 4, 3};
        const int denominator = kDenominators[choices.choose(last)];
        text += fmt::format("{}{},{}", k == 0 ? "" : ",", numerator, denominator);
      }
      text += label;
      text += '\n';
    }
  }
  if (!text.empty() && choices.coin()) {
    const std::uint64_t at = choices.choose(text.size() - 1);
    text[at] = choices.pick(std::array{' ', ',', '0', '-', '#', '\n', '.', '\0'});
  }
  return text;
}

/// Any bytes as a query CSV, and what almost is one.
void check_csv(Draw& d) {
  constexpr std::size_t kLongest = 1 << 14;
  const CsvLayout layout = d.pick(kAllCsvLayouts);
  const std::string text = d.coin() ? draw_rows(d, layout) : d.text(kLongest);
  show(d, "text", AsHex{text});
  const Descriptor file(::memfd_create("text", MFD_CLOEXEC));
  CCDFUZZ_VERIFY(*file >= 0 && write_all(*file, text) == 0);
  const std::string path = fmt::format("/proc/self/fd/{}", *file);
  CsvReader reader = CsvReader::open(path, {.layout = layout}).value();
  for (;;) {
    const Result<std::optional<CsvQuery>> read = reader.next();
    if (!read) {
      CLAIM(read.error().where.find(path) != std::string::npos);
      CLAIM(!read.error().what.empty());
      return;
    }
    if (!*read) return;
    show(d, "line", (*read)->lines.front());
    CLAIM(is_written_alike(**read));
  }
}

}  // namespace

std::vector<Property> query_csv_claims() {
  return {
      {"csv.any_bytes", "Any text is refused with a reason, or read as queries that it then writes",
       "src/files/query_csv.hpp", check_csv},
  };
}

}  // namespace ccdfuzz
