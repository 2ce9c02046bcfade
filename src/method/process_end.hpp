#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <string>

#include "method/method.hpp"

namespace ccdfuzz {

/// Has the system tell how children end: where SIGCHLD is ignored, which exec hands on, nobody can
/// ask. A handler stays.
void let_ends_be_known();

/// What a process did that ended in place of answering, by how it ended (waitpid) and the memory it
/// used: "crash SIGSEGV", "exit 3", or "memory", since running out of it shows as many things. What
/// it printed ends the note.
MethodFault fault_of_end(int status, std::uint64_t kibibytes_used, std::uint64_t megabytes_allowed,
                         const std::string& printed);

/// So much of the end of what a process printed is kept.
inline constexpr std::size_t kKeptPrintedBytes = 300;

/// "; it printed: …", on one line; "" of nothing.
std::string last_words(std::string printed);

}  // namespace ccdfuzz
