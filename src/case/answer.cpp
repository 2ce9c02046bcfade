#include "case/answer.hpp"

namespace ccdfuzz {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kHit:
      return "hit";
    case Verdict::kMiss:
      return "miss";
    case Verdict::kUndecided:
      return "undecided";
    case Verdict::kRefused:
      return "refused";
  }
  return "?";
}

}  // namespace ccdfuzz
