#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hunt/triage.hpp"
#include "method/method_set.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// What a program serves.
struct Served {
  std::vector<Property> claims = {};
  MethodSet::Make make = make_method;
  std::function<std::string(const std::string& question)> errand = served_errand;
};

/// For `PROGRAM serve [--cpu-seconds S] METHOD | --claims | --triage` serves until stdin ends,
/// and does not return: a method by the line protocol, the others as served_check and
/// served_errand. For any other arguments returns, and from then on the children of this process
/// are its program.
void serve_if_asked(int argc, char** argv, const Served& served);

}  // namespace ccdfuzz
