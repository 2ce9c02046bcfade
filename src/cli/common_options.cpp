#include "cli/common_options.hpp"

#include <fmt/format.h>

#include <iterator>
#include <thread>

#include "certify/checker/check_truth.hpp"
#include "cli/number_text.hpp"

namespace ccdfuzz {

void SearchFlags::add_to(CLI::App& command) {
  command.add_option("--precision", precision, "Parameter width at which a pair of boxes is a hit")
      ->capture_default_str();
  add_budget_to(command);
}

void SearchFlags::add_budget_to(CLI::App& command) {
  command
      .add_option("--max-pops", max_pops,
                  "Pairs of boxes to look at before a method gives up as undecided")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--max-mb", max_mb, "Memory of a method's queue before it gives up, in MiB")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 20))
      ->capture_default_str();
}

Result<SearchOptions> SearchFlags::parse() const {
  return parse_number("--precision", precision)
      .and_then([this](double width) -> Result<SearchOptions> {
        // 2^-50 is where Cell::kMaxDepth ends.
        if (width < 0x1p-50 || width > 1) {
          return input_error("--precision", fmt::format("{} is not in [2^-50, 1]", precision));
        }
        return SearchOptions{width, max_pops, max_mb << 20};
      });
}

int default_threads() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void add_threads(CLI::App& command, int& threads) {
  threads = default_threads();
  command.add_option("--threads", threads, "Threads to work on; results do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

Result<std::vector<NamedCase>> read_all_checked(const std::vector<std::string>& paths) {
  std::vector<NamedCase> all;
  for (const std::string& path : paths) {
    Result<std::vector<NamedCase>> cases = read_checked_cases(path);
    if (!cases) return cases;
    all.insert(all.end(), std::make_move_iterator(cases->begin()),
               std::make_move_iterator(cases->end()));
  }
  return all;
}

}  // namespace ccdfuzz
