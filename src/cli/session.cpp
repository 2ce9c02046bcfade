#include "cli/session.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"

namespace ccdfuzz {

RunFile resumed_run(const RunHeader& header, const std::string& output, const char* unit) {
  // Whether the result can be written is to be known before the work is done.
  need(OutputFile::create(output));
  const std::string path = RunFile::path_for(output);
  RunFile file = need(RunFile::open(path, header));
  const std::uint64_t before = file.size();
  if (before > 0) {
    print_err(fmt::format("ccdfuzz: {}: going on after {} of {} {} in {}\n", header.run, before,
                          header.shard.size(header.items), unit, path));
  }
  return file;
}

void CaseCount::add(const Case& value) {
  ++cases;
  const Truth& truth = value.truth;
  const bool says_so = truth.collides ? !*truth.collides : truth.clear_until.has_value();
  if (says_so && !truth.clearance) ++by_word;
  const auto& more = value.origin.more;
  if (const auto label = more.find("label"); label != more.end() && truth.collides) {
    ++labels;
    if ((label->second == "1") != *truth.collides) ++wrong_labels;
  }
  if (const auto numbers = more.find("rounded"); numbers != more.end()) {
    ++rounded_queries;
    rounded += parse_whole("", numbers->second).value_or(0);
  }
}

Result<std::optional<NamedCase>> Session::next_case(CaseStream& cases) {
  auto next = next_checked(cases);
  if (next && *next) counts.add((*next)->value);
  return next;
}

void Session::note_rounded() {
  if (counts.rounded_queries == 0) return;
  remark("{} numbers of {} queries are no doubles and were rounded", counts.rounded,
         counts.rounded_queries);
}

void Session::note_truths() {
  if (counts.by_word > 0) {
    remark(
        "{} of {} cases have no contact by the word of a method alone: their outcome is unknown "
        "(`ccdfuzz prove` gives proofs)",
        counts.by_word, counts.cases);
  }
  if (counts.wrong_labels > 0) {
    remark("{} of {} labels are not the truth of what was asked (`ccdfuzz import` lists them)",
           counts.wrong_labels, counts.labels);
  }
}

int Session::end_early(const std::string& what_follows) {
  remark("{}: {}", refused_ ? "no process answers" : "interrupted", what_follows);
  return interrupted_exit_code();
}

int Session::end_early(std::uint64_t done, const char* unit, const std::string& what_follows) {
  remark("{} after {} {}{}{}", refused_ ? "no process answers" : "interrupted", done, unit,
         what_follows.empty() ? "" : "; ", what_follows);
  return interrupted_exit_code();
}

void Session::end_table(bool text_follows) {
  progress_.clear();
  if (!table_) return;
  const bool had_rows = table_->row_count() > 0;
  if (had_rows) print_rows(*table_);
  table_.reset();
  if (had_rows && text_follows) print_out("\n");
}

}  // namespace ccdfuzz
