#pragma once

#include <algorithm>

#include "finds/minimise.hpp"
#include "method/ask.hpp"

namespace ccdfuzz {

/// What a case that failed in such a search says of how it was asked: what fails within few pops
/// does so with more.
inline Asked asked_with(const SearchOptions& search) {
  return {search.precision, std::max(search.max_pops, Asked().max_pops)};
}

/// Minimises a case on which a method fails: it fails alike on every simpler one that is taken,
/// with the same outcome and, of an error, the same name. The result expects this failure alone.
/// Of a hang only a few trials are made, since each costs its whole time.
Minimised shrink(const Case& found, const std::string& spec, Method& method, const Judged& failure,
                 const SearchOptions& search, MinimiseOptions options = {});

}  // namespace ccdfuzz
