#include "properties/outside_data.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>

#include "case/query_csv.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {

namespace {

std::string as_hex(const std::string& text) {
  return to_hex_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// A file without a name, for readers that take a path.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& content) : descriptor_(::memfd_create("text", 0)) {
    CCDFUZZ_VERIFY(descriptor_ >= 0);
    CCDFUZZ_VERIFY(::write(descriptor_, content.data(), content.size()) ==
                   static_cast<ssize_t>(content.size()));
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

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
Check check_csv(Draw& choices) {
  constexpr std::size_t kLongest = 1 << 14;
  const CsvLayout layout = choices.pick(kAllCsvLayouts);
  const std::string text = choices.coin() ? draw_rows(choices, layout) : choices.text(kLongest);
  const MemoryFile file(text);
  Result<CsvReader> reader = CsvReader::open(file.path(), layout, "");
  if (!reader) return Check::fails("it cannot be opened: " + reader.error().message());
  for (;;) {
    const Result<std::optional<CsvQuery>> read = reader->next();
    if (!read) {
      const bool says_where = read.error().where.find(file.path()) != std::string::npos;
      if (says_where && !read.error().what.empty()) return Check::holds();
      return Check::fails("an error without place or reason, on the text " + as_hex(text));
    }
    if (!*read) return Check::holds();
    if (!is_written_alike(**read)) {
      return Check::fails(fmt::format("the query of line {} is written otherwise, of the text {}",
                                      (*read)->lines.front(), as_hex(text)));
    }
  }
}

/// A line that is almost what a plug-in should answer.
std::string draw_line(Draw& choices) {
  constexpr std::array<std::string_view, 22> kWords = {
      "\"id\":7",
      "\"verdict\":\"hit\"",
      "\"verdict\":\"miss\"",
      "\"toi\":0.5",
      "\"toi\":[0.25,0.5]",
      "\"toi\":NaN",
      "\"toi\":-1",
      "\"toi\":\"inf\"",
      "\"uv\":[[0,1],[0.5,null]]",
      "\"uv\":[[NaN]]",
      "\"tolerance\":1e-6",
      "\"tolerance\":\"inf\"",
      "\"iterations\":1e300",
      "\"seconds\":-1",
      "\"protocol\":1",
      "\"name\":\"x\"",
      "\"refused\":1",
      "\"fault\":\"hang\"",
      "\"minimum_separation\":-0",
      "\"accepts\":[[{\"shape\":\"curve\",\"max_degree\":99},{\"shape\":\"point\"}]]",
      "\"accepts\":[[{\"shape\":\"triangle\",\"max_degree\":2},{\"shape\":\"tensor\"}]]",
      "\"message\":\"\\\"NaN"};
  std::string line = choices.coin() ? "{\"id\":7" : "{\"protocol\":1";
  for (std::uint64_t left = choices.choose(6); left > 0; --left) {
    line += ',';
    line += choices.pick(kWords);
  }
  return line + "}";
}

/// Any line as the answer of a plug-in: a fault with a name, or a sensible answer.
Check check_plugin_line(Draw& choices) {
  constexpr std::size_t kLongest = 1 << 12;
  constexpr std::uint64_t kQuestion = 7;
  const double t_max = std::abs(choices.finite_double());
  const std::string line = choices.coin() ? draw_line(choices) : choices.text(kLongest);
  const auto failure = [&](const char* what) {
    return Check::fails(
        fmt::format("{}, t_max = {}, of the line {}", what, to_hex(t_max), as_hex(line)));
  };
  for (const auto& [word, meant] :
       {std::pair("miss", Verdict::kMiss), std::pair("inconclusive", Verdict::kUndecided),
        std::pair("refused", Verdict::kRefused)}) {
    const auto said =
        read_answer(fmt::format(R"({{"id":7,"verdict":"{}"}})", word), kQuestion, t_max);
    if (!said || said->answer.verdict != meant) return failure(word);
  }
  const Described described = read_description(line);
  if (described) {
    for (const double claimed : {described->tolerance, described->minimum_separation}) {
      if (!(claimed >= 0 && std::isfinite(claimed))) return failure("a tolerance that is none");
    }
    for (const PluginDescription::Pair& pair : described->accepts) {
      for (const int degree : pair.max_degrees) {
        if (degree < 0 || degree > kMaxDegree) return failure("a degree that there is not");
      }
    }
  }
  const auto read = read_answer(line, kQuestion, t_max);
  if (!read) return read.error().name.empty() ? failure("a fault without a name") : Check::holds();
  const Answer& answer = read->answer;
  if (answer.verdict != Verdict::kHit) return Check::holds();
  if (!answer.toi || !(*answer.toi >= 0 && *answer.toi <= t_max)) return failure("a wrong toi");
  for (const Uv<double>& uv : answer.uv) {
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) return failure("a wrong parameter");
  }
  return read->agrees_with(*read) ? Check::holds() : failure("it does not agree with itself");
}

}  // namespace

std::vector<Property> outside_data_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"csv.any_bytes", "Any text is refused with a reason, or read as queries that it then writes",
       "src/case/query_csv.hpp", kHolds, check_csv},
      {"plugin.any_line", "Any line of a plug-in is a fault with a name, or a sensible answer",
       "src/method/plugin/line_protocol.hpp", kHolds, check_plugin_line},
  };
}

}  // namespace ccdfuzz
