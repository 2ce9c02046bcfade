#include "files/run_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "files/case_files.hpp"

namespace ccdfuzz {

namespace {

struct Spent {
  std::optional<std::uint64_t> most;
  std::uint64_t all = 0, cases = 0, of_last = 0;
  SourceBytes source;
  std::string last;
} spent;

}  // namespace

void RunWork::allow(std::uint64_t most) {
  spent.most = most;
}

Result<void> RunWork::add(const NamedCase& named, std::uint64_t work) {
  if (named.id != spent.last) {
    spent.last = named.id;
    spent.of_last = 0;
    ++spent.cases;
    spent.source.add(named);
  }
  if (work > spent.of_last) {
    spent.all += work - spent.of_last;
    spent.of_last = work;
  }
  const std::uint64_t by_size = std::min(spent.cases * kEachCase, spent.source.times(kEachByte));
  const std::uint64_t most = spent.most.value_or(kStart + by_size);
  if (spent.all <= most) return {};
  return input_error(
      named.id,
      fmt::format("checking the cases up to this one takes more than {} operations on 64-bit "
                  "words, the limit of a run; --max-work N sets another",
                  most));
}

}  // namespace ccdfuzz
