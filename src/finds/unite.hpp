#pragma once

#include <functional>
#include <optional>
#include <string>

#include "case/checked_case.hpp"
#include "files/case_files.hpp"

namespace ccdfuzz {

/// The outcome of a method now on a case; nothing where it cannot be asked.
using AskAgain =
    std::function<std::optional<Expected>(const std::string& method, const CheckedCase& known)>;

/// Two entries of one query as one.
struct United {
  Case value;
  std::string trees;  ///< the file with the tree of its truth
};

/// Takes each part of the truths from where it is stronger. That is the earlier contact; and
/// absence of contact by certificate before any by a method's word, or the later of two. The rest
/// is of `old`. `again` is asked about each method on which the entries disagree, or whose outcome
/// was judged by a weaker truth or asked in another way. Without it, or where it does not know, the
/// outcome of `old` stays, and else that of `find`. Requires that both truths were checked. trees:
/// where the tree of find is; empty: without it what a tree proves is left out.
United unite(const NamedCase& old, const Case& find, const std::string& trees,
             const AskAgain& again);

}  // namespace ccdfuzz
