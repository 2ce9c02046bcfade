#pragma once

#include <memory>

#include "io/child.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

/// The limits of one answer. The wall time is ten times as long as the CPU time: a process that
/// waits for ever uses no CPU time.
inline constexpr ChildLimits kServedLimits = {.seconds = 300, .cpu_seconds = 30};

/// A built-in method that answers in a process of its own, `ccdfuzz serve SPEC`. So its crash or
/// hang is a MethodFault. A child that has answered before is not accused: a new one is asked.
/// Errors: as served_child.
Result<std::unique_ptr<Method>> served_method(const std::string& spec, const ChildLimits& limits);

/// make_method, served. A method that runs elsewhere already stays as it is. Without a max_seconds
/// no clock decides what it answers, but whether it hangs.
Result<std::unique_ptr<Method>> make_served_method(const std::string& spec);

/// What the child answers to a line of the line protocol.
std::string served_answer(const std::string& spec, Method& method, const std::string& question);

}  // namespace ccdfuzz
