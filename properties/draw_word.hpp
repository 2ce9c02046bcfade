#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// One of the words of a text, which white space separates.
inline std::string draw_word(Draw& choices, const char* words) {
  std::istringstream text(words);
  const std::vector<std::string> all{std::istream_iterator<std::string>(text), {}};
  return all[choices.below(all.size())];
}

}  // namespace ccdfuzz
