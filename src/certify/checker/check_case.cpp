#include "certify/checker/check_case.hpp"

#include <fmt/format.h>

#include "case/tree_file.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/run_work.hpp"
#include "certify/checker/shown.hpp"

namespace ccdfuzz {

Result<void> check_absence(const Case& value, const std::string& trees) {
  const Truth& truth = value.truth;
  if (!truth.clearance) return input_error("truth.certificate.clear", "missing");
  const std::string until = shown(until_of(*truth.clearance));
  if (truth.collides == false && !covers(*truth.clearance, exact(value.query.t_max))) {
    return input_error("truth.certificate.clear.until",
                       fmt::format("{} does not reach past t_max = {}", until, value.query.t_max));
  }
  if (truth.clear_until && *truth.clear_until > until_of(*truth.clearance)) {
    return input_error(
        "truth.certificate.clear.until",
        fmt::format("{} is before clear_until = {}", until, shown(*truth.clear_until)));
  }
  std::string bytes;
  if (const auto* tree = std::get_if<MissTree>(&*truth.clearance)) {
    auto read = read_tree(trees, tree->tree);
    if (!read) {
      return input_error("truth.certificate.clear.tree", read.error().message());
    }
    bytes = *std::move(read);
  }
  return check_clearance(value.query, *truth.clearance, bytes);
}

/// The one maker of a CheckedCase that knows something.
class CaseCheck {
 public:
  static Result<CheckedCase> check(Case value, const std::string& trees) {
    if (auto checked = check_truth(value); !checked) return tl::unexpected(checked.error());
    const bool has_clearance = value.truth.clearance.has_value();
    if (has_clearance) {
      if (auto absent = check_absence(value, trees); !absent) {
        return tl::unexpected(absent.error());
      }
    }
    return CheckedCase(std::move(value), has_clearance);
  }

  static CheckedCase unknown(const Case& value) {
    Case bare = value;
    bare.truth = {};
    return {std::move(bare), false};
  }
};

Result<CheckedCase> check_case(Case value, const std::string& trees) {
  return CaseCheck::check(std::move(value), trees);
}

Result<CheckedCase> check_case(const NamedCase& named) {
  auto checked = check_case(named.value, named.file.empty() ? "" : trees_path(named.file));
  if (checked) return checked;
  InputError error = checked.error();
  error.where = fmt::format("{}: {}", named.id, error.where);
  return tl::unexpected(std::move(error));
}

CheckedCase checked_or_unknown(const Case& value, const std::string& trees) {
  auto checked = check_case(value, trees);
  return checked ? *std::move(checked) : CaseCheck::unknown(value);
}

CheckedCase checked_contact(Case value) {
  value.truth.clearance.reset();
  value.truth.clear_until.reset();
  return checked_or_unknown(value);
}

Result<void> check_in_run(const NamedCase& named) {
  const std::uint64_t before = work_done_here();
  const auto checked = check_case(named);
  const Result<void> within = RunWork::add(named, work_done_here() - before);
  if (!within || checked) return within;
  return tl::unexpected(checked.error());
}

Result<void> for_each_checked_case(const std::vector<std::string>& paths,
                                   const std::function<Result<void>(const NamedCase&)>& visit) {
  CaseStream cases(paths);
  for (;;) {
    const auto next = cases.next();
    if (!next) return tl::unexpected(next.error());
    if (!*next) return {};
    if (auto checked = check_in_run(**next); !checked) return checked;
    if (auto visited = visit(**next); !visited) return visited;
  }
}

Result<std::vector<NamedCase>> read_checked_cases(const std::string& path) {
  auto cases = read_cases(path);
  if (!cases) return cases;
  for (const NamedCase& named : *cases) {
    if (auto checked = check_in_run(named); !checked) return tl::unexpected(checked.error());
  }
  return cases;
}

}  // namespace ccdfuzz
