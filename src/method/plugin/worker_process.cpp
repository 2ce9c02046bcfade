#include "method/plugin/worker_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "method/process_end.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kMostReplyBytes = 64 << 10;
constexpr size_t kMostPrintedBytes = 1 << 20;  ///< between two questions
/// How long a process that closed its output may take to die before it is killed.
constexpr auto kTimeToDie = std::chrono::milliseconds(500);
/// How long a process may be dead, its output held open by another, before that is noticed.
constexpr long kMostBetweenLooks = 50;  // ms

[[noreturn]] void system_refused(const char* what, int error) {
  throw std::runtime_error(fmt::format("cannot {}: {}", what, std::strerror(error)));
}

/// Two descriptors that no other child inherits.
struct DescriptorPair {
  std::array<int, 2> ends{-1, -1};

  static DescriptorPair pipe() {
    DescriptorPair pair;
    if (::pipe2(pair.ends.data(), O_CLOEXEC) != 0) system_refused("make a pipe", errno);
    return pair;
  }
  static DescriptorPair sockets() {
    DescriptorPair pair;
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.ends.data()) != 0) {
      system_refused("make a socket", errno);
    }
    return pair;
  }
};

void close_descriptor(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

Result<std::string> find_worker_program() {
  namespace fs = std::filesystem;
  constexpr const char* kName = "ccdfuzz-plugin-worker";
  std::vector<std::string> places;
  if (const char* own = std::getenv("CCDFUZZ_PLUGIN_WORKER")) {
    places.emplace_back(own);
  } else {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    if (!error) places.push_back(self.parent_path() / kName);
    places.emplace_back(CCDFUZZ_WORKER_BUILT_AT);
    places.emplace_back(CCDFUZZ_WORKER_INSTALLED_AT);
  }
  for (const std::string& place : places) {
    if (::access(place.c_str(), X_OK) == 0) return place;
  }
  return input_error("--methods", fmt::format("the program that loads plug-ins is not there; "
                                              "looked for {}",
                                              fmt::join(places, ", ")));
}

void WorkerProcess::start() {
  kill();
  const Result<std::string> program = find_worker_program();
  if (!program) throw std::runtime_error(program.error().message());
  let_ends_be_known();
  const DescriptorPair questions = DescriptorPair::sockets();
  const DescriptorPair replies = DescriptorPair::pipe();
  const DescriptorPair printed = DescriptorPair::pipe();
  questions_ = questions.ends[0];
  replies_ = replies.ends[0];
  printed_ = printed.ends[0];
  for (const int ours : {questions_, replies_, printed_}) ::fcntl(ours, F_SETFL, O_NONBLOCK);

  std::array<std::string, 5> words = {
      *program, std::to_string(spec_.megabytes),
      std::to_string(static_cast<long>(std::ceil(spec_.seconds)) + 2),
      spec_.is_program ? "run" : "load", spec_.path};
  std::array<char*, 6> arguments{};
  for (size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, questions.ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, replies.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, printed.ends[1], STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl-C is for us to handle.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int failed =
      ::posix_spawn(&pid_, program->c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  for (const DescriptorPair& pair : {questions, replies, printed}) ::close(pair.ends[1]);
  if (failed != 0) {
    pid_ = -1;
    kill();
    system_refused("start a worker", failed);
  }
}

void WorkerProcess::kill() {
  if (pid_ > 0) {
    ::kill(pid_, SIGTERM);  // it ends whatever the plug-in has started, and itself
    if (await_end(nullptr, nullptr) != pid_) {
      ::kill(-pid_, SIGKILL);
      ::kill(pid_, SIGKILL);  // the group is not there before the child runs
      ::waitpid(pid_, nullptr, 0);
    }
    pid_ = -1;
  }
  close_descriptor(questions_);
  close_descriptor(replies_);
  close_descriptor(printed_);
  reply_.clear();
  printed_text_.clear();
  printed_bytes_ = 0;
}

tl::expected<std::string, PluginFault> WorkerProcess::exchange(const std::string& line,
                                                               double seconds) {
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(seconds));
  read_printed();
  printed_bytes_ = 0;
  return await_reply(line + "\n", until);
}

tl::expected<std::string, PluginFault> WorkerProcess::await_reply(std::string to_send,
                                                                  Clock::time_point until) {
  while (true) {
    if (!to_send.empty()) {
      const ssize_t n = ::send(questions_, to_send.data(), to_send.size(), MSG_NOSIGNAL);
      if (n > 0) to_send.erase(0, static_cast<size_t>(n));
      // It listens no more; what it said before it ended is still to be read.
      if (n < 0 && errno != EAGAIN && errno != EINTR) to_send.clear();
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) {
      return tl::unexpected(stopped(
          "hang", fmt::format("no answer within {} s", spec_.seconds) + last_words(printed_text_)));
    }
    std::array<pollfd, 3> watched = {{{replies_, POLLIN, 0},
                                      {printed_, POLLIN, 0},
                                      {to_send.empty() ? -1 : questions_, POLLOUT, 0}}};
    const auto wait = static_cast<int>(std::min<long>(left, kMostBetweenLooks));
    const int ready = ::poll(watched.data(), watched.size(), wait);
    if (ready < 0 && errno != EINTR) system_refused("wait for a worker", errno);
    const bool dead = ready == 0 && is_dead();  // before the look at what it wrote
    if (!read_printed()) {
      return tl::unexpected(
          stopped("output", fmt::format("printed more than {} bytes", kMostPrintedBytes) +
                                last_words(printed_text_)));
    }
    const bool open = read_reply();
    if (const size_t end = reply_.find('\n'); end != std::string::npos) {
      std::string line = reply_.substr(0, end);
      reply_.erase(0, end + 1);
      return line;
    }
    if (reply_.size() > kMostReplyBytes) {
      return tl::unexpected(stopped(
          "output", fmt::format("answered with a line of more than {} bytes", kMostReplyBytes)));
    }
    if (!open || dead) return tl::unexpected(ended());
  }
}

/// Takes what is there. False: there is an end, and nothing will come any more.
bool WorkerProcess::read_reply() {
  std::array<char, 4096> buffer;
  while (reply_.size() <= kMostReplyBytes) {
    const ssize_t n = ::read(replies_, buffer.data(), buffer.size());
    if (n == 0) return false;
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    reply_.append(buffer.data(), static_cast<size_t>(n));
  }
  return true;
}

/// Takes what it printed. False: too much of it.
bool WorkerProcess::read_printed() {
  std::array<char, 4096> buffer;
  while (printed_bytes_ <= kMostPrintedBytes) {
    const ssize_t n = printed_ < 0 ? 0 : ::read(printed_, buffer.data(), buffer.size());
    if (n == 0) close_descriptor(printed_);
    if (n <= 0) return true;
    printed_bytes_ += static_cast<size_t>(n);
    printed_text_.append(buffer.data(), static_cast<size_t>(n));
    if (printed_text_.size() > kKeptPrintedBytes) {
      printed_text_.erase(0, printed_text_.size() - kKeptPrintedBytes);
    }
  }
  return false;
}

PluginFault WorkerProcess::stopped(const std::string& name, const std::string& note) {
  kill();
  return {name, note};
}

bool WorkerProcess::is_dead() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid == pid_;
}

/// Waits a little. Returns pid_ iff it has ended.
pid_t WorkerProcess::await_end(int* status, rusage* used) const {
  const auto until = Clock::now() + kTimeToDie;
  pid_t gone = 0;
  while ((gone = ::wait4(pid_, status, WNOHANG, used)) == 0 && Clock::now() < until) {
    ::poll(nullptr, 0, 1);
  }
  return gone;
}

/// It closed its output, or is dead: how did it end?
PluginFault WorkerProcess::ended() {
  int status = 0;
  rusage used{};
  const pid_t gone = await_end(&status, &used);
  read_printed();
  const std::string printed = printed_text_;
  if (gone != pid_) {
    return stopped("garbage", "closed its output without an answer" + last_words(printed));
  }
  pid_ = -1;
  kill();
  const auto kibibytes = static_cast<std::uint64_t>(used.ru_maxrss);
  const MethodFault fault = fault_of_end(status, kibibytes, spec_.megabytes, printed);
  return {fault.name(), fault.what()};
}

}  // namespace ccdfuzz
