#include <fmt/format.h>

#include "certify/checker/check_case.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "eval/generation_cost.hpp"
#include "files/case_json.hpp"
#include "files/check_file.hpp"
#include "finds/content_address.hpp"
#include "finds/minimise.hpp"
#include "io/input_bytes.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

struct MinimizeOptions {
  std::string file;
  std::string method;
  std::string output;
  std::uint64_t max_trials = 10'000;
  SearchFlags search;
};

std::string size_text(const Query& query) {
  return fmt::format("{} and {}, {} significant bits", to_text(query.patches[0].shape),
                     to_text(query.patches[1].shape), size_of(query).significant_bits);
}

/// Asks the method, in a process of its own if it is expected to crash on the case.
Asker asker_for(const NamedCase& found, const MinimizeOptions& options) {
  const std::string& spec = options.method;
  const auto expected = found.value.expect.find(spec);
  const bool may_crash =
      expected != found.value.expect.end() && expected->second.outcome == Outcome::kError;
  need_at("--method", admit_plugin(spec).and_then([&] { return make_method(spec); }));
  const SearchOptions search = options.search.options_for(found.value);
  return may_crash ? Asker(limited(search), MethodSet(make_served_method)) : Asker(search);
}

int run_minimize(const MinimizeOptions& options, Session& session) {
  if (options.output == "-") throw BadInput{{"--output", "- is no file; the default is stdout"}};
  if (!options.output.empty() && !is_stream(options.output) &&
      case_file_kind_by_name(options.output) != CaseFileKind::kJson) {
    throw BadInput{{"--output", options.output + ": does not end in .json, as one case does"}};
  }
  const NamedCase found = need(read_case(options.file));
  Asker asker = asker_for(found, options);
  const CheckedCase known = need(check_case(found));
  const Judged judged = asker.ask(options.method, known);
  const Expected shown = asker.expected(options.method, found.value, judged);
  if (!is_failure(judged.outcome)) {
    const bool differs = asker.differs(options.method, known, shown, asker.search());
    throw BadInput{{found.id, fmt::format("the answer of {} is {}: no failure to shrink{}",
                                          options.method, name_of(judged.outcome),
                                          differs ? fmt::format("; {}", kAnswersDiffer) : "")}};
  }
  const Failure failure = failure_of(found.value, options.method, shown);
  const std::atomic<bool>& interrupted = catch_interrupts();
  Minimised minimised = minimise(found.value, failure, asker,
                                 {options.max_trials, [&] { return interrupted.load(); }});
  const CheckedCase left = checked_or_unknown(minimised.value);
  const Judged shrunk = interrupted ? Judged() : asker.ask_how_deep(failure, left);
  say_version(minimised.value, options.method, shrunk);
  if (!interrupted && asker.differs(options.method, left, shown, asker.search())) {
    session.remark("{}: {}", options.method, kAnswersDiffer);
  }
  const std::string text = to_json(minimised.value, JsonLayout::kReadable) + "\n";
  if (!options.output.empty()) {
    need(
        write_file(options.output, text).and_then([&] { return write_costs(options.output, {}); }));
  } else if (!session.json) {
    print_out(text);
  }
  if (session.json) {
    print_row([&](auto& row) {
      row("case", found.id);
      Failure::fields(row, failure);
      row("trials", minimised.trials);
      row("bits_before", size_of(found.value.query).significant_bits);
      row("bits", size_of(minimised.value.query).significant_bits);
      row("minimised", minimised.value);
    });
  } else {
    print_err(fmt::format("{}: from {} to {} in {} trials\n", to_text(failure),
                          size_text(found.value.query), size_text(minimised.value.query),
                          minimised.trials));
  }
  return session.exit_code(kDone);
}

}  // namespace

void add_minimize(CommandLine& line) {
  auto [command, options] = line.add<MinimizeOptions>(
      "minimize", "Make a counterexample as small as possible", run_minimize);
  command.example("a find of one method", "minimize finds/FIND.json --method tdibm -o small.json");
  command.text("case", options->file, "File with one case").required();
  command.plugin_names();
  command.text("--method METHOD", options->method, "The method that fails on it, as it does after")
      .in("Methods")
      .required();
  command.text("-o,--output FILE", options->output, "File to write, .json; by default stdout")
      .in("Results");
  command.json("What was reached, as a JSON object on stdout");
  command.group("Limits");
  command.whole("--max-trials", options->max_trials, "How often to run the method", 1);
  options->search.add_to(command);
}

}  // namespace ccdfuzz
