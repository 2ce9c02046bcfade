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

/// Where texts of options begin.
constexpr std::size_t kTextColumn = 24;

/// An option or argument as a line of help, or a few.
std::string option_text(const std::string& name, const std::string& text) {
  std::string head = "  " + name;
  if (head.size() < kTextColumn) {
    head.resize(kTextColumn, ' ');
  } else {
    head += "\n" + std::string(kTextColumn, ' ');
  }
  return head + wrapped(text, kTextColumn, kTextColumn) + "\n";
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

/// "--seconds --cases": the options of a command by their long names.
std::string long_names(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty() || option->get_lnames().empty()) continue;
    names += (names.empty() ? "--" : " --") + option->get_lnames().front();
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

/// The name of an argument: "case" of one, "case..." of any number.
std::string argument_name(const CLI::Option& argument) {
  const bool takes_any = argument.get_expected_max() >= CLI::detail::expected_max_vector_size;
  return argument.get_name() + (takes_any ? "..." : "");
}

/// The name of an option as help shows it: "-o, --output FILE".
std::string option_name(const CLI::Option& option) {
  const bool is_flag = option.get_expected_max() == 0 || option.get_type_size() == 0;
  std::string name = option.get_name(false, true);
  if (const size_t comma = name.find(','); comma != std::string::npos) name.insert(comma + 1, " ");
  return is_flag ? name : name + " " + option.get_type_name();
}

/// What follows the name: "[OPTIONS] case...".
std::string usage_of(const CLI::App& app) {
  std::string usage = app.get_parent() == nullptr ? "COMMAND [OPTIONS]" : "[OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional() || option->get_group().empty()) continue;
    const std::string name = argument_name(*option);
    usage += option->get_required() ? " " + name : fmt::format(" [{}]", name);
  }
  return usage;
}

std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
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
  std::vector<std::pair<std::string, std::string>> groups;  // title and lines
  const auto group = [&](const std::string& title) -> std::string& {
    for (auto& [known, lines] : groups) {
      if (known == title) return lines;
    }
    const auto place = [](const auto& g) {
      return g.first == "Arguments" ? 0 : g.first == "Limits" ? 2 : g.first == "Other" ? 3 : 1;
    };
    const std::pair<std::string, std::string> added{title, ""};
    const auto behind = std::ranges::upper_bound(groups, place(added), {}, place);
    return groups.insert(behind, added)->second;
  };
  for (const CLI::App* command : listed_commands(app)) {
    group("Commands") += option_text(command->get_name(), command->get_description());
  }
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    std::string text = option->get_description();
    text.insert(std::min(text.find('\n'), text.size()), facts_of(*option));
    if (option->get_positional()) {
      group("Arguments") += option_text(argument_name(*option), text);
    } else {
      group(option->get_group()) += option_text(option_name(*option), text);
    }
  }
  const std::string name =
      app.get_parent() == nullptr ? kProgram : kProgram + (" " + app.get_name());
  std::string out = wrapped(app.get_description(), 0) + "\n\n" +
                    wrapped(fmt::format("Usage: {} {}", name, usage_of(app)), 4) + "\n";
  for (const auto& [title, lines] : groups) out += fmt::format("\n{}:\n{}", title, lines);
  return app.get_footer().empty() ? out : out + "\n" + app.get_footer() + "\n";
}

std::string manual_page(const CLI::App& app, const std::string& version) {
  std::string title = kProgram;
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string out = fmt::format(".TH {} 1 \"\" \"{} {}\"\n.SH NAME\n{} \\- {}\n", title, kProgram,
                                version, kProgram, roff(app.get_description()));
  const auto add = [&out](const std::string& section, const CLI::App& command) {
    out += fmt::format(".SH {}\n.nf\n{}.fi\n", section, roff(help_of(command)));
  };
  add("DESCRIPTION", app);
  for (const CLI::App* command : listed_commands(app)) add(command->get_name(), *command);
  return out;
}

std::string bash_completion(const CLI::App& app) {
  std::string names, cases;
  for (const CLI::App* command : listed_commands(app)) {
    names += command->get_name() + " ";
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), long_names(*command));
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
                     kProgram, names, long_names(app), cases);
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
                       command.get_name(), usage_of(command));
  }
  std::string text = error.what();
  for (const char* verb : {" is required", " excludes ", " requires "}) {
    const size_t at = text.find(verb);
    if (at != std::string::npos && text.find(' ') == at) return text.insert(at, ":");
  }
  const size_t repeated = text.find(": At Most 1 required");
  if (repeated != std::string::npos) {
    const std::string name = text.substr(0, repeated);
    const CLI::Option* option = command.get_option_no_throw(name);
    const bool is_list =
        option != nullptr && option->get_description().find("comma") < std::string::npos;
    return name + ": is given more than once" + (is_list ? "; several go with commas between" : "");
  }
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
