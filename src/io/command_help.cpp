#include "io/command_help.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <new>
#include <set>
#include <string_view>
#include <system_error>

#include "base/no_process.hpp"
#include "base/text.hpp"

namespace ccdfuzz {

namespace {

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

/// Further notes of help on an option.
std::string facts_of(const CLI::Option& option) {
  const auto listed = [](const std::set<CLI::Option*>& others) {
    std::set<std::string> names;
    for (const CLI::Option* other : others) names.insert(other->get_name());
    return fmt::format("{}", fmt::join(names, ", "));
  };
  std::string facts;
  if (option.get_required()) facts += ". Required";
  if (!option.get_needs().empty()) facts += ". Needs " + listed(option.get_needs());
  if (!option.get_excludes().empty()) facts += ". Not with " + listed(option.get_excludes());
  if (std::string standard = option.get_default_str(); !standard.empty()) {
    for (size_t at = 0; (at = standard.find(',', at)) != std::string::npos; at += 2) {
      standard.insert(at + 1, " ");
    }
    facts += fmt::format(" [{}]", standard);
  }
  return facts;
}

HelpCommand described(const CLI::App& app) {
  const bool is_program = app.get_parent() == nullptr;
  HelpCommand help{is_program ? "" : app.get_name(),
                   app.get_description(),
                   is_program ? "COMMAND [OPTIONS]" : "[OPTIONS]",
                   {},
                   app.get_footer()};
  const auto group = [&](const std::string& title) -> std::vector<HelpOption>& {
    for (auto& [known, options] : help.groups) {
      if (known == title) return options;
    }
    const auto place = [](const auto& g) {
      return g.first == "Arguments" ? 0 : g.first == "Limits" ? 2 : g.first == "Other" ? 3 : 1;
    };
    const std::pair<std::string, std::vector<HelpOption>> added{title, {}};
    const auto behind = std::ranges::upper_bound(help.groups, place(added), {}, place);
    return help.groups.insert(behind, added)->second;
  };
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_group().empty()) continue;
    group("Commands").push_back({command->get_name(), "", command->get_description()});
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    std::string text = option->get_description();
    text.insert(std::min(text.find('\n'), text.size()), facts_of(*option));
    if (!option->get_positional()) {
      std::string names = option->get_name(false, true);
      if (const size_t comma = names.find(','); comma != std::string::npos)
        names.insert(comma + 1, " ");
      const bool is_flag = option->get_expected_max() == 0 || option->get_type_size() == 0;
      group(option->get_group()).push_back({names, is_flag ? "" : option->get_type_name(), text});
      continue;
    }
    std::string name = option->get_name();
    if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) name += "...";
    group("Arguments").push_back({name, "", text});
    help.usage += option->get_required() ? " " + name : fmt::format(" [{}]", name);
  }
  return help;
}

/// The program and its listed commands, the program first.
std::vector<HelpCommand> all_described(const CLI::App& app) {
  std::vector<HelpCommand> all = {described(app)};
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) all.push_back(described(*command));
  }
  return all;
}

std::string no_such(const char* what, const std::string& name,
                    const std::vector<std::string>& known, const std::string& of) {
  const std::string meant = did_you_mean(name, known);
  return fmt::format("no such {}{}", what,
                     meant.empty() ? fmt::format("; {} {}--help lists them", kProgram, of) : meant);
}

std::string no_such_option(const CLI::App& command, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) names.push_back(option->get_name());
  }
  const std::string of = command.get_parent() == nullptr ? "" : command.get_name() + " ";
  return no_such("option", name, names, of);
}

}  // namespace

std::string help_of(const CLI::App& app) {
  const HelpCommand command = described(app);
  const std::string name = command.name.empty() ? kProgram : kProgram + (" " + command.name);
  std::string out = wrapped(command.summary, 0) + "\n\n" +
                    wrapped(fmt::format("Usage: {} {}", name, command.usage), 4) + "\n";
  for (const auto& [title, options] : command.groups) {
    out += fmt::format("\n{}:\n", title);
    for (const HelpOption& option : options) out += option_text(option);
  }
  return command.end.empty() ? out : out + "\n" + command.end + "\n";
}

std::string manual_page(const CLI::App& app, const std::string& version) {
  const std::vector<HelpCommand> commands = all_described(app);
  std::string title = kProgram;
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string out = fmt::format(".TH {} 1 \"\" \"{} {}\"\n.SH NAME\n{} \\- {}\n.SH DESCRIPTION\n",
                                title, kProgram, version, kProgram, roff(commands.front().summary));
  for (const HelpCommand& command : commands) {
    if (&command != &commands.front()) out += fmt::format(".SH {}\n", command.name);
    out += roff_command(command);
  }
  return out;
}

std::string bash_completion(const CLI::App& app) {
  const std::vector<HelpCommand> commands = all_described(app);
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
                     kProgram, names, long_names(commands.front()), cases);
}

const CLI::App& chosen_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

std::string no_such_command(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return no_such("command", name, names, "");
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(app);
  // An option that there is not may be why another seems to be missing.
  for (const std::string& extra : app.remaining(true)) {
    const std::string name = extra.substr(0, extra.find('='));
    if (!extra.starts_with('-') || extra == "--") continue;
    if (command.get_option_no_throw(name) == nullptr) {
      return name + ": " + no_such_option(command, name);
    }
    return fmt::format("{}: options come after the command, as in {} {} {}", name, kProgram,
                       command.get_name(), name);
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string extra = app.remaining(true).front();
    if (&command == &app) return extra + ": " + no_such_command(app, extra);
    return fmt::format("{}: is one argument too many; usage: ccdfuzz {} {}", extra,
                       command.get_name(), described(command).usage);
  }
  std::string text = error.what();
  for (const char* verb : {" is required", " excludes ", " requires "}) {
    const size_t at = text.find(verb);
    if (at != std::string::npos && text.find(' ') == at) return text.insert(at, ":");
  }
  const size_t repeated = text.find(": At Most 1 required");
  if (repeated != std::string::npos) return text.substr(0, repeated) + ": is given more than once";
  constexpr std::string_view kMissing = ": 1 required ";
  const size_t at = text.find(kMissing);
  if (at == std::string::npos) return text;
  const std::string value = text.substr(at + kMissing.size());
  return text.substr(0, at) + ": needs a value, " + value.substr(0, value.find(' '));
}

std::string ended_by(const std::exception& error) {
  const bool is_wrong_size = dynamic_cast<const std::bad_array_new_length*>(&error) != nullptr;
  const bool is_of_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  if (is_of_memory && !is_wrong_size) return "there is no memory left";
  if (dynamic_cast<const NoProcess*>(&error) != nullptr) return error.what();
  // TBB throws this text.
  const bool is_thread = std::string_view(error.what()).starts_with("pthread_create has failed");
  const bool is_refused = is_thread || dynamic_cast<const std::system_error*>(&error) != nullptr;
  return fmt::format("{}: {}{}", is_refused ? "the system refuses" : "internal error", error.what(),
                     is_thread ? "; --threads N asks for fewer" : "");
}

}  // namespace ccdfuzz
