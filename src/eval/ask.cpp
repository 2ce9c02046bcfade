#include "eval/ask.hpp"

#include <exception>

#include "numeric/verify.hpp"
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

Method& MethodSet::operator[](const std::string& spec) {
  std::unique_ptr<Method>& method = methods_[spec];
  if (!method) {
    Result<std::unique_ptr<Method>> made = make_method(spec);
    CCDFUZZ_VERIFY(made.has_value());
    method = std::move(*made);
  }
  return *method;
}

}  // namespace ccdfuzz
