#include "case/outcome.hpp"

namespace ccdfuzz {

std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCorrect:
      return "correct";
    case Outcome::kMissed:
      return "missed";
    case Outcome::kLate:
      return "late";
    case Outcome::kFalsePositive:
      return "false_positive";
    case Outcome::kUndecided:
      return "undecided";
    case Outcome::kUnknown:
      return "unknown";
    case Outcome::kError:
      return "error";
    case Outcome::kNotAsked:
      return "not_asked";
  }
  return "?";
}

}  // namespace ccdfuzz
