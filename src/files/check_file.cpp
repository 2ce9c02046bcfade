#include "files/check_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "certify/checker/check_case.hpp"
#include "certify/checker/work_done.hpp"

namespace ccdfuzz {

namespace {

struct Spent {
  std::optional<std::uint64_t> most;
  std::uint64_t all = 0, cases = 0, of_last = 0;
  SourceBytes source;
  std::string last;
} spent;

/// As check_case of the next case of a run, and RunWork::add.
Result<void> check_in_run(const NamedCase& named) {
  const std::uint64_t before = work_done_here();
  const auto checked = check_case(named);
  const Result<void> within = RunWork::add(named, work_done_here() - before);
  if (!within || checked) return within;
  return tl::unexpected(checked.error());
}

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
  return input_error(named.id,
                     "checking the cases up to this one takes more than {} operations on 64-bit "
                     "words, the limit of a run; --max-work N sets another",
                     most);
}

Result<CheckedCase> check_case(const NamedCase& named) {
  auto checked = check_case(named.value);
  if (checked) return checked;
  InputError error = checked.error();
  error.where = fmt::format("{}: {}", named.id, error.where);
  return tl::unexpected(std::move(error));
}

Result<std::optional<NamedCase>> next_checked(CaseStream& cases) {
  CCDFUZZ_TRY(auto next, cases.next());
  if (next) CCDFUZZ_TRY_VOID(check_in_run(*next));
  return next;
}

Result<NamedCase> read_checked_case(const std::string& path) {
  CCDFUZZ_TRY(auto named, read_case(path));
  return check_in_run(named).map([&] { return std::move(named); });
}

}  // namespace ccdfuzz
