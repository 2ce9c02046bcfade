#include "method/method_apart.hpp"

#include <algorithm>
#include <cstring>
#include <system_error>
#include <type_traits>

#include "base/verify.hpp"
#include "case/case_json.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz {

namespace {

/// Of its CPU time; ApartLimits says why.
constexpr double kShareTold = 1.0 / 6;

/// What a method said, but for the texts, which follow: the note of the answer; the name and the
/// note of a broken claim.
struct SaidApart {
  Verdict verdict = Verdict::kUndecided;
  std::optional<double> toi;
  std::array<Uv<double>, 2> uv{};
  std::uint64_t pops = 0, bytes = 0;
  double seconds = 0;
  AnswerTerms terms;
  bool has_broken_claim = false;
  std::array<std::size_t, 3> text_sizes{};
};
static_assert(std::is_trivially_copyable_v<SaidApart>);

std::string question_of(const Query& query, const SearchOptions& options) {
  static_assert(std::is_trivially_copyable_v<SearchOptions>);
  std::string question(sizeof options, '\0');
  std::memcpy(question.data(), &options, sizeof options);
  return question + to_json(Case{query, {}, {}, {}});
}

std::string ask_and_write(Method& method, const std::string& question) {
  SearchOptions options;
  CCDFUZZ_VERIFY(question.size() >= sizeof options);
  std::memcpy(&options, question.data(), sizeof options);
  const std::string_view json = std::string_view(question).substr(sizeof options);
  const Answered a = method.answer(parse_case(json, "question").value().query, options);
  const std::optional<MethodFault>& broken = a.broken_claim;
  const std::array<std::string, 3> texts = {a.note, broken ? broken->name() : "",
                                            broken ? broken->what() : ""};
  SaidApart said{a.verdict, a.toi, a.uv, a.pops, a.bytes, a.seconds, a.terms, broken.has_value()};
  for (std::size_t i = 0; i < texts.size(); ++i) said.text_sizes[i] = texts[i].size();
  std::string written(sizeof said, '\0');
  std::memcpy(written.data(), &said, sizeof said);
  for (const std::string& text : texts) written += text;
  return written;
}

class MethodApart : public Method {
 public:
  MethodApart(std::unique_ptr<Method> method, const ApartLimits& limits)
      : method_(std::move(method)),
        process_([this](const std::string& question) { return ask_and_write(*method_, question); },
                 limits),
        most_seconds_(kShareTold * limits.cpu_seconds) {}

  Answered answer(const Query& query, const SearchOptions& options) override {
    SearchOptions told = options;
    told.max_seconds = std::min(told.max_seconds, most_seconds_);
    if (!is_taken(query, options)) return {refusal(query, options)};  // a case file holds no NaN
    try {
      const auto written = process_.ask(question_of(query, told));
      if (!written) throw MethodFault(written.error());
      return read(*written);
    } catch (const std::system_error& refused) {
      Answered none;  // that is no fault of the method
      none.note = refused.what();
      return none;
    }
  }

  bool runs_elsewhere() const override { return true; }

 private:
  static Answered read(const std::string& written) {
    SaidApart said;
    CCDFUZZ_VERIFY(written.size() >= sizeof said);
    std::memcpy(&said, written.data(), sizeof said);
    std::array<std::string, 3> texts;
    std::size_t at = sizeof said;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      texts[i] = written.substr(std::min(at, written.size()), said.text_sizes[i]);
      at += texts[i].size();
    }
    Answered answer{
        {said.verdict, said.toi, said.uv, said.pops, said.bytes, said.seconds, texts[0]},
        said.terms};
    if (said.has_broken_claim) answer.broken_claim.emplace(texts[1], texts[2]);
    return answer;
  }

  std::unique_ptr<Method> method_;
  ProcessApart process_;
  double most_seconds_;
};

}  // namespace

std::unique_ptr<Method> asked_apart(std::unique_ptr<Method> method, const ApartLimits& limits) {
  if (method->runs_elsewhere()) return method;
  return std::make_unique<MethodApart>(std::move(method), limits);
}

Result<std::unique_ptr<Method>> make_method_apart(const std::string& spec) {
  return make_method(spec).map([](auto method) { return asked_apart(std::move(method)); });
}

}  // namespace ccdfuzz
