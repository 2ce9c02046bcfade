#include <fmt/format.h>

#include "base/output_file.hpp"
#include "case/case_json.hpp"
#include "case/tree_file.hpp"
#include "certify/checker/check_case.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "corpus/content_address.hpp"
#include "corpus/failure.hpp"
#include "hunt/shrink.hpp"
#include "method/method_apart.hpp"

namespace ccdfuzz {

namespace {

struct MinimizeArguments {
  std::string file;
  std::string method;
  std::string output;
  std::uint64_t max_trials = 10'000;
  SearchFlags search;
  bool json = false;
};

std::string size_text(const Query& query) {
  return fmt::format("{} and {}, {} significant bits", to_text(query.patches[0].shape),
                     to_text(query.patches[1].shape), size_of(query).significant_bits);
}

Result<int> run_minimize(const MinimizeArguments& options) {
  const Result<NamedCase> only = read_case(options.file);
  if (!only) return tl::unexpected(only.error());
  const NamedCase& found = *only;
  const Result<SearchOptions> search = options.search.parse_for(found);
  if (!search) return tl::unexpected(search.error());
  const auto expected = found.value.expect.find(options.method);
  const bool may_crash =
      expected != found.value.expect.end() && expected->second == Outcome::kError;
  const auto make = may_crash ? make_method_apart : make_method;
  auto method = admit_plugin(options.method).and_then([&] { return make(options.method); });
  if (!method) return input_error("--method", method.error().what);
  const Result<CheckedCase> known = check_case(found);
  if (!known) return tl::unexpected(known.error());
  const Judged failure = ask(**method, *known, *search);
  if (!is_failure(failure.outcome)) {
    return input_error(found.id, fmt::format("the answer of {} is {}: no failure to shrink",
                                             options.method, name_of(failure.outcome)));
  }

  const std::atomic<bool>& interrupted = catch_interrupts();
  Minimised minimised = shrink(found.value, options.method, **method, failure, *search,
                               {options.max_trials, [&] { return interrupted.load(); }});
  // Only a case that stays as it is keeps a tree.
  const bool had_tree = minimised.value.truth.clearance &&
                        std::holds_alternative<MissTree>(*minimised.value.truth.clearance);
  if (const auto carried =
          carry_tree(minimised.value.truth, options.output.empty() ? "" : trees_path(options.file),
                     options.output);
      !carried) {
    return tl::unexpected(carried.error());
  }
  if (had_tree && options.output.empty()) {
    print_err(
        "ccdfuzz: minimize: without its tree of separating axes, which stdout cannot hold, the "
        "case "
        "proves no absence of contact: use --output\n");
  }
  const std::string text = to_json(minimised.value, JsonLayout::kReadable) + "\n";
  if (options.output.empty()) {
    if (!options.json) print_out(text);
  } else if (const auto written = write_file(options.output, text); !written) {
    return tl::unexpected(written.error());
  }
  const auto bits = [](const Case& value) { return size_of(value.query).significant_bits; };
  if (options.json) {
    print_json({{"case", found.id},
                {"method", options.method},
                {"outcome", name_of(failure.outcome)},
                {"trials", minimised.trials},
                {"bits_before", bits(found.value)},
                {"bits", bits(minimised.value)},
                {"minimised", nlohmann::ordered_json::parse(to_json(minimised.value))}});
  } else {
    print_err(fmt::format("{} by {}: from {} to {} in {} trials\n", name_of(failure.outcome),
                          options.method, size_text(found.value.query),
                          size_text(minimised.value.query), minimised.trials));
  }
  return interrupted ? interrupted_exit_code() : kDone;
}

}  // namespace

void add_minimize(CommandLine& line) {
  auto [command, options] = line.add<MinimizeArguments>(
      "minimize", "Shrink a counterexample exactly: the method still fails alike", run_minimize);
  command.text("case", options->file, "File with one case").required();
  command.text("--method", options->method, "The method that fails on it").required();
  command.text("-o,--output", options->output,
               "File to write, .json, and beside it the tree of the case if it has one; default "
               "stdout");
  command.whole("--max-trials", options->max_trials, "How often to ask the method", 1);
  options->search.add_to(command);
  command.flag("--json", options->json, "What was reached, as a JSON object on stdout");
}

}  // namespace ccdfuzz
