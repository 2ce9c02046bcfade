#pragma once

#include <string>

#include "io/fields.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// If the path is the standard output, what is printed from now on goes to stderr: it is no part of
/// what is written there.
void leave_stdout_to(const std::string& path);

/// Writes text to stdout. A failure (a full disk, /dev/full) is remembered for flush_stdout. Names
/// of files, methods and cases may hold what a terminal obeys: control characters but newlines are
/// shown (shown_lines).
void print_out(const std::string& text);

/// The same of a table, in colour where that is wanted.
void print_table(const Table& table);

/// For a table of any length: prints its rows so far and forgets them, once there are `least`.
/// Columns are then as wide as so many rows need.
void print_rows(Table& table, size_t least = 0);

/// Writes text to stderr, control characters shown. Where that fails there is nobody to tell.
void print_err(const std::string& text);

/// One JSON object on a line of its own: a record, or what a function of an archive names.
template <class Row>
void print_row(const Row& row) {
  print_out(to_json(row) + "\n");
}

/// Errors: something that was printed did not reach its destination.
Result<void> flush_stdout();

}  // namespace ccdfuzz
