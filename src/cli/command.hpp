#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// What every command ends with. A command that was interrupted ends with 128 + the signal.
enum ExitCode : int {
  kDone = 0,
  kCheckFailed = 1,  ///< a replay regression, a refuted truth, a find that --fail-on names
  kBadInput = 2,     ///< bad usage or input, or no place to write to
  kInternal = 3,
};

/// How the user called this program, so that the commands we print work when pasted.
std::string& program_name();

/// The command the user chose: run it for its exit code. Errors: input errors, exit code 2.
using Chosen = std::function<Result<int>()>;

/// Adds a command whose options live as long as the program and which runs as run(options).
/// Returns the subcommand and its options, for the caller to bind.
template <class Options>
std::pair<CLI::App*, Options*> add_command(CLI::App& app, Chosen& chosen, const std::string& name,
                                           const std::string& description,
                                           Result<int> (*run)(const Options&)) {
  CLI::App* const command = app.add_subcommand(name, description);
  const auto options = std::make_shared<Options>();
  command->callback([options, run, &chosen] { chosen = [options, run] { return run(*options); }; });
  return {command, options.get()};
}

void add_evaluate(CLI::App& app, Chosen& chosen);
void add_generate(CLI::App& app, Chosen& chosen);
void add_hunt(CLI::App& app, Chosen& chosen);
void add_methods(CLI::App& app, Chosen& chosen);
void add_query(CLI::App& app, Chosen& chosen);
void add_replay(CLI::App& app, Chosen& chosen);
void add_verify(CLI::App& app, Chosen& chosen);

}  // namespace ccdfuzz
