#include "eval/ask.hpp"

#include <exception>

#include "query/judge.hpp"

namespace ccdfuzz {

Judged ask(Method& method, const Case& known, const SearchOptions& options) {
  try {
    Answer answer = method.answer(known.query, options);
    const Outcome outcome = judge(known.query, known.truth, answer);
    return {std::move(answer), outcome};
  } catch (const std::exception& error) {
    Answer answer;
    answer.note = error.what();
    return {std::move(answer), Outcome::kError};
  }
}

}  // namespace ccdfuzz
