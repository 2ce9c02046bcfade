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

void RoundedNumbers::add(const Case& value) {
  const auto of_query = value.origin.more.find("rounded");
  if (of_query == value.origin.more.end()) return;
  ++queries;
  numbers += parse_whole("", of_query->second).value_or(0);
}

int Session::end_early(std::uint64_t done, const char* unit, const std::string& what_follows) {
  remark("interrupted after {} {}{}{}", done, unit, what_follows.empty() ? "" : "; ", what_follows);
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
