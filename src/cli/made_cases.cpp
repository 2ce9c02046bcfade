#include "cli/made_cases.hpp"

#include <fmt/format.h>

#include "cli/common_options.hpp"

namespace ccdfuzz {

Result<MadeSet> MadeSet::open(const std::string& path) {
  return DataSetWriter::open(path).map(
      [&](DataSetWriter writer) { return MadeSet(std::move(writer), path); });
}

Result<void> MadeSet::add(MadeCases made) {
  add_cost(costs_, made.cost);
  const std::string tree = parse_hex_bytes(made.tree).value();
  for (Case& value : made.cases) {
    ++cases_;
    if (!tree.empty()) {
      value.truth.clearance = MissTree{exact(value.query.t_max), {}};
      value.truth.proof = proof_word(*value.truth.clearance);
      ++trees_;
    }
    CCDFUZZ_TRY_VOID(writer_.write(std::move(value), tree));
  }
  return {};
}

Result<void> MadeSet::finish() {
  return writer_.finish(costs_);
}

void MadeSet::show(Session& session, const std::string& of) const {
  if (session.json) {
    for (const GenerationCost& cost : costs_) print_row(cost);
    return;
  }
  print_table(generation_table(costs_));
  const std::string trees = trees_ == 0 ? "" : ", " + counted(trees_, "miss tree", "miss trees");
  session.summary(
      fmt::format("\n{}{} in {}{}", counted(cases_, "case", "cases"), of, path_, trees));
}

}  // namespace ccdfuzz
