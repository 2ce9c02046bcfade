#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ccdfuzz {

/// One option or argument of a command, for help, manual page and completion.
struct HelpOption {
  std::string names;  ///< "-o, --output", or the name of an argument
  std::string value;  ///< "FILE"; empty for a flag
  std::string text;
};

/// A command. The program itself is one without options; its commands are a group.
struct HelpCommand {
  std::string name;     ///< "hunt"
  std::string summary;  ///< one line
  std::string usage;    ///< behind the name: "[OPTIONS] case..."
  std::vector<std::pair<std::string, std::vector<HelpOption>>> groups;  ///< title and options
  std::string end;  ///< an example, or exit codes; its lines are kept
};

/// Help in lines of at most kTextWidth columns, unless a word is longer.
std::string help_text(const std::string& program, const HelpCommand& command);

/// The manual page of a program in section 1, in the man macros of roff. The first of the commands
/// is the program itself.
std::string manual_page(const std::string& program, const std::string& version,
                        const std::vector<HelpCommand>& commands);

/// The script by which bash completes the names of commands and options, and otherwise files. The
/// first of the commands is the program itself.
std::string bash_completion(const std::string& program, const std::vector<HelpCommand>& commands);

}  // namespace ccdfuzz
