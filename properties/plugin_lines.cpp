#include <fmt/format.h>

#include <cmath>

#include "method/plugin/line_protocol.hpp"
#include "properties/draw_word.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// A line that is almost what a plug-in should answer.
std::string draw_line(Draw& choices) {
  constexpr const char* kWords = R"(
      "id":7 "verdict":"hit" "verdict":"miss" "toi":0.5 "toi":[0.25,0.5] "toi":NaN "toi":-1
      "toi":"inf" "uv":[[0,1],[0.5,null]] "uv":[[NaN]] "tolerance":1e-6 "tolerance":"inf"
      "tolerance":"small" "iterations":1e300 "seconds":-1 "protocol":1 "name":"x" "refused":1
      "fault":"hang" "minimum_separation":-0
      "accepts":[[{"shape":"curve","max_degree":99},{"shape":"point"}]]
      "accepts":[[{"shape":"triangle","max_degree":2},{"shape":"tensor"}]] "message":"\"NaN)";
  constexpr std::array kStarts = {R"({"id":7)", R"({"protocol":1)", R"({"id":7,"verdict":"hit")"};
  std::string line = choices.pick(kStarts);
  for (std::uint64_t left = choices.choose(6); left > 0; --left) {
    line += "," + draw_word(choices, kWords);
  }
  return line + "}";
}

/// Any line as the answer of a plug-in: a fault with a name, or a sensible answer.
void check_line(Draw& d) {
  constexpr std::size_t kLongest = 1 << 12;
  constexpr std::uint64_t kQuestion = 7;
  const double t_max = show(d, "t_max", d.coin() ? std::abs(d.finite_double()) : 0.25);
  const std::string line = d.coin() ? draw_line(d) : d.text(kLongest);
  show(d, "line", AsHex{line});
  for (const auto& [word, meant] :
       {std::pair("miss", Verdict::kMiss), std::pair("inconclusive", Verdict::kUndecided),
        std::pair("refused", Verdict::kRefused)}) {
    const auto said =
        read_answer(fmt::format(R"({{"id":7,"verdict":"{}"}})", word), kQuestion, t_max);
    CLAIM(said && said->answer.verdict == meant);
  }
  if (const auto described = read_description(line)) {
    for (const double claimed : {described->tolerance, described->minimum_separation}) {
      CLAIM(claimed >= 0 && std::isfinite(claimed));
    }
    for (const Domain::Pair& pair : described->domain.pairs) {
      for (const Domain::Side& side : pair) CLAIM(side.max_degree <= kMaxDegree);
    }
  }
  const auto read = read_answer(line, kQuestion, t_max);
  CLAIM(read || !read.error().name.empty());
  if (!read || read->answer.verdict != Verdict::kHit) return;
  const Answer& answer = read->answer;
  CLAIM(answer.toi && 0 <= *answer.toi && *answer.toi <= t_max);
  for (const Uv<double>& uv : answer.uv) CLAIM(std::isfinite(uv[0]) && std::isfinite(uv[1]));
  CLAIM(read->agrees_with(*read));
}

}  // namespace

std::vector<Property> plugin_lines_claims() {
  return {
      {"plugin.any_line", "Any line of a plug-in is a fault with a name, or a sensible answer",
       "src/method/plugin/line_protocol.hpp", check_line},
  };
}

}  // namespace ccdfuzz
