#pragma once

#include <string>
#include <vector>

#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// The command that shows the failure again.
std::string command_of(const Find& find);

/// The most convincing first: those that break a claim, then false negatives, then by setting, the
/// deepest first.
std::vector<const Find*> new_finds(const HuntReport& report, bool stored);

/// Prints one line for the finds of one method that differ in the class of their contact alone. It
/// names the file of the first, and the classes of the others.
void print_finds(const std::vector<const Find*>& finds, const std::string& folder);

}  // namespace ccdfuzz
