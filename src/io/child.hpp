#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/result.hpp"
#include "io/descriptor.hpp"

namespace ccdfuzz {

/// The failure of a process that did not answer.
struct Fault {
  /// One of a few, so that faults can be counted by it: "crash SIGSEGV", "exit 3", "hang",
  /// "memory", "output", "garbage", …
  std::string name;
  std::string note;  ///< for people

  /// As a process tells it that can.
  static void fields(auto& archive, auto& fault) {
    archive("fault", fault.name);
    archive("message", fault.note);
  }
};

/// The limits of a child.
struct ChildLimits {
  double seconds = 2;  ///< wall time from a question to its answer
  /// CPU time of the same, which a served child limits by itself (serve_lines). 0: no limit.
  double cpu_seconds = 0;
  std::uint64_t megabytes = 1024;  ///< address space; 0: no limit
  std::size_t reply_bytes = 64 << 10;
};

/// The program of a child, and its limits.
struct ChildProgram {
  /// {"run", PROGRAM, arguments…}, or {"load", LIBRARY}, which is a plug-in's.
  std::vector<std::string> command;
  ChildLimits limits;
  int inherited = -1;  ///< a descriptor of this process, which it has as kInherited; -1: none
  /// Once it is true, what has taken kPatience is ended, as the fault "interrupted".
  const std::atomic<bool>* interrupted = nullptr;

  static constexpr int kInherited = 3;
  static constexpr double kPatience = 0.5;  // s
};

/// A process that answers lines with lines, started by exec, so that any thread may ask one. It has
/// a process group of its own and limited memory. It and all that it has started die with us,
/// unless it kills both processes that watch over it (supervise.hpp). Every question ends, with its
/// answer or with what it did instead. For one thread at a time.
class Child {
 public:
  explicit Child(ChildProgram program) : program_(std::move(program)) {}
  ~Child() { kill(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool runs() const { return pid_ > 0; }
  /// It runs and has answered before.
  bool has_answered() const { return has_answered_; }
  /// Sends the line (without its end) and waits for one in return. It is started when it is first
  /// asked, and anew after a fault. A line that it wrote before it was asked is taken as that one:
  /// what it says will not fit. If this process ignores SIGCHLD, it does so no more. Errors: throws
  /// NoProcess where the system refuses one, or the program that starts children is not there.
  /// least_seconds: it has so long at least, whatever its limit.
  tl::expected<std::string, Fault> ask(const std::string& line, double least_seconds = 0);
  /// From now on this is ChildProgram::interrupted.
  void heed(const std::atomic<bool>* interrupted) { program_.interrupted = interrupted; }
  /// Ends it, at once and for sure.
  void kill();

 private:
  using Clock = std::chrono::steady_clock;

  void start();
  tl::expected<std::string, Fault> await_reply(const std::string& question, double seconds);
  bool is_dead() const;
  tl::unexpected<Fault> ended();
  pid_t await_end(Clock::duration most, int* status) const;
  tl::unexpected<Fault> stopped(const std::string& name, const std::string& note);
  bool read_reply();
  bool read_printed();

  ChildProgram program_;
  pid_t pid_ = -1;
  bool has_answered_ = false;
  Descriptor questions_, replies_, printed_;
  std::string reply_;  ///< received and not yet taken
  /// The beginning and the end of what it wrote to stderr since its last answer or its start.
  std::string printed_text_;
  std::size_t printed_bytes_ = 0;  ///< of all of that
};

/// The path of the program that this process runs, also where /proc is missing.
std::string this_program();

/// A program that ccdfuzz comes with: $VARIABLE, or `name` beside this program, or where it was
/// built or installed. Errors: none of them is there.
Result<std::string> find_program(const char* name, const char* variable);

/// The program that starts every child and loads plug-ins: $CCDFUZZ_PLUGIN_WORKER,
/// ccdfuzz-plugin-worker.
Result<std::string> find_worker_program();

}  // namespace ccdfuzz
