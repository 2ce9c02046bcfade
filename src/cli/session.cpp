#include "cli/session.hpp"

namespace ccdfuzz {

void Session::end_table(bool text_follows) {
  progress_.clear();
  if (!table_) return;
  const bool had_rows = table_->row_count() > 0;
  if (had_rows) print_last_rows(*table_);
  table_.reset();
  if (had_rows && text_follows) print_out("\n");
}

}  // namespace ccdfuzz
