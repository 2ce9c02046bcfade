#pragma once

#include <fcntl.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "scratch_folder.hpp"

namespace ccdfuzz {

/// What a program left behind: its exit code, or 128 + the signal that ended it.
struct Finished {
  std::string command;
  int code = -1;
  std::string out;
  std::string err;
  std::uint64_t peak_bytes = 0;  ///< of memory in use, or of this process if that used more
};

/// A running program; by default the real ccdfuzz, as a user would start it.
class Process {
 public:
  /// stdout and stderr go to files of a scratch folder unless a path is given.
  explicit Process(std::vector<std::string> arguments, const std::string& out_path = "",
                   const std::string& program = CCDFUZZ_EXECUTABLE)
      : out_path_(out_path.empty() ? scratch_ / "out" : out_path), err_path_(scratch_ / "err") {
    arguments.insert(arguments.begin(), program);
    command_ = fmt::format("{}", fmt::join(arguments, " "));
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out_path_.c_str(), kWrite, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err_path_.c_str(), kWrite, 0600);
    const int failed = posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failed != 0) throw std::runtime_error("cannot start " + program);
  }
  ~Process() {
    if (pid_ <= 0) return;
    signal(SIGKILL);
    wait();
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number) { ::kill(pid_, number); }

  /// Whether it has ended.
  bool is_over() const {
    siginfo_t ended = {};
    return ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid != 0;
  }

  /// Until then, or its end.
  template <class Condition>
  void wait_until(const Condition& holds) const {
    EXPECT_TRUE(comes_to_hold([&] { return holds() || is_over(); })) << command_;
  }

  /// How many bytes it has read.
  std::uintmax_t bytes_read() const {
    std::istringstream counts(read_text(fmt::format("/proc/{}/io", pid_)));
    std::string name;
    std::uintmax_t bytes = 0;
    counts >> name >> bytes;
    return bytes;
  }

  Finished wait() {
    int status = 0;
    rusage used = {};
    ::wait4(pid_, &status, 0, &used);
    pid_ = -1;
    return {command_, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            contents(out_path_), contents(err_path_),
            static_cast<std::uint64_t>(used.ru_maxrss) << 10U};
  }

  /// What it leaves when a signal ends it.
  Finished ended_by(int number) {
    signal(number);
    Finished finished = wait();
    EXPECT_EQ(finished.code, 128 + number) << finished.out << finished.err;
    return finished;
  }

 private:
  /// Nothing of a device: /dev/full can be read for ever.
  static std::string contents(const std::string& path) {
    return std::filesystem::is_regular_file(path) ? read_text(path) : "";
  }

  ScratchFolder scratch_;
  std::string command_, out_path_, err_path_;
  pid_t pid_ = -1;
};

inline Finished ccdfuzz(std::vector<std::string> arguments, const std::string& out_path = "") {
  return Process(std::move(arguments), out_path).wait();
}

/// The size of a file that may come and go, 0 of one that is not there.
inline std::uintmax_t size_or_zero(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  return none ? 0 : size;
}

/// The complete finds in a folder that may come and go.
inline std::set<std::string> entries_in(const std::string& folder) {
  std::set<std::string> names;
  std::error_code vanished;
  for (std::filesystem::directory_iterator it(folder, vanished), end; !vanished && it != end;
       it.increment(vanished)) {
    const std::string name = it->path().filename();
    if (name.ends_with(".json") && !name.starts_with('.')) names.insert(name);
  }
  return names;
}

/// What a command leaves that is sent a signal once this file of its has so many bytes.
inline Finished ended_by(int signal, const std::vector<std::string>& command,
                         const std::string& path, std::uintmax_t bytes) {
  Process process(command);
  process.wait_until([&] { return size_or_zero(path) >= bytes; });
  return process.ended_by(signal);
}

/// A command with more arguments.
inline std::vector<std::string> with(std::vector<std::string> command,
                                     const std::vector<std::string>& more) {
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

/// The names behind "Commands:" in the general help.
inline std::vector<std::string> commands() {
  const std::string help = ccdfuzz({"--help"}).out;
  const size_t begin = help.find("Commands:\n"), end = help.find("Options:\n");
  const std::string listed = help.substr(begin, end - begin);
  static const std::regex kName("\n  ([a-z]+) ");
  std::vector<std::string> names;
  for (std::sregex_iterator at(listed.begin(), listed.end(), kName), none; at != none; ++at) {
    names.push_back((*at)[1]);
  }
  return names;
}

/// Runs a line of shell, in which $ccdfuzz is the program.
inline Finished shell(const std::string& line) {
  return Process({"-c", fmt::format("ccdfuzz='{}'; {}", CCDFUZZ_EXECUTABLE, line)}, "", "/bin/sh")
      .wait();
}

/// A failure unless the program ended well.
inline Finished succeeded(Finished finished) {
  EXPECT_EQ(finished.code, 0) << finished.command << '\n' << finished.out << finished.err;
  return finished;
}

/// A failure unless the program ended as where what it checks does not hold.
inline Finished failed(Finished finished) {
  EXPECT_EQ(finished.code, 1) << finished.command << '\n' << finished.out << finished.err;
  return finished;
}

/// A failure unless the program ended as for bad input, naming this.
inline Finished refused(Finished finished, const std::string& named) {
  EXPECT_EQ(finished.code, 2) << finished.command << '\n' << finished.out << finished.err;
  EXPECT_THAT(finished.err, testing::HasSubstr(named)) << finished.command;
  return finished;
}

/// Each line of the text as JSON; a failure if one is not.
inline std::vector<nlohmann::ordered_json> json_lines(const std::string& text) {
  std::vector<nlohmann::ordered_json> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(nlohmann::ordered_json::parse(line, nullptr, false));
    EXPECT_FALSE(rows.back().is_discarded()) << line;
  }
  return rows;
}

/// The data in the page of a report's folder; the JSON of another of its elements.
inline nlohmann::json page_data(const std::string& folder, const std::string& id = "report") {
  const std::string page = read_text(folder + "/index.html");
  const std::string open = fmt::format(R"(<script id="{}" type="application/json">)", id);
  const size_t begin = page.find(open);
  if (begin == std::string::npos) return {};
  const size_t from = begin + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// Makes a data set; its path.
inline std::string generated(const ScratchFolder& folder, const std::string& contact,
                             const std::string& kind, int count) {
  const std::string path = folder / (contact + kind + ".jsonl");
  const Finished made = ccdfuzz({"generate", "--contact", contact, "--kind", kind, "--count",
                                 std::to_string(count), "--construction", "one-sided", "-o", path});
  EXPECT_EQ(made.code, 0) << made.err;
  return path;
}

}  // namespace ccdfuzz
