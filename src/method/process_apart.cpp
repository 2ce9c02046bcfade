#include "method/process_apart.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <system_error>

#include "method/process_end.hpp"
#include "method/process_limits.hpp"

namespace ccdfuzz {

namespace {

/// In wall time an answer gets so many times its CPU time. What waits for something that does not
/// come uses none; and what gets less than a tenth of a core is not told from it.
constexpr double kWallPerCpu = 10;

/// Signals by which what crashes ends, unless a handler (a sanitizer's, say) makes something else
/// of them; and the one of the timer.
constexpr std::array kFatalSignals = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                      SIGABRT, SIGTRAP, SIGSYS, SIGPROF};

[[noreturn]] void refused_apart(const char* what) {
  throw std::system_error(errno, std::generic_category(), fmt::format("cannot {}", what));
}

/// What this process has of memory, in bytes.
struct MemoryInUse {
  std::uint64_t address_space = 0;
  std::uint64_t copied = 0;  ///< what a copy of this process begins with: not what files hold

  static MemoryInUse now() {
    FILE* const file = std::fopen("/proc/self/statm", "re");
    if (file == nullptr) refused_apart("read /proc/self/statm");
    std::array<unsigned long, 3> pages{};  // all, resident, of those shared with files
    const int read = std::fscanf(file, "%lu %lu %lu", &pages[0], &pages[1], &pages[2]);
    std::fclose(file);
    if (read != 3) refused_apart("read /proc/self/statm");
    const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return {pages[0] * page, (pages[1] - pages[2]) * page};
  }
};

/// What goes through the channel: this, and then the text. That of a fault is its name, '\0' and
/// its note.
struct MessageHead {
  std::uint64_t length = 0;
  bool is_fault = false;
};

struct Message {
  MessageHead head;
  std::string text;

  static Message with(std::string text) { return {{text.size(), false}, std::move(text)}; }
  static Message fault(const std::string& name, const std::string& note) {
    Message message = with(name + '\0' + note);
    message.head.is_fault = true;
    return message;
  }
  MethodFault as_fault() const {
    const std::size_t end = std::min(text.find('\0'), text.size());
    return {text.substr(0, end), end < text.size() ? text.substr(end + 1) : ""};
  }
};

/// False: nobody reads it.
bool send_message(int channel, const Message& message) {
  std::string bytes(sizeof message.head, '\0');
  std::memcpy(bytes.data(), &message.head, sizeof message.head);
  bytes += message.text;
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::send(channel, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (n < 0 && errno != EINTR) return false;
    done += n < 0 ? 0 : static_cast<std::size_t>(n);
  }
  return true;
}

struct Received {
  std::optional<Message> message;  ///< absent: it did not come whole
  bool is_late = false;            ///< it might have come later
};

/// Waits for a message, for so long, or for ever if no time is given.
Received receive_message(int channel, std::optional<double> seconds) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(seconds.value_or(0)));
  std::string bytes;
  while (true) {
    int wait = -1;
    if (seconds) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
      wait = static_cast<int>(std::clamp<std::int64_t>(left, 0, 1'000'000));
    }
    pollfd watched{channel, POLLIN, 0};
    const int ready = ::poll(&watched, 1, wait);
    if (ready == 0 && wait == 0) return {std::nullopt, true};
    std::array<char, 4096> buffer;
    const ssize_t n = ready <= 0 ? -1 : ::read(channel, buffer.data(), buffer.size());
    if (ready > 0 && (n == 0 || (n < 0 && errno == ECONNRESET))) return {};
    if (ready != 0 && n < 0 && errno != EINTR) refused_apart("hear of a process");
    if (n > 0) bytes.append(buffer.data(), static_cast<std::size_t>(n));
    MessageHead head;
    if (bytes.size() < sizeof head) continue;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (bytes.size() - sizeof head == head.length) return {{{head, bytes.substr(sizeof head)}}};
  }
}

Message worked(const ProcessApart::Work& work, const std::string& question) {
  try {
    return Message::with(work(question));
  } catch (const MethodFault& fault) {
    return Message::fault(fault.name(), fault.what());
  } catch (const std::bad_alloc&) {
    return Message::fault("memory", "no more memory within its limit");
  } catch (const std::exception& error) {
    return Message::fault("exception", error.what());
  } catch (...) {
    return Message::fault("exception", "something that is no std::exception");
  }
}

/// SIGPROF ends this process once it has used so much more CPU time; 0: it does not any more.
void limit_cpu_seconds(double seconds) {
  double whole = 0;
  const auto micro = static_cast<suseconds_t>(std::modf(seconds, &whole) * 1e6);
  const itimerval once{{0, 0}, {static_cast<time_t>(whole), micro}};
  ::setitimer(ITIMER_PROF, &once, nullptr);
}

std::string end_of_file(int file) {
  const off_t size = ::lseek(file, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(kKeptPrintedBytes));
  std::string text(kKeptPrintedBytes, '\0');
  const ssize_t n = ::pread(file, text.data(), text.size(), from);
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return text;
}

}  // namespace

tl::expected<std::string, MethodFault> ProcessApart::ask(const std::string& question) {
  const bool is_new = pid_ < 0;
  if (is_new) start();
  auto answer = ask_this_one(question);
  if (answer || is_new) return answer;
  start();
  return ask_this_one(question);
}

void ProcessApart::start() {
  end();
  let_ends_be_known();
  const MemoryInUse before = MemoryInUse::now();
  kibibytes_at_first_ = before.copied >> 10;
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    refused_apart("make a socket");
  }
  channel_ = ends[0];
  printed_ = ::memfd_create("printed", MFD_CLOEXEC);
  const pid_t parent = ::getpid();
  if (printed_ >= 0) pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);  // it was gone before that
    ::close(channel_);
    limit_answering_process(before.address_space + (limits_.megabytes << 20));
    serve(ends[1]);
  }
  const int error = errno;
  ::close(ends[1]);
  if (pid_ > 0) return;
  end();
  errno = error;
  refused_apart("start a process");
}

/// What the copy does, all of it. It leaves without flushing or destroying what is not its own.
void ProcessApart::serve(int channel) const {
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(printed_, output);
  for (const int signal : kFatalSignals) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  while (true) {
    const Received question = receive_message(channel, std::nullopt);
    if (!question.message) ::_exit(0);
    limit_cpu_seconds(limits_.cpu_seconds);
    const Message answer = worked(work_, question.message->text);
    limit_cpu_seconds(0);
    if (!send_message(channel, answer)) ::_exit(0);
  }
}

tl::expected<std::string, MethodFault> ProcessApart::ask_this_one(const std::string& question) {
  send_message(channel_, Message::with(question));
  const Received got = receive_message(channel_, kWallPerCpu * limits_.cpu_seconds);
  if (!got.message) return tl::unexpected(fault_instead(got.is_late));
  if (!got.message->head.is_fault) return got.message->text;
  end();
  return tl::unexpected(got.message->as_fault());
}

/// How it ended, or what it did that it must be ended for.
MethodFault ProcessApart::fault_instead(bool is_late) {
  // What has closed the channel without an answer is dead, and how it died stays as it is.
  ::kill(pid_, SIGKILL);
  int status = 0;
  rusage used{};
  while (::wait4(pid_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  const std::string words = end_of_file(printed_);
  end();
  const bool used_its_time = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
  if (is_late || used_its_time) {
    const std::string within = is_late ? fmt::format("{} s", kWallPerCpu * limits_.cpu_seconds)
                                       : fmt::format("{} s of CPU time", limits_.cpu_seconds);
    return {"hang", fmt::format("no answer within {}{}", within, last_words(words))};
  }
  const auto kibibytes = static_cast<std::uint64_t>(used.ru_maxrss);
  const std::uint64_t own = kibibytes - std::min(kibibytes, kibibytes_at_first_);
  return fault_of_end(status, own, limits_.megabytes, words);
}

void ProcessApart::end() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  pid_ = -1;
  for (int* const descriptor : {&channel_, &printed_}) {
    if (*descriptor >= 0) ::close(*descriptor);
    *descriptor = -1;
  }
}

tl::expected<std::string, MethodFault> work_apart(const std::function<std::string()>& work,
                                                  const ApartLimits& limits) {
  return ProcessApart([&](const std::string&) { return work(); }, limits).ask("");
}

}  // namespace ccdfuzz
