#include "files/check_file.hpp"

#include <fmt/format.h>

#include "certify/checker/check_case.hpp"
#include "certify/checker/work_done.hpp"
#include "files/run_work.hpp"
#include "files/tree_file.hpp"

namespace ccdfuzz {

namespace {

/// As check_case of the next case of a run, and RunWork::add.
Result<void> check_in_run(const NamedCase& named) {
  const std::uint64_t before = work_done_here();
  const auto checked = check_case(named);
  const Result<void> within = RunWork::add(named, work_done_here() - before);
  if (!within || checked) return within;
  return tl::unexpected(checked.error());
}

}  // namespace

Result<CheckedCase> check_with_trees(Case value, const std::string& trees) {
  CCDFUZZ_TRY(const auto tree, tree_of(value.truth, trees));
  return check_case(std::move(value), tree);
}

Result<CheckedCase> check_case(const NamedCase& named) {
  auto checked = check_with_trees(named.value, named.file.empty() ? "" : trees_path(named.file));
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

Result<void> for_each_checked_case(const std::vector<std::string>& paths,
                                   const std::function<Result<void>(const NamedCase&)>& visit) {
  CaseStream cases(paths);
  for (;;) {
    CCDFUZZ_TRY(const auto next, next_checked(cases));
    if (!next) return {};
    CCDFUZZ_TRY_VOID(visit(*next));
  }
}

Result<NamedCase> read_checked_case(const std::string& path) {
  CCDFUZZ_TRY(auto named, read_case(path));
  return check_in_run(named).map([&] { return std::move(named); });
}

}  // namespace ccdfuzz
