#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace ccdfuzz {

/// One way in which the sources could be wrong.
struct PlantedFault {
  std::string name;        ///< unique
  std::string what;        ///< in words
  std::string file;        ///< from the top of the sources
  bool statement = false;  ///< `from` is a statement, else an expression
  std::string from;        ///< the right text, once in its file
  std::string to;          ///< the wrong one
  std::string equivalent;  ///< why nothing can tell the two apart; empty if something can
};

/// Reads faults.txt, in which each fault is a paragraph of lines "key: text". The keys are
/// fault, what, file, expr or stmt (the right text), to (the wrong one), equivalent (optional).
/// Lines that begin with # are for readers. The number of a fault is its place, from 1.
/// Errors: of the file, an unknown or missing key, a name given twice; naming the line.
Result<std::vector<PlantedFault>> read_faults(const std::string& path);

}  // namespace ccdfuzz
