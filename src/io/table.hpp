#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ccdfuzz {

enum class Align { kLeft, kRight };

struct TableCell {
  std::string text;
  bool is_bad = false;  ///< red on terminals
};

/// A table of texts: people read it aligned, documents have it as Markdown.
class Table {
 public:
  struct Column {
    std::string title;
    Align align = Align::kRight;
    size_t least_width = 0;  ///< for aligned text
    size_t most_width = 0;   ///< for aligned text: a longer one is "…" and its end; 0: any
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Requires as many cells as columns.
  void add_row(std::vector<TableCell> cells);
  /// The next row starts a new group. In aligned text that is a blank line, unless it is the first
  /// row and has no title, and below it the title. Nothing elsewhere.
  void start_group(const std::string& title = "");

  /// How many rows were added.
  size_t row_count() const { return rows_taken_ + rows_.size(); }

  std::vector<std::string> titles() const;
  /// The cells of the rows.
  std::vector<std::vector<std::string>> texts() const;

  /// Columns two blanks apart, no trailing blanks. Widths count code points, not bytes. Control
  /// characters are shown (shown_line), in Markdown, too. A table wider than kTextWidth is shown in
  /// parts, one below the other, each with the texts to the left that its rows begin with.
  std::string to_text(bool colour) const;
  /// to_text of the rows added since the last call, which are forgotten: for a table of any length.
  /// Columns stay at least as wide as they were. Empty if there are fewer such rows than `least`.
  std::string take_text(bool colour, size_t least);
  std::string to_markdown() const;

 private:
  struct Row {
    std::vector<TableCell> cells;
    std::optional<std::string> group;  ///< the title of the group that it starts
  };
  struct Place {
    size_t column, width;
  };
  /// Which columns a text shows, and how wide each is.
  using Layout = std::vector<Place>;

  std::string header_text(const Layout& layout, bool colour) const;
  std::string row_text(const Row& row, const Layout& layout, bool colour) const;
  std::string cell_text(const Row& row, size_t column) const;
  /// All columns, as wide as the rows need.
  Layout full_layout() const;
  std::vector<Layout> parts() const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
  std::optional<std::string> group_pending_;
  bool header_shown_ = false;
  size_t rows_taken_ = 0;
};

/// A time with three digits in the unit that fits it: "1.23 ms".
std::string duration_text(double seconds);

/// A number of bytes with three digits in the unit that fits it: "1.23 KiB".
std::string size_text(double bytes);

/// "12" or, with a share, "12 (1.2 %)" of a total > 0.
std::string count_text(std::uint64_t count, std::uint64_t total);

}  // namespace ccdfuzz
