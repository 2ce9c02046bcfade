#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/command.hpp"
#include "cli/output.hpp"

namespace ccdfuzz {

std::string& program_name() {
  static std::string name = "ccdfuzz";
  return name;
}

namespace {

int complain(const std::string& message, int code) {
  fmt::print(stderr, "ccdfuzz: {}\n", message);
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Fuzzing and property testing for continuous collision detection", "ccdfuzz");
  app.set_version_flag("--version", CCDFUZZ_VERSION);
  app.require_subcommand(0, 1);  // 1, 1 would answer a misspelt command with "required" alone
  app.footer(
      "`ccdfuzz COMMAND --help` documents a command.\n"
      "Exit codes: 0 done, 1 a check failed, 2 bad usage or input, 3 internal error.");
  program_name() = argv[0];
  Chosen chosen;
  add_hunt(app, chosen);
  add_query(app, chosen);
  add_generate(app, chosen);
  add_evaluate(app, chosen);
  add_verify(app, chosen);
  add_replay(app, chosen);
  add_methods(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    app.exit(error);
    return asked_for_help ? kDone : kBadInput;
  }
  if (!chosen) {
    fmt::print(stderr, "{}", app.help());
    return complain("no command given", kBadInput);
  }
  const Result<int> result = chosen();
  // What was printed before an error must be out before the complaint, and an unwritable stdout is
  // an error of its own unless there is one already.
  const Result<void> flushed = flush_stdout();
  if (!result) return complain(result.error().message(), kBadInput);
  if (!flushed) return complain(flushed.error().message(), kBadInput);
  return *result;
}

}  // namespace

}  // namespace ccdfuzz

int main(int argc, char** argv) {
  try {
    return ccdfuzz::run(argc, argv);
  } catch (const std::exception& error) {
    return ccdfuzz::complain(fmt::format("internal error: {}", error.what()), ccdfuzz::kInternal);
  }
}
