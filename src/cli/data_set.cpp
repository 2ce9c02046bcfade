#include "cli/data_set.hpp"

namespace ccdfuzz {

void MadeSet::add(MadeCases made) {
  add_cost(costs, made.cost);
  const std::string tree = parse_hex_bytes(made.tree).value();
  for (Case& value : made.cases) {
    if (!tree.empty()) {
      value.truth.clearance = MissTree{exact(value.query.t_max), {}};
      value.truth.proof = proof_word(*value.truth.clearance);
      ++trees;
    }
    count.add(value);
    writer.write(std::move(value), tree);
  }
}

void MadeSet::show(Session& session, const std::string& of) const {
  if (session.json) {
    for (const GenerationCost& cost : costs) print_row(cost);
    return;
  }
  print_table(generation_table(costs));
  std::string proofs = trees == 0 ? "" : ", " + counted(trees, "miss tree", "miss trees");
  if (count.by_word > 0) {
    proofs += fmt::format(", {} without a certificate: `ccdfuzz prove` makes one", count.by_word);
  }
  session.summary(
      fmt::format("\n{}{} in {}{}", counted(count.cases, "case", "cases"), of, path, proofs));
}

}  // namespace ccdfuzz
