#include "io/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/text.hpp"

namespace ccdfuzz {

namespace {

/// Where texts of options begin.
constexpr std::size_t kTextColumn = 24;

std::string head_of(const HelpOption& option) {
  return option.value.empty() ? option.names : option.names + " " + option.value;
}

std::string option_text(const HelpOption& option) {
  std::string head = "  " + head_of(option);
  if (head.size() < kTextColumn) {
    head.resize(kTextColumn, ' ');
  } else {
    head += "\n" + std::string(kTextColumn, ' ');
  }
  return head + wrapped(option.text, kTextColumn, kTextColumn) + "\n";
}

/// Text for roff: a line that begins with a dot or a quote would be a request.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool begins = out.empty() || out.back() == '\n';
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string roff_command(const HelpCommand& command) {
  std::string out = fmt::format("{}\n.PP\n.B {} {}\n", roff(command.summary), roff(command.name),
                                roff(command.usage));
  for (const auto& [title, options] : command.groups) {
    out += fmt::format(".PP\n{}:\n", roff(title));
    for (const HelpOption& option : options) {
      out += fmt::format(".TP\n.B {}\n{}\n", roff(head_of(option)), roff(option.text));
    }
  }
  if (!command.end.empty()) out += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(command.end));
  return out;
}

/// "--seconds --cases": the options of a command by their long names.
std::string long_names(const HelpCommand& command) {
  std::string names;
  for (const auto& [title, options] : command.groups) {
    for (const HelpOption& option : options) {
      const std::size_t at = option.names.find("--");
      if (at == std::string::npos) continue;
      names += (names.empty() ? "" : " ") + option.names.substr(at);
    }
  }
  return names;
}

}  // namespace

std::string help_text(const std::string& program, const HelpCommand& command) {
  const std::string name = command.name.empty() ? program : program + " " + command.name;
  std::string out = wrapped(command.summary, 0) + "\n\n" +
                    wrapped(fmt::format("Usage: {} {}", name, command.usage), 4) + "\n";
  for (const auto& [title, options] : command.groups) {
    out += fmt::format("\n{}:\n", title);
    for (const HelpOption& option : options) out += option_text(option);
  }
  return command.end.empty() ? out : out + "\n" + command.end + "\n";
}

std::string manual_page(const std::string& program, const std::string& version,
                        const std::vector<HelpCommand>& commands) {
  std::string title = program;
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string out = fmt::format(".TH {} 1 \"\" \"{} {}\"\n.SH NAME\n{} \\- {}\n.SH DESCRIPTION\n",
                                title, program, version, program, roff(commands.front().summary));
  for (const HelpCommand& command : commands) {
    if (&command != &commands.front()) out += fmt::format(".SH {}\n", command.name);
    out += roff_command(command);
  }
  return out;
}

std::string bash_completion(const std::string& program, const std::vector<HelpCommand>& commands) {
  std::string names, cases;
  for (const HelpCommand& command : commands) {
    if (command.name.empty()) continue;
    names += command.name + " ";
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name, long_names(command));
  }
  return fmt::format(R"(_{0}() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" words=""
  if [ "$COMP_CWORD" -eq 1 ]; then
    words="{1}help {2}"
  elif [ "${{COMP_WORDS[1]}}" = help ]; then
    words="{1}"
  elif [[ "$word" = -* ]]; then
    case "${{COMP_WORDS[1]}}" in
{3}    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _{0} {0}
)",
                     program, names, long_names(commands.front()), cases);
}

}  // namespace ccdfuzz
