#pragma once

#include <functional>
#include <string>
#include <vector>

#include "query/answer.hpp"
#include "query/case_files.hpp"

namespace ccdfuzz {

/// Answers the query of an entry by a method. Errors: a method that there is not.
using AnswerFunction = std::function<Result<Answer>(const std::string& method, const Case& entry)>;

/// One expectation of one entry, judged again.
struct ReplayRow {
  std::string id;  ///< of the entry
  std::string method;
  Outcome expected = Outcome::kUnknown;
  Outcome got = Outcome::kUnknown;
  Answer answer;

  bool changed() const { return got != expected; }
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
/// Errors: no entries; an error of `answer`, naming the entry and the method.
Result<ReplayReport> replay(const std::vector<NamedCase>& entries, const AnswerFunction& answer);

/// The same, on the entries of a corpus. Errors: as load_corpus, too.
Result<ReplayReport> replay(const std::string& corpus, const AnswerFunction& answer);

}  // namespace ccdfuzz
