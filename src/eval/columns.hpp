#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "io/table.hpp"

namespace ccdfuzz {

/// A column of a table of rows.
template <class Row>
struct Column {
  std::string title;
  std::function<TableCell(const Row&)> cell;
  Align align = Align::kRight;
  size_t least_width = 0, most_width = 0;  ///< as in Table::Column
};

/// A table with a row for each of `rows`. A group ends where same_group(row, next) is false.
template <class Row, class SameGroup>
Table table_of(const std::vector<Row>& rows, const std::vector<Column<Row>>& columns,
               const SameGroup& same_group) {
  std::vector<Table::Column> heads;
  for (const Column<Row>& column : columns)
    heads.push_back({column.title, column.align, column.least_width, column.most_width});
  Table table(std::move(heads));
  for (size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && !same_group(rows[i - 1], rows[i])) table.start_group();
    std::vector<TableCell> cells;
    for (const Column<Row>& column : columns) cells.push_back(column.cell(rows[i]));
    table.add_row(std::move(cells));
  }
  return table;
}

}  // namespace ccdfuzz
