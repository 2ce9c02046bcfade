#pragma once

#include <functional>
#include <string>

#include "io/child.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

/// The loop of a child that is a program of ours: answers each line of stdin with a line on stdout
/// until stdin ends. What `work` prints goes to stderr. Where it throws, the answer is a Fault,
/// "memory" or "exception", and the process ends. Where it throws NoProcess, so does whoever asks.
/// A question that takes more CPU time than that, if it is not 0, ends the process by SIGPROF.
[[noreturn]] void serve_lines(const std::function<std::string(const std::string&)>& work,
                              double cpu_seconds);

/// Says that children may be this very program: its main serves them.
void serve_by_this_program();

/// A child that is `ccdfuzz serve ARGUMENTS`, or this program if it serves: $CCDFUZZ_PROGRAM,
/// ccdfuzz. Errors: it is not there.
Result<ChildProgram> served_child(const std::vector<std::string>& arguments,
                                  const ChildLimits& limits);

/// The record that a served child answers with, or what it did instead. One that has answered
/// before is not accused: a new one is asked.
template <HasFields Reply>
tl::expected<Reply, Fault> ask_served(Child& child, const std::string& line) {
  const bool is_new = !child.has_answered();
  const auto once = [&]() -> tl::expected<Reply, Fault> {
    CCDFUZZ_TRY(const auto answer, child.ask(line));
    Result<Reply> reply = from_json<Reply>(answer, "its answer", Unknown::kIgnore);
    if (reply) return *std::move(reply);
    child.kill();
    const Result<Fault> told = from_json<Fault>(answer, "its answer");
    return tl::unexpected(told ? *told : Fault{"garbage", reply.error().message()});
  };
  auto reply = once();
  const bool is_over = reply || is_new || reply.error().name == "interrupted";
  return is_over ? reply : once();
}

}  // namespace ccdfuzz
