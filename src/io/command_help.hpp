#pragma once

#include <exception>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace ccdfuzz {

inline constexpr const char* kProgram = "ccdfuzz";

/// The help of the program or of one of its commands: in groups, in lines of at most kTextWidth
/// columns, unless a word is longer.
std::string help_of(const CLI::App& app);

/// The manual page of the program in section 1, in the man macros of roff.
std::string manual_page(const CLI::App& app, const std::string& version);

/// The script by which bash completes the names of commands and options, and otherwise files.
std::string bash_completion(const CLI::App& app);

/// The command that was given; the program itself if none was.
const CLI::App& chosen_command(const CLI::App& app);

/// The error of a name that is no command's.
std::string no_such_command(const CLI::App& app, const std::string& name);

/// The error of a command line, as "object: problem".
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

/// What ended a command: a fault of ours, or a want of what the system gives.
std::string ended_by(const std::exception& error);

}  // namespace ccdfuzz
