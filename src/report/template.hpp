#pragma once

#include <string_view>

namespace ccdfuzz {

/// Where the data of a report go in its page.
inline constexpr std::string_view kReportDataMark = "<!--ccdfuzz:data-->";

/// The page without data: web/dist/report.html as it was when this was built, viewer, plots and
/// their libraries included. Holds kReportDataMark once.
std::string_view report_template();

}  // namespace ccdfuzz
