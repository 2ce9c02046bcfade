#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "method/method.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

/// What a process may use that works in place of this one.
struct ApartLimits {
  /// CPU time of one answer, of which a method is told a sixth as its max_seconds: what looks at
  /// the clock (Deadline) ends long before. What counts and does not look (oracle) takes less than
  /// a second on what fuzzers make.
  double cpu_seconds = 30;
  std::uint64_t megabytes = PluginSpec().megabytes;  ///< beyond those of this process
};

/// Work done in a copy of this process, made when something is first asked and again after each
/// fault. What it prints nobody sees. It ends with this object, or with this process.
class ProcessApart {
 public:
  /// Gives an answer to a question; what it changes is changed in the copy.
  using Work = std::function<std::string(const std::string& question)>;

  explicit ProcessApart(Work work, const ApartLimits& limits = {})
      : work_(std::move(work)), limits_(limits) {}
  ~ProcessApart() { end(); }
  ProcessApart(const ProcessApart&) = delete;
  ProcessApart& operator=(const ProcessApart&) = delete;

  /// The answer, or what the copy did in place of it, by the names that plug-ins have it by:
  /// "hang", "memory", "crash SIGSEGV", "exit 3", "exception", or the name of the MethodFault that
  /// the work throws; its last words end the note. A copy that has answered before is not accused:
  /// a new one is asked. Requires that this process has no other thread, which might hold a lock
  /// that would be held in the copy for ever, and be told as a hang. Errors: throws
  /// std::system_error where the system refuses a process.
  tl::expected<std::string, MethodFault> ask(const std::string& question);

 private:
  void start();
  void end();
  [[noreturn]] void serve(int channel) const;
  tl::expected<std::string, MethodFault> ask_this_one(const std::string& question);
  MethodFault fault_instead(bool is_late);

  Work work_;
  ApartLimits limits_;
  pid_t pid_ = -1;    ///< of a copy that has answered, between questions
  int channel_ = -1;  ///< questions and replies
  int printed_ = -1;  ///< a file in memory
  std::uint64_t kibibytes_at_first_ = 0;
};

/// Asks once.
tl::expected<std::string, MethodFault> work_apart(const std::function<std::string()>& work,
                                                  const ApartLimits& limits = {});

}  // namespace ccdfuzz
