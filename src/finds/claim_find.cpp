#include "finds/claim_find.hpp"

#include <algorithm>

#include "io/hash_name.hpp"

namespace ccdfuzz {

ClaimFind::ClaimFind(const Property& of, std::string ended_in, std::string first_text,
                     std::string first_command)
    : property(of.name),
      claim(of.claim),
      method(of.method),
      error(std::move(ended_in)),
      found(std::move(first_text)),
      as_found(std::move(first_command)) {}

void ClaimFind::set_least(const Counterexample& least) {
  // A hang is never shrunk further.
  shrunk = least.is_cut_short && error != "hang" ? Shrunk::kCutShort : Shrunk::kToTheEnd;
  choices = least.numbers;
  text = least.check.text;
}

std::string ClaimFind::stem() const {
  std::string name = error.empty() ? property : property + "-" + error;
  if (!method.empty()) name += "-" + method;
  for (const char other : {' ', '/', ':'}) std::ranges::replace(name, other, '-');
  constexpr std::size_t kLongest = 200;  // a file's name may have 255 bytes
  return name.size() <= kLongest ? name : name.substr(0, kLongest / 2) + "-" + hash_name(name);
}

bool ClaimFind::replaces(const ClaimFind& other) const {
  if (shrunk != other.shrunk) return shrunk > other.shrunk;
  return shrunk == Shrunk::kNot || simpler(choices, other.choices);
}

}  // namespace ccdfuzz
