#include "io/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/auxv.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/no_process.hpp"
#include "io/supervise.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kMostPrintedBytes = 1 << 20;  ///< between two questions
/// How long a process that closed its output may take to die before it is killed.
constexpr auto kTimeToDie = std::chrono::milliseconds(500);
/// The same for one that is ending, which first ends all that it has started: thousands of
/// processes.
constexpr auto kTimeToEnd = std::chrono::seconds(5);
/// How long a process may be dead, its output held open by another, before that is noticed.
constexpr long kMostBetweenLooks = 50;  // ms

/// So much of the beginning and of the end of a process's output is kept. The first two lines of a
/// sanitizer, or the first of an assertion, are about 200 bytes: they say what happened, and where.
/// A last message with a path or two takes less than 300.
constexpr size_t kKeptBeginning = 200, kKeptEnd = 300;
constexpr std::string_view kLeftOut = "\n[...]\n";

/// Leaves out what is between these, also where something was left out before.
void leave_out_middle(std::string& text) {
  if (text.size() <= kKeptBeginning + kLeftOut.size() + kKeptEnd) return;
  text.replace(kKeptBeginning, text.size() - kKeptBeginning - kKeptEnd, kLeftOut);
}

[[noreturn]] void system_refused(const char* what, int error) {
  throw NoProcess(fmt::format("the system refuses: cannot {}: {}", what, std::strerror(error)));
}

/// Two descriptors that no other child inherits.
struct DescriptorPair {
  Descriptor ours, theirs;

  static DescriptorPair pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) system_refused("make a pipe", errno);
    return {Descriptor(ends[0]), Descriptor(ends[1])};
  }
  static DescriptorPair sockets() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      system_refused("make a socket", errno);
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
  }
};

std::string signal_name(int number) {
  const char* const name = ::sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : std::string("SIG") + name;
}

/// Has the system tell how children end: where SIGCHLD is ignored, which exec hands on, nobody can
/// ask. A handler stays.
void let_ends_be_known() {
  struct sigaction action {};
  ::sigaction(SIGCHLD, nullptr, &action);
  const bool ignored = action.sa_handler == SIG_IGN;
  if (!ignored && (action.sa_flags & SA_NOCLDWAIT) == 0) return;
  if (ignored) action.sa_handler = SIG_DFL;
  action.sa_flags &= ~SA_NOCLDWAIT;
  ::sigaction(SIGCHLD, &action, nullptr);
}

/// "; it printed: …", on one line; "" of nothing.
std::string last_words(std::string printed) {
  while (!printed.empty() && std::isspace(static_cast<unsigned char>(printed.back())) != 0) {
    printed.pop_back();
  }
  for (char& c : printed) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return printed.empty() ? "" : "; it printed: " + printed;
}

/// The failure of a process that ended without an answer, by its status (waitpid) and the memory it
/// used. It is "crash SIGSEGV", "exit 3", or "memory", since running out of it shows as many
/// things. What it printed ends the note.
Fault fault_of_end(int status, std::uint64_t kibibytes_used, const ChildLimits& limits,
                   const std::string& printed) {
  const std::string words = last_words(printed);
  if (limits.cpu_seconds > 0 && WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF) {
    return {"hang", fmt::format("no answer within {} s of CPU time{}", limits.cpu_seconds, words)};
  }
  if (limits.megabytes > 0 && kibibytes_used > limits.megabytes << 9) {
    return {"memory", fmt::format("ended after it had used {} MiB of its {} MiB{}",
                                  kibibytes_used >> 10, limits.megabytes, words)};
  }
  if (WIFSIGNALED(status)) {
    const std::string signal = signal_name(WTERMSIG(status));
    return {"crash " + signal, "ended by " + signal + words};
  }
  return {fmt::format("exit {}", WEXITSTATUS(status)),
          fmt::format("called exit({}){}", WEXITSTATUS(status), words)};
}

}  // namespace

Result<std::string> find_program(const char* name, const char* variable) {
  namespace fs = std::filesystem;
  std::vector<std::string> places;
  if (const char* own = std::getenv(variable)) {
    places.emplace_back(own);
  } else {
    places.push_back(fs::path(this_program()).parent_path() / name);
    places.push_back(fmt::format("{}/{}", CCDFUZZ_PROGRAMS_BUILT_AT, name));
    places.push_back(fmt::format("{}/{}", CCDFUZZ_PROGRAMS_INSTALLED_AT, name));
  }
  for (const std::string& place : places) {
    if (::access(place.c_str(), X_OK) == 0) return place;
  }
  return input_error(name, "the program is not there; looked for {}; {} may name it",
                     fmt::join(places, ", "), variable);
}

std::string this_program() {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path self = fs::read_symlink("/proc/self/exe", none);
  if (!none) return self.string();
  return fs::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)), none).string();
}

Result<std::string> find_worker_program() {
  return find_program("ccdfuzz-plugin-worker", "CCDFUZZ_PLUGIN_WORKER");
}

void Child::start() {
  kill();
  const Result<std::string> program = find_worker_program();
  if (!program) throw NoProcess(program.error().message());
  let_ends_be_known();
  DescriptorPair questions = DescriptorPair::sockets(), replies = DescriptorPair::pipe(),
                 printed = DescriptorPair::pipe();
  questions_ = std::move(questions.ours);
  replies_ = std::move(replies.ours);
  printed_ = std::move(printed.ours);
  for (const int ours : {*questions_, *replies_, *printed_}) ::fcntl(ours, F_SETFL, O_NONBLOCK);

  std::vector<std::string> words = {*program, std::to_string(program_.limits.megabytes),
                                    std::to_string(::getpid())};
  words.insert(words.end(), program_.command.begin(), program_.command.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, *questions.theirs, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, *replies.theirs, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, *printed.theirs, STDERR_FILENO);
  if (program_.inherited >= 0) {
    posix_spawn_file_actions_adddup2(&files, program_.inherited, ChildProgram::kInherited);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl-C is for us to handle.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int failed =
      ::posix_spawn(&pid_, program->c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) {
    pid_ = -1;
    kill();
    system_refused("start a process", failed);
  }
}

void Child::kill() {
  if (pid_ > 0) {
    ::kill(pid_, SIGTERM);  // it ends whatever the plug-in has started, and itself
    ::kill(pid_, SIGCONT);  // should the plug-in have stopped it
    if (await_end(kTimeToEnd, nullptr) != pid_) {
      ::kill(-pid_, SIGKILL);
      ::kill(pid_, SIGKILL);           // the group is not there before the child runs
      await_end(kTimeToEnd, nullptr);  // who traces it may keep it for longer
    }
    pid_ = -1;
  }
  has_answered_ = false;
  for (Descriptor* one : {&questions_, &replies_, &printed_}) *one = Descriptor();
  reply_.clear();
  printed_text_.clear();
  printed_bytes_ = 0;
}

tl::expected<std::string, Fault> Child::ask(const std::string& line, double least_seconds) {
  if (!runs()) start();
  if (has_answered_) {
    read_printed();
    printed_text_.clear();
    printed_bytes_ = 0;
  }
  auto reply = await_reply(line + "\n", std::max(program_.limits.seconds, least_seconds));
  has_answered_ = reply.has_value();
  return reply;
}

tl::expected<std::string, Fault> Child::await_reply(const std::string& question, double seconds) {
  const Clock::time_point begin = Clock::now();
  const auto until =
      begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  for (size_t sent = 0;;) {
    if (sent < question.size()) {
      const ssize_t n =
          ::send(*questions_, question.data() + sent, question.size() - sent, MSG_NOSIGNAL);
      if (n > 0) sent += static_cast<size_t>(n);
      // It listens no more; what it said before it ended is still to be read.
      if (n < 0 && errno != EAGAIN && errno != EINTR) sent = question.size();
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) {
      return stopped("hang",
                     fmt::format("no answer within {} s", seconds) + last_words(printed_text_));
    }
    const std::chrono::duration<double> taken = Clock::now() - begin;
    if (program_.interrupted != nullptr && *program_.interrupted &&
        taken.count() >= ChildProgram::kPatience) {
      return stopped("interrupted", "no answer when it was interrupted");
    }
    std::array<pollfd, 3> watched = {{{*replies_, POLLIN, 0},
                                      {*printed_, POLLIN, 0},
                                      {sent == question.size() ? -1 : *questions_, POLLOUT, 0}}};
    const auto wait = static_cast<int>(std::min<long>(left, kMostBetweenLooks));
    const int ready = ::poll(watched.data(), watched.size(), wait);
    if (ready < 0 && errno != EINTR) system_refused("wait for a process", errno);
    const bool dead = ready == 0 && is_dead();  // before the look at what it wrote
    if (!read_printed()) {
      return stopped("output", fmt::format("printed more than {} bytes", kMostPrintedBytes) +
                                   last_words(printed_text_));
    }
    const bool open = read_reply();
    if (const size_t end = reply_.find('\n'); end != std::string::npos) {
      std::string line = reply_.substr(0, end);
      reply_.erase(0, end + 1);
      return line;
    }
    if (reply_.size() > program_.limits.reply_bytes) {
      return stopped("output", fmt::format("answered with a line of more than {} bytes",
                                           program_.limits.reply_bytes));
    }
    if (!open || dead) return ended();
  }
}

/// Takes what is there. False: there is an end, and nothing will come any more.
bool Child::read_reply() {
  std::array<char, 4096> buffer;
  while (reply_.size() <= program_.limits.reply_bytes) {
    const ssize_t n = ::read(*replies_, buffer.data(), buffer.size());
    if (n == 0) return false;
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    reply_.append(buffer.data(), static_cast<size_t>(n));
  }
  return true;
}

/// Takes what it printed. False: too much of it.
bool Child::read_printed() {
  std::array<char, 4096> buffer;
  while (printed_bytes_ <= kMostPrintedBytes) {
    const ssize_t n = *printed_ < 0 ? 0 : ::read(*printed_, buffer.data(), buffer.size());
    if (n == 0) printed_ = Descriptor();
    if (n <= 0) return true;
    printed_bytes_ += static_cast<size_t>(n);
    printed_text_.append(buffer.data(), static_cast<size_t>(n));
    leave_out_middle(printed_text_);
  }
  return false;
}

tl::unexpected<Fault> Child::stopped(const std::string& name, const std::string& note) {
  kill();
  return tl::unexpected(Fault{name, note});
}

bool Child::is_dead() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid == pid_;
}

/// Waits so long at most. Returns pid_ iff it has ended.
pid_t Child::await_end(Clock::duration most, int* status) const {
  const auto until = Clock::now() + most;
  pid_t gone = 0;
  while ((gone = ::waitpid(pid_, status, WNOHANG)) == 0 && Clock::now() < until) {
    ::poll(nullptr, 0, 1);
  }
  return gone;
}

/// It closed its output, or is dead: how did it end?
tl::unexpected<Fault> Child::ended() {
  int status = 0;
  const pid_t gone = await_end(kTimeToDie, &status);
  read_printed();
  // As its watchers say: to wait4 Linux adds what this process had when it became another by exec.
  std::array<std::uint64_t, 2> kibibytes{};
  ::recv(*questions_, kibibytes.data(), sizeof kibibytes, 0);
  const std::string printed = printed_text_;
  if (gone != pid_) {
    return stopped("garbage", "closed its output without an answer" + last_words(printed));
  }
  pid_ = -1;
  kill();
  if (WIFEXITED(status) && WEXITSTATUS(status) == kStartsNoneCode &&
      printed.find(kStartsNone) != printed.npos) {
    system_refused("start a process", EAGAIN);  // what it was to run is not to blame
  }
  return tl::unexpected(
      fault_of_end(status, std::ranges::max(kibibytes), program_.limits, printed));
}

}  // namespace ccdfuzz
