#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <string>
#include <tl/expected.hpp>

#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

/// What a plug-in did that no method may do.
struct PluginFault {
  /// One of a few, so that faults can be told apart and counted: "crash SIGSEGV", "exit 3", "hang",
  /// "memory", "output", "garbage", …
  std::string name;
  std::string note;  ///< for people
};

/// A process that answers lines with lines: the worker that loads a plug-in's library, or a plug-in
/// that is a program. It has a process group of its own, limited memory, and dies with us, with all
/// that it has started, unless it seeks out and kills both processes that watch over it
/// (supervise.hpp). Whatever it does, an exchange ends: with its answer or with what it did
/// instead. For one thread.
class WorkerProcess {
 public:
  explicit WorkerProcess(const PluginSpec& spec) : spec_(spec) {}
  ~WorkerProcess() { kill(); }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  bool runs() const { return pid_ > 0; }
  /// Starts it anew. If this process ignores SIGCHLD, it does so no more. Errors (thrown as
  /// std::runtime_error): the system refuses a process.
  void start();
  /// Ends it, at once and for sure.
  void kill();
  /// Sends the line (without its end) and waits for one in return, at most for `seconds`. A line
  /// that it wrote before it was asked is taken as that one: what it says will not fit. After a
  /// fault it does not run any more. Requires that it runs.
  tl::expected<std::string, PluginFault> exchange(const std::string& line, double seconds);

 private:
  using Clock = std::chrono::steady_clock;

  tl::expected<std::string, PluginFault> await_reply(std::string to_send, Clock::time_point until);
  bool is_dead() const;
  PluginFault ended();
  pid_t await_end(int* status, rusage* used) const;
  PluginFault stopped(const std::string& name, const std::string& note);
  bool read_reply();
  bool read_printed();

  PluginSpec spec_;
  pid_t pid_ = -1;
  int questions_ = -1, replies_ = -1, printed_ = -1;
  std::string reply_;         ///< received and not yet taken
  std::string printed_text_;  ///< the end of what it wrote to stderr
  size_t printed_bytes_ = 0;  ///< since the last question
};

/// The program that loads plug-ins: $CCDFUZZ_PLUGIN_WORKER, or ccdfuzz-plugin-worker beside this
/// program, or where it was built or installed. Errors: none of them is there.
Result<std::string> find_worker_program();

}  // namespace ccdfuzz
