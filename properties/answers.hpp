#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

/// One of these, at times with one of its switches.
inline std::string draw_spec(Draw& d, const std::vector<std::string>& among) {
  const std::string spec = d.pick(among);
  const std::vector<std::string> switches = method_info(spec)->switches;
  return switches.empty() || d.choose(3) != 3 ? spec : spec + '@' + d.pick(switches);
}

/// For failure texts.
inline std::string to_text(const Answer& answer) {
  return fmt::format("{} at {} after {} pops: {}", name_of(answer.verdict), shown(answer.toi),
                     answer.pops, answer.note);
}

inline Answer answer_of(const std::string& spec, const Query& query, const SearchOptions& options) {
  return make_method(spec).value()->answer(query, options);
}

/// What a method answers, which a failure shows with the question.
inline Answer asked(Draw& d, const std::string& spec, const Query& query,
                    const SearchOptions& options) {
  const Answer answer = answer_of(spec, query, options);
  show(d, "query", query);
  show(d, "answer of " + spec, answer);
  return answer;
}

/// The same answer, to the bit.
inline void claim_same(const Answer& a, const Answer& b) {
  CLAIM(a.verdict == b.verdict && a.toi == b.toi && a.uv == b.uv && a.pops == b.pops);
  CLAIM(a.note == b.note);
}

/// Each of the methods has the same answer to both queries, to the bit.
inline void claim_answered_alike(const std::vector<std::string>& methods, const Query& a,
                                 const Query& b, const SearchOptions& options) {
  for (const std::string& name : methods) {
    claim_same(answer_of(name, a, options), answer_of(name, b, options));
  }
}

}  // namespace ccdfuzz
