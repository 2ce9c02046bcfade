#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/case_files.hpp"
#include "case/judge.hpp"

namespace ccdfuzz {

/// Puts the query of an entry to a method and judges. Errors: a method that there is not.
using AskFunction =
    std::function<Result<Judged>(const std::string& method, const NamedCase& entry)>;

/// One expectation of one entry, judged again.
struct ReplayRow {
  std::string id;  ///< of the entry
  std::string method;
  Outcome expected = Outcome::kUnknown;
  Judged got;

  bool changed() const { return got.outcome != expected; }
};

struct ReplayReport {
  std::vector<ReplayRow> rows;  ///< in the order of the entries, then of the methods' names
  size_t entries = 0;
  size_t without_expectation = 0;  ///< entries among them that say nothing to replay

  size_t changed() const;
};

/// "id: method: expected missed, got correct".
std::string to_text(const ReplayRow& row);

/// Judges every entry by every method that it has an expectation of. Every change counts, one for
/// the better too: an expectation is to be corrected in the open.
/// Errors: no entries; an error of `ask_method`, naming the entry and the method.
Result<ReplayReport> replay(const std::vector<NamedCase>& entries, const AskFunction& ask_method);

/// The same, on the entries of a corpus. Errors: as load_corpus, too.
Result<ReplayReport> replay(const std::string& corpus, const AskFunction& ask_method);

}  // namespace ccdfuzz
