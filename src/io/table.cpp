#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "base/verify.hpp"

namespace ccdfuzz {

namespace {

std::string padded(const std::string& text, size_t to, Align align) {
  const std::string blanks(to - std::min(to, width(text)), ' ');
  return align == Align::kLeft ? text + blanks : blanks + text;
}

std::string markdown_field(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// Two blanks between the texts, and none behind the last.
std::string line_of(const std::vector<std::string>& texts) {
  const std::string line = fmt::format("{}", fmt::join(texts, "  "));
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

}  // namespace

void Table::add_row(std::vector<TableCell> cells) {
  CCDFUZZ_VERIFY(cells.size() == columns_.size());
  rows_.push_back({std::move(cells), std::exchange(group_pending_, std::nullopt)});
}

void Table::start_group(const std::string& title) {
  if (row_count() > 0 || !title.empty()) group_pending_ = title;
}

std::vector<std::string> Table::titles() const {
  std::vector<std::string> titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  return titles;
}

std::vector<std::vector<std::string>> Table::texts() const {
  std::vector<std::vector<std::string>> texts;
  for (const Row& row : rows_) {
    std::vector<std::string>& line = texts.emplace_back();
    for (const TableCell& cell : row.cells) line.push_back(cell.text);
  }
  return texts;
}

std::string Table::cell_text(const Row& row, size_t column) const {
  std::string text = shown_line(row.cells[column].text);
  const size_t most = columns_[column].most_width, has = width(text);
  if (most == 0 || has <= most) return text;
  size_t at = 0;
  for (size_t passed = 0; passed <= has - most || continues_character(text[at]); ++at) {
    passed += continues_character(text[at]) ? 0 : 1;
  }
  return "…" + text.substr(at);
}

Table::Layout Table::full_layout() const {
  Layout layout;
  for (size_t c = 0; c < columns_.size(); ++c) {
    size_t needed = std::max(width(columns_[c].title), columns_[c].least_width);
    for (const Row& row : rows_) needed = std::max(needed, width(cell_text(row, c)));
    layout.push_back({c, needed});
  }
  return layout;
}

std::vector<Table::Layout> Table::parts() const {
  Layout keys;
  size_t keys_width = 0, used = 0;
  std::vector<Layout> parts;
  for (const Place& place : full_layout()) {
    const size_t needed = place.width + 2;
    if (parts.empty() && columns_[place.column].align == Align::kLeft) {
      keys.push_back(place);
      keys_width += needed;
      continue;
    }
    if (parts.empty() || used + needed > kTextWidth + 2) {
      parts.push_back(keys);
      used = keys_width;
    }
    parts.back().push_back(place);
    used += needed;
  }
  return parts.empty() ? std::vector<Layout>{keys} : parts;
}

std::string Table::header_text(const Layout& layout, bool colour) const {
  std::vector<std::string> titles;
  for (const auto& [c, wide] : layout) {
    titles.push_back(padded(columns_[c].title, wide, columns_[c].align));
  }
  const std::string header = line_of(titles);
  return colour ? "\x1b[1m" + header + "\x1b[0m\n" : header + "\n";
}

std::string Table::row_text(const Row& row, const Layout& layout, bool colour) const {
  std::vector<std::string> cells;
  for (const auto& [c, wide] : layout) {
    const std::string cell = padded(cell_text(row, c), wide, columns_[c].align);
    cells.push_back(colour && row.cells[c].is_bad ? "\x1b[1;31m" + cell + "\x1b[0m" : cell);
  }
  std::string before;
  if (row.group) before = row.group->empty() ? "\n" : "\n" + shown_lines(*row.group) + "\n";
  return before + line_of(cells) + "\n";
}

std::string Table::to_text(bool colour) const {
  std::string out;
  for (const Layout& part : parts()) {
    out += (out.empty() ? "" : "\n") + header_text(part, colour);
    for (const Row& row : rows_) out += row_text(row, part, colour);
  }
  return out;
}

std::string Table::take_text(bool colour, size_t least) {
  if (rows_.size() < least) return "";
  const Layout layout = full_layout();
  std::string out = header_shown_ ? "" : header_text(layout, colour);
  header_shown_ = true;
  for (const Row& row : rows_) out += row_text(row, layout, colour);
  rows_taken_ += rows_.size();
  rows_.clear();
  for (size_t c = 0; c < columns_.size(); ++c) columns_[c].least_width = layout[c].width;
  return out;
}

std::string Table::to_markdown() const {
  std::string out = "|";
  for (const Column& column : columns_) out += fmt::format(" {} |", markdown_field(column.title));
  out += "\n|";
  for (const Column& column : columns_) out += column.align == Align::kLeft ? ":--|" : "--:|";
  out += "\n";
  for (const Row& row : rows_) {
    out += "|";
    for (const TableCell& cell : row.cells)
      out += fmt::format(" {} |", markdown_field(shown_line(cell.text)));
    out += "\n";
  }
  return out;
}

std::string duration_text(double seconds) {
  constexpr std::array<const char*, 4> units = {"s", "ms", "µs", "ns"};
  if (!(seconds > 0)) return "0 s";
  size_t unit = 0;
  // Rounding to three digits must not carry 999.9 into four: choose the unit after rounding.
  for (; seconds < 0.9995 && unit + 1 < units.size(); ++unit) seconds *= 1000;
  const int decimals = seconds >= 99.95 ? 0 : seconds >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f} {}", seconds, decimals, units[unit]);
}

std::string size_text(double bytes) {
  constexpr std::array<const char*, 4> units = {"B", "KiB", "MiB", "GiB"};
  size_t unit = 0;
  // As for times, the unit is chosen after rounding.
  for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit) bytes /= 1024;
  const int decimals = unit == 0 || bytes >= 99.95 ? 0 : bytes >= 9.995 ? 1 : 2;
  return fmt::format("{:.{}f} {}", bytes, decimals, units[unit]);
}

std::string count_text(std::uint64_t count, std::uint64_t total) {
  if (count == 0 || total == 0) return fmt::format("{}", count);
  const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(total);
  // Two digits below 1 %, so that a count above 0 never reads as 0.0 %.
  return percent >= 1 ? fmt::format("{} ({:.1f} %)", count, percent)
                      : fmt::format("{} ({:.1g} %)", count, percent);
}

}  // namespace ccdfuzz
