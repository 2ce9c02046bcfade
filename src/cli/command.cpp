#include "cli/command.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>
#include <tuple>

#include "base/text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/session.hpp"
#include "files/check_file.hpp"
#include "io/command_help.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"
#include "method/method.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

std::string called_as = kProgram;
std::string typed;

/// The message may quote what a file or a plug-in says: no line of it is taken for one of ours.
/// Prints only both ends of a long line, as a value of an option may be of any length.
int complain(const std::string& message, int code, const std::string& command = kProgram) {
  constexpr size_t kLongest = 2000, kEnd = kLongest / 2;
  std::string margin = command == kProgram ? "ccdfuzz: " : "ccdfuzz: " + command + ": ";
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line); margin = "  ") {
    if (line.size() > kLongest) line.replace(kEnd, line.size() - kLongest, " … ");
    print_err(fmt::format("{}{}\n", margin, shown_line(line)));
  }
  return code;
}

/// A thread that is not ours may throw, as TBB's do where the system starts no more of them.
[[noreturn]] void end_on_uncaught() {
  remove_unfinished_files();
  std::string what = "internal error: ended by no exception, or an unknown one";
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    what = ended_by(error);
  } catch (...) {  // NOLINT: no text is known
  }
  complain(what, kInternal);
  ::_exit(kInternal);
}

/// Names the option of the command whose path the error is about, if there is one. The path is the
/// option's value, or what is in it or beside it. It is not, where an argument without a name says
/// more of it.
void name_option(const CLI::App& command, InputError& error) {
  size_t said_by_argument = 0;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    for (const std::string& value : option->results()) {
      if (error.where.starts_with(value))
        said_by_argument = std::max(said_by_argument, value.size());
    }
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) continue;
    const std::string kind = option->get_type_name();
    const bool names_files = kind == "FILE" || kind == "FOLDER" || kind == "PATH";
    for (const std::string& value : option->results()) {
      if (!error.where.starts_with(value) || value.size() < said_by_argument) continue;
      const std::string rest = error.where.substr(value.size());
      if (!rest.empty() && (!names_files || rest.find_first_of("/.:") != 0)) continue;
      error.where = fmt::format("{}: {}", option->get_name(), error.where);
      return;
    }
  }
}

/// A plug-in with a name that --methods does not name is asked nothing, unless files may name it.
void refuse_unasked_plugins(const CLI::App& command) {
  const CLI::Option* const plugins = command.get_option_no_throw("--plugin");
  const CLI::Option* methods = command.get_option_no_throw("--methods");
  if (methods == nullptr) methods = command.get_option_no_throw("--method");
  const bool files_name_methods = command.get_option_no_throw("--allow-plugins") != nullptr;
  if (plugins == nullptr || methods == nullptr || files_name_methods) return;
  std::set<std::string> asked;
  for (const std::string& list : methods->results()) {
    for (const std::string& spec : texts_between(list)) asked.insert(spec);
  }
  for (const std::string& list : plugins->results()) {
    for (const std::string& item : texts_between(list)) {
      const std::string name = kPluginPrefix + item.substr(0, item.find('='));
      if (asked.contains(name)) continue;
      throw BadInput{{"--plugin", fmt::format("{} is not asked, as {} does not name it", name,
                                              methods->get_name())}};
    }
  }
}

/// A closed one would become the next file that is opened, and messages would go into it. Opened
/// for reading, so that writing there fails as it does on a closed one.
void occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
  }
}

/// The options of a command that decide its result, with their values. Neither where that goes nor
/// how much work it may take does, nor where the programs stand that plug-ins are names of.
std::map<std::string, std::string> asked_of(const CLI::App& command) {
  std::map<std::string, std::string> asked;
  for (const CLI::Option* option : command.get_options()) {
    const std::string group = option->get_group(), name = option->get_name();
    if (option->get_positional() || group == "Results" || group == "Other") continue;
    const std::string text = option->count() > 0
                                 ? fmt::format("{}", fmt::join(option->results(), ","))
                                 : option->get_default_str();
    if (text.empty() || name == "--max-work" || name == "--plugin") continue;
    asked[name] = text;
  }
  return asked;
}

/// "-o,--output FILE" in its two parts.
struct Named {
  explicit Named(const std::string& text)
      : name(text.substr(0, text.find(' '))),
        value(name.size() < text.size() ? text.substr(name.size() + 1) : "TEXT") {}
  std::string name, value;
};

}  // namespace

const std::string& program_name() {
  return called_as;
}

const std::string& command_line() {
  return typed;
}

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::in(const char* group) {
  option_->group(group);
  return *this;
}

void Command::group(const std::string& title) {
  app_->option_defaults()->group(title);
}

void Command::example(const std::string& what, const std::string& line) {
  app_->footer(fmt::format("Example, {}:\n  {} {}", what, kProgram, line));
}

Option Command::text(const std::string& name, std::string& value, const std::string& description) {
  const bool is_folder = Named(name).value == "FOLDER";
  return add_text(
      name, description, value,
      [&value, is_folder](const std::string& where, const std::string& text) {
        if (is_folder && case_file_kind_by_name(text) && !std::filesystem::is_directory(text)) {
          throw BadInput{{where, text + ": is a file of cases by its name; accepted is a folder"}};
        }
        value = text;
      });
}

Option Command::text(const std::string& name, std::optional<std::string>& value,
                     const std::string& description) {
  const Named named(name);
  return Option(
      app_->add_option_function<std::string>(
              named.name, [&value](const std::string& text) { value = text; }, description)
          ->type_name(named.value));
}

Option Command::texts(const std::string& name, std::vector<std::string>& values,
                      const std::string& description) {
  const std::function<std::string(const std::string&)> fault = [](const std::string& text) {
    return text.empty() ? "is empty" : "";
  };
  return Option(app_->add_option(name, values, description)->check(fault));
}

Option Command::flag(const std::string& name, bool& value, const std::string& description) {
  return Option(app_->add_flag(name, value, description));
}

Option Command::add_text(const std::string& name, const std::string& description,
                         const std::string& standard, Take take) {
  const Named named(name);
  const std::string where = named.name.substr(named.name.rfind(',') + 1);
  return Option(app_->add_option_function<std::string>(
                        named.name,
                        [where, take = std::move(take)](const std::string& text) {
                          if (text.empty()) throw BadInput{{where, "is empty"}};
                          take(where, text);
                        },
                        description)
                    ->type_name(named.value)
                    ->default_str(standard));
}

Option Command::threads() {
  session_->threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return whole("--threads", session_->threads, "Threads; equal results unless time is limited", 1,
               1024)
      .in("Other");
}

Option Command::plugin_names() {
  return add_text("--plugin NAME=SPEC",
                  "Load this plug-in. Options, files and output name it plugin:NAME. Several "
                  "with commas between",
                  "",
                  [](const std::string& where, const std::string& text) {
                    for (const std::string& item : texts_between(text)) {
                      const size_t equals = item.find('=');
                      if (equals == std::string::npos) {
                        throw BadInput{
                            {where, fmt::format("\"{}\" is not of the form NAME=SPEC", item)}};
                      }
                      need_at(where, name_plugin(item.substr(0, equals), item.substr(equals + 1)));
                    }
                  })
      .in("Methods");
}

Option Command::allow_plugins() {
  return add_text(
             "--allow-plugins LIST",
             "Plug-ins that may be started where files name them, separated by commas, each "
             "spelled as in the file",
             "",
             [](const std::string& where, const std::string& text) {
               for (const std::string& spec : need(parse_list(where, text, parse_method))) {
                 if (names_plugin(spec)) continue;
                 throw BadInput{
                     {where, fmt::format("\"{}\" is not plugin:PATH or plugin-exec:PATH", spec)}};
               }
             })
      .in("Methods");
}

Option Command::max_work(const std::string& which) {
  return add_text("--max-work N",
                  fmt::format("End the command after this much work of checking {}, in operations "
                              "on 64-bit words. By default 2^32 + min(2^27 * cases, "
                              "2^18 * bytes of the files)",
                              which),
                  "",
                  [](const std::string& where, const std::string& text) {
                    RunWork::allow(need(parse_whole(where, text)));
                  })
      .in("Limits");
}

Option Command::json(const std::string& description) {
  return flag("--json", session_->json, description).in("Results");
}

CommandLine::CommandLine(const std::vector<Property>& properties, FindSuite find_suite)
    : app_(std::make_unique<CLI::App>(
          "Fuzzing and property testing for continuous collision detection", kProgram)),
      session_(std::make_unique<Session>()) {
  session_->properties = properties;
  session_->find_suite = std::move(find_suite);
  app_->set_help_flag("-h,--help", "Show this help");
  app_->set_version_flag("-V,--version", CCDFUZZ_VERSION, "Show the version");
  app_->require_subcommand(0, 1);  // 1, 1 would answer a misspelt command with "required" alone
  app_->footer(
      "Exit codes: 0 done, 1 a check failed, 2 bad usage or input, or a file that\n"
      "cannot be written, 3 internal error or no process to start, 128 + the signal:\n"
      "interrupted (130 by Ctrl-C). Help: ccdfuzz help COMMAND");
  add_help();
}

/// Not listed: `ccdfuzz serve METHOD`, of which only the help is here (serve_if_asked); `ccdfuzz
/// help [COMMAND]`, and with --man or --bash what is installed.
void CommandLine::add_help() {
  struct AskedHelp {
    std::string command;
    bool manual = false, bash = false;
  };
  CLI::App* const serve =
      app_->add_subcommand("serve", "Answer for a method, as a plug-in by lines of JSON")
          ->group("");
  serve->add_option("METHOD", "A built-in method, such as tdibm-c")->required();
  serve->get_help_ptr()->group("Other");
  serve->footer("");
  const auto asked = std::make_shared<AskedHelp>();
  CLI::App* const help = app_->add_subcommand("help", "Show the help of a command")->group("");
  CLI::Option* const of_one = help->add_option("command", asked->command);
  CLI::Option* const manual = help->add_flag("--man", asked->manual)->excludes(of_one);
  help->add_flag("--bash", asked->bash)->excludes(of_one)->excludes(manual);
  help->callback([this, asked] {
    chosen_ = [this, asked] {
      const std::string& name = asked->command;
      const std::vector<CLI::App*> named = app_->get_subcommands(
          [&](const CLI::App* command) { return command->get_name() == name; });
      if (!name.empty() && named.empty()) throw BadInput{{name, no_such_command(*app_, name)}};
      print_out(asked->manual ? manual_page(*app_, CCDFUZZ_VERSION)
                : asked->bash ? bash_completion(*app_)
                              : help_of(name.empty() ? *app_ : *named.front()));
      return kDone;
    };
  });
}

CommandLine::~CommandLine() = default;

Command CommandLine::add_command(const std::string& name, const std::string& description,
                                 std::function<int()> run) {
  CLI::App* const command = app_->add_subcommand(name, description);
  command->get_help_ptr()->group("Other");
  command->footer("");
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  return Command(command, *session_);
}

int CommandLine::parse_and_run(int argc, char** argv) {
  called_as = argv[0];
  for (int i = 0; i < argc; ++i) typed += (i > 0 ? " " : "") + shell_word(argv[i]);
  occupy_standard_descriptors();
  end_on_signals();
  std::set_terminate(end_on_uncaught);
  int code = kDone;
  std::optional<InputError> error;
  try {
    app_->parse(argc, argv);
    if (!chosen_) {
      print_err(help_of(*app_));
      return complain("no command given", kBadInput);
    }
    const CLI::App& command = chosen_command(*app_);
    session_->command = command.get_name();
    session_->asked = asked_of(command);
    refuse_unasked_plugins(command);
    code = chosen_();
    if (session_->refused()) std::rethrow_exception(session_->refused());
  } catch (const BadInput& bad) {
    session_->end_table();
    error = bad.error;
  } catch (const std::filesystem::filesystem_error& refused) {
    error = system_error(refused.path1().string(), "read", refused.code().value()).value();
  } catch (const CLI::CallForHelp&) {
    print_out(help_of(chosen_command(*app_)));
  } catch (const CLI::CallForVersion&) {
    print_out(CCDFUZZ_VERSION "\n");
  } catch (const CLI::ParseError& usage) {
    return complain(usage_error(*app_, usage), kBadInput, chosen_command(*app_).get_name());
  } catch (const std::exception& fault) {
    session_->end_table();
    std::ignore = flush_stdout();
    return complain(ended_by(fault), kInternal);
  }
  if (error && chosen_) name_option(chosen_command(*app_), *error);
  // What was printed before an error must appear before its message. An unwritable stdout is an
  // error, too, unless there is one already.
  const Result<void> flushed = flush_stdout();
  if (!flushed && !error) error = flushed.error();
  return error ? complain(error->message(), kBadInput, chosen_command(*app_).get_name()) : code;
}

}  // namespace ccdfuzz
