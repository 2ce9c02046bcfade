#pragma once

#include <vector>

#include "eval/rows.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// Everything that is known of each row of by_kinds.
Table performance_table(const std::vector<Row>& rows);

/// The same of each row of by_methods; what no method has is left out.
Table methods_table(const std::vector<Row>& rows);

/// Mean times, false positives and false negatives (missed: the paper's only sort) beside the
/// paper's. Positives asked beyond the contact do not count. Table 1: regular and grazing cases
/// as one, where the answers are to both; empty otherwise. Table 2: regular, then grazing cases.
/// Table 3: linear queries.
Table paper_table_1(const Rows& rows);
Table paper_table_2(const Rows& rows);
Table paper_table_3(const Rows& rows);

}  // namespace ccdfuzz
