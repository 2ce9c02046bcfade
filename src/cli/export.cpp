#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <variant>

#include "certify/linear/first_contact.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "files/check_file.hpp"
#include "files/engine_test.hpp"
#include "files/query_csv.hpp"
#include "files/test_snippet.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

struct AsQueryCsv {};
using Form = std::variant<AsQueryCsv, TestFramework, EngineTemplate>;

Result<Form> parse_form(const std::string& where, const std::string& text) {
  if (text == "csv") return AsQueryCsv();
  if (const auto framework = enum_named<TestFramework>(text)) return *framework;
  std::string names = "csv, " + enum_names<TestFramework>();
  for (const EngineTemplate& one : engine_templates()) {
    if (one.engine == text) return one;
    names.append(", ").append(one.engine);
  }
  return input_error(where, "\"{}\" is none of {}", text, names);
}

struct ExportOptions {
  std::vector<std::string> files;
  std::string output;
  Form as;
  bool round = false;
};

/// The tests of cases, and how many cases have none.
struct Exported {
  std::uint64_t tests = 0, left_out = 0;

  /// The test of a case; nothing where it has none, which is said.
  std::optional<std::string> take(Result<std::string> test, Session& session) {
    if (!test) session.remark("{}; it is left out", test.error().message());
    ++(test ? tests : left_out);
    return test ? std::optional(*std::move(test)) : std::nullopt;
  }
};

Exported export_tests(const ExportOptions& options, TestFramework framework, Session& session) {
  OutputFile out = need(OutputFile::create(options.output));
  Exported done;
  need(out.write(test_preamble(framework)));
  CaseStream cases(options.files);
  while (const auto named = need(session.next_case(cases))) {
    const auto test = done.take(test_snippet(*named, done.tests + 1, framework), session);
    if (test) need(out.write(*test));
  }
  if (done.tests > 0) need(out.commit());
  return done;
}

/// The rows of a case with their label: for linear queries decided from the very numbers written.
CsvQuery exported_rows(const NamedCase& named, bool round, std::uint64_t& rounded) {
  const Case& value = named.value;
  std::uint64_t own = 0;
  CsvQuery rows = need(to_csv_query(value.query, named.id, round, own));
  rounded += own;
  if (rows.layout != CsvLayout::kCurved) {
    rows.label = linear::first_contact(rows.patches(), 1).has_value();
    return rows;
  }
  if (own > 0) {
    throw BadInput{{named.id,
                    "end points are no doubles: what is known of this case would not "
                    "be known of rounded ones"}};
  }
  if (!value.truth.collides) {
    throw BadInput{{named.id, "has no truth to write into its rows; see prove"}};
  }
  rows.label = value.truth.collides;
  return rows;
}

/// How the rows of a query are laid out. Throws BadInput: a query CSV has no place for it.
CsvLayout layout_of(const NamedCase& named) {
  const Query& query = named.value.query;
  for (const auto& [has_it, what] :
       {std::pair(is_of_bodies(query), "bodies"), std::pair(query.separation > 0, "a separation"),
        std::pair(is_rational(query), "weights"), std::pair(is_trimmed(query), "a trim")}) {
    if (!has_it) continue;
    throw BadInput{{named.id, fmt::format("has {}, for which a query CSV has no place", what)}};
  }
  const auto layout = csv_layout_of(query);
  if (layout) return *layout;
  throw BadInput{{named.id,
                  "is neither edge-edge nor vertex-face of degree 1 nor two triangles of "
                  "degree 2"}};
}

std::string export_csv(const ExportOptions& options, Session& session) {
  OutputFile out = need(OutputFile::create(options.output));
  std::optional<CsvLayout> layout;
  std::uint64_t count = 0, rounded = 0;
  CaseStream cases(options.files);
  for (; const auto named = need(session.next_case(cases)); ++count) {
    const CsvLayout own = layout_of(*named);
    if (layout && *layout != own) {
      throw BadInput{{named->id, fmt::format("is {}, but the file holds {} so far", name_of(own),
                                             name_of(*layout))}};
    }
    layout = own;
    need(out.write(to_csv(exported_rows(*named, options.round, rounded))));
  }
  session.note_rounded();
  need(out.commit());
  const std::string& path = options.output;
  if (!is_stream(path) && csv_layout_of_path(path) != layout) {
    session.remark("{}: commands that read it need its layout in its name, as in {}.csv", path,
                   name_of(*layout));
  }
  std::string summary =
      fmt::format("{} {} {}", count, name_of(*layout), count == 1 ? "query" : "queries");
  if (rounded > 0) summary += fmt::format("; {} values rounded", rounded);
  return summary;
}

/// The test of a case in a folder: of a.json a.cpp, and of line 3 of a.jsonl a-3.cpp.
std::string test_path(const std::string& folder, const NamedCase& named, std::string_view ending) {
  const std::string name = std::filesystem::path(named.file).filename().string();
  std::string line = named.id.substr(named.file.size());
  if (!line.empty()) line.front() = '-';
  return fmt::format("{}{}{}{}", folder, name.substr(0, name.find(".json")), line, ending);
}

/// Nothing is written before all cases are read.
Exported export_engine_tests(const ExportOptions& options, const EngineTemplate& engine,
                             Session& session) {
  const bool is_folder = options.output.ends_with('/');
  std::map<std::string, std::string> tests;  // by path
  Exported done;
  CaseStream cases(options.files);
  while (const auto named = need(session.next_case(cases))) {
    const auto text = done.take(engine_test(*named, engine.engine), session);
    if (!text) continue;
    const std::string path =
        is_folder ? test_path(options.output, *named, engine.ending) : options.output;
    if (tests.emplace(path, *text).second) continue;
    throw BadInput{{named->id, is_folder ? path + " is the test of a case before it"
                                         : "a file has one test; -o FOLDER/ takes several"}};
  }
  if (is_folder && !tests.empty()) need(make_folder(options.output));
  for (const auto& [path, text] : tests) need(write_file(path, text));
  return done;
}

int run_export(const ExportOptions& options, Session& session) {
  if (case_file_kind_by_name(options.output)) {
    throw BadInput{
        {"--output",
         options.output +
             ": is a file of cases by its name; accepted is another, such as a .csv or .cpp"}};
  }
  if (options.round && !std::holds_alternative<AsQueryCsv>(options.as)) {
    throw BadInput{{"--round", "is for --as csv: tests hold the numbers of their case"}};
  }
  leave_stdout_to(options.output);
  const auto* engine = std::get_if<EngineTemplate>(&options.as);
  const auto* framework = std::get_if<TestFramework>(&options.as);
  if (engine == nullptr && framework == nullptr) {
    session.summary(export_csv(options, session));
    return kDone;
  }
  const auto [tests, left_out] = engine != nullptr ? export_engine_tests(options, *engine, session)
                                                   : export_tests(options, *framework, session);
  session.note_rounded();
  std::string summary = counted(tests, "test", "tests");
  if (left_out > 0) summary += "; left out: " + counted(left_out, "case", "cases");
  session.summary(summary);
  return left_out == 0 ? kDone : kBadInput;
}

}  // namespace

void add_export(CommandLine& line) {
  auto [command, options] = line.add<ExportOptions>(
      "export", "Write cases as a query CSV or as tests of a plug-in", run_export);
  command.example("counterexamples as GoogleTests",
                  "export finds/*.json --as gtest -o found_test.cpp");
  command.texts("case", options->files, "Case files: .json, .jsonl, .jsonl.zst or .csv").required();
  command.text("-o,--output FILE", options->output, "File to write").in("Results").required();
  std::vector<std::string_view> engines;
  for (const EngineTemplate& one : engine_templates()) engines.push_back(one.engine);
  command.parsed(
      "--as FORM", options->as,
      fmt::format(
          "csv: 8 rows per linear query, 24 per curved one. gtest, catch2: a C++ file with "
          "a test per case, which needs ccdfuzz_plugin.h and the plug-in to link with. {}: "
          "a test that needs this engine alone; of several cases, a file each with -o FOLDER/",
          fmt::join(engines, ", ")),
      parse_form, "csv");
  command.flag("--round", options->round,
               "Take the nearest double for end points that are none, and count them");
  command.max_work();
}

}  // namespace ccdfuzz
