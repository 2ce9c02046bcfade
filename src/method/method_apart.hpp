#pragma once

#include <memory>

#include "method/process_apart.hpp"

namespace ccdfuzz {

/// A method that answers in a process of its own (ProcessApart), so that a crash or a hang of it is
/// a MethodFault like any. It is told a sixth of its CPU time as max_seconds, if not less.
/// Undecided, with a note: the system refuses a process. A method that runs elsewhere already stays
/// as it is. Requires valid queries.
std::unique_ptr<Method> asked_apart(std::unique_ptr<Method> method, const ApartLimits& limits = {});

/// make_method, asked apart.
Result<std::unique_ptr<Method>> make_method_apart(const std::string& spec);

}  // namespace ccdfuzz
