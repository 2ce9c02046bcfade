#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/report.hpp"

namespace ccdfuzz {

/// Every table that the page has, as CSV for programs: pairs of file name and text.
std::vector<std::pair<std::string, std::string>> page_csvs(const ReportPage& report);

/// The file names that page_csvs gives for one page or another.
std::vector<std::string> all_page_csv_names();

}  // namespace ccdfuzz
