#pragma once

#include <map>
#include <memory>
#include <string>

#include "method/method.hpp"
#include "query/case.hpp"

namespace ccdfuzz {

/// An answer and how it stands against its truth.
struct Judged {
  Answer answer;
  Outcome outcome = Outcome::kUnknown;
};

/// Puts the query of a case to a method and judges the answer. A method that throws has the outcome
/// error, with what it threw as the note, and undecided as the verdict.
Judged ask(Method& method, const Case& known, const SearchOptions& options);

/// One method object for each spec, made when first asked for; for one thread.
class MethodSet {
 public:
  /// Requires a spec that parse_method_list accepted.
  Method& operator[](const std::string& spec);

 private:
  std::map<std::string, std::unique_ptr<Method>> methods_;
};

}  // namespace ccdfuzz
