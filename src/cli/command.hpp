#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_names.hpp"
#include "base/number_text.hpp"
#include "base/result.hpp"

// CLI11's headers cost seconds in each file that includes them: command.cpp does, and
// io/command_help.cpp.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace ccdfuzz {

class Session;
struct Suite;
struct Property;
using FindSuite = std::function<Result<Suite>(std::string_view)>;

/// The exit codes of every command. A command that was interrupted ends with 128 + the signal.
enum ExitCode : int {
  kDone = 0,
  kCheckFailed = 1,  ///< a replay regression, a refuted truth, a find that --fail-on names
  kBadInput = 2,     ///< bad usage or input, or no place to write to
  kInternal = 3,
};

/// Ends a command with kBadInput and this message. Thrown by commands alone: libraries return a
/// Result.
struct BadInput {
  InputError error;
};

/// The value of the result. Throws BadInput if it is an error.
template <class T>
T need(Result<T> result) {
  if (!result) throw BadInput{std::move(result.error())};
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}
/// The same of what is at `where`, whatever place the error names.
template <class T>
T need_at(const std::string& where, Result<T> result) {
  return need(std::move(result).map_error([&](const InputError& error) {
    return InputError{where, error.what};
  }));
}

/// How the user called this program, so that the commands we print work when pasted.
const std::string& program_name();
/// The command line as the user typed it, quoted for a shell.
const std::string& command_line();

/// The value whose name the text is. Errors: no value has it; lists all.
template <NamedEnum E>
Result<E> parse_choice(const std::string& where, const std::string& text) {
  if (const std::optional<E> named = enum_named<E>(text)) return *named;
  return input_error(where, "\"{}\" is not one of {}", text, enum_names<E>());
}

/// The type of a value, or of what an optional may hold.
template <class Value>
using ValueIn = typename decltype(std::optional(std::declval<Value>()))::value_type;

/// What help shows of the value that an option has by default; nothing of one that is absent.
template <class Value>
std::string shown_default(const Value& value) {
  if constexpr (requires { *value; }) {
    return value ? shown_default(*value) : "";
  } else if constexpr (NamedEnum<Value>) {
    return std::string(name_of(value));
  } else {
    return fmt::format("{}", value);
  }
}

/// One option of a command, for what more is to be said of it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  Option& excludes(const Option& other);
  Option& needs(const Option& other);
  /// In which group help shows it.
  Option& in(const char* group);

 private:
  CLI::Option* option_;
};

/// The options of one command. Values are bound: each must outlive the parsing, and what it holds
/// before is its default. A name is followed by what its value is: "-o,--output FILE".
class Command {
 public:
  /// Help shows the options that are added from now on in this group.
  void group(const std::string& title);
  /// The example that help shows last: its purpose, and the line behind "ccdfuzz".
  void example(const std::string& what, const std::string& line);

  /// An empty text is refused, as `value` that stays empty means that the option was not given.
  Option text(const std::string& name, std::string& value, const std::string& description);
  /// The same, where an empty text is not the same as none.
  Option text(const std::string& name, std::optional<std::string>& value,
              const std::string& description);
  /// Any number of them, without an option's name in front. An empty one is refused.
  Option texts(const std::string& name, std::vector<std::string>& values,
               const std::string& description);
  Option flag(const std::string& name, bool& value, const std::string& description);
  /// A whole number of [least, most], in decimal (parse_whole); an optional may be absent.
  template <class Value, class N = ValueIn<Value>>
  Option whole(const std::string& name, Value& value, const std::string& description,
               std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<N>::max()) {
    return add_text(name + " N", description, shown_default(value),
                    [&value, least, most](const std::string& where, const std::string& text) {
                      value = static_cast<N>(need(parse_whole(where, text, least, most)));
                    });
  }

  /// The value that parse(where, text) makes of the text; where is the option's name.
  template <class Value, class T>
  Option parsed(const std::string& name, Value& value, const std::string& description,
                Result<T> (*parse)(const std::string& where, const std::string& text),
                const std::string& standard = "") {
    return add_text(name, description, standard,
                    [&value, parse](const std::string& where, const std::string& text) {
                      value = need(parse(where, text));
                    });
  }
  /// The same of each item of a list (parse_list).
  template <class Value, class T>
  Option list(const std::string& name, Value& values, const std::string& description,
              Result<T> (*parse)(const std::string& where, const std::string& item),
              const std::string& standard = "") {
    return add_text(name, description, standard,
                    [&values, parse](const std::string& where, const std::string& text) {
                      values = need(parse_list(where, text, parse));
                    });
  }
  /// One of the names of an enumeration's values.
  template <class Value, class E = ValueIn<Value>>
  Option choice(const std::string& name, Value& value, const std::string& description) {
    return parsed(name, value, description, &parse_choice<E>, shown_default(value));
  }

  /// --threads, by default as many as there are cores; --json.
  Option threads();
  Option json(const std::string& description);
  /// --plugin NAME=SPEC, which name_plugin takes. Added before any option that may name a method.
  Option plugin_names();
  /// --allow-plugins: of the plug-ins that files name, the command starts no others.
  Option allow_plugins();
  /// --max-work, the limit of RunWork, of each command that checks cases of files. which: these.
  Option max_work(const std::string& which = "cases of files");

 private:
  friend class CommandLine;
  Command(CLI::App* app, Session& session) : app_(app), session_(&session) {}
  /// take: may throw BadInput. where: the option's name.
  using Take = std::function<void(const std::string& where, const std::string& text)>;
  Option add_text(const std::string& name, const std::string& description,
                  const std::string& standard, Take take);

  CLI::App* app_;
  Session* session_;
};

/// The commands of this program.
class CommandLine {
 public:
  /// All the properties that there are. find_suite: finds the suite that `triage --target` names.
  CommandLine(const std::vector<Property>& properties, FindSuite find_suite);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Adds a command that runs as run(options) and returns its exit code; BadInput that it throws
  /// ends the program with kBadInput. Returns the command and its options, for the caller to bind.
  template <class Options>
  std::pair<Command, Options*> add(const std::string& name, const std::string& description,
                                   int (*run)(const Options&, Session&)) {
    const auto options = std::make_shared<Options>();
    return {
        add_command(name, description, [this, options, run] { return run(*options, *session_); }),
        options.get()};
  }

  /// Parses, runs the chosen command, and reports what went wrong. Returns the exit code. First
  /// prepares the process: signals (end_on_signals), and descriptors 0, 1 and 2, which no file that
  /// is opened later may get.
  int parse_and_run(int argc, char** argv);

 private:
  void add_help();
  Command add_command(const std::string& name, const std::string& description,
                      std::function<int()> run);

  std::unique_ptr<CLI::App> app_;
  std::unique_ptr<Session> session_;
  std::function<int()> chosen_;
};

void add_bench(CommandLine& line);
void add_check(CommandLine& line);
void add_evaluate(CommandLine& line);
void add_export(CommandLine& line);
void add_generate(CommandLine& line);
void add_hunt(CommandLine& line);
void add_import(CommandLine& line);
void add_merge(CommandLine& line);
void add_methods(CommandLine& line);
void add_minimize(CommandLine& line);
void add_properties(CommandLine& line);
void add_prove(CommandLine& line);
void add_query(CommandLine& line);
void add_replay(CommandLine& line);
void add_report(CommandLine& line);
void add_trace(CommandLine& line);
void add_triage(CommandLine& line);
void add_verify(CommandLine& line);

}  // namespace ccdfuzz
