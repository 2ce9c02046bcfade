#include "cli/data_set.hpp"

#include <fmt/format.h>

namespace ccdfuzz {

MadeSet::MadeSet(const std::string& to) : path(to), writer(need(CaseWriter::open(to))) {
  if (!is_stream(path)) need(refuse_read_only(costs_path(path)));
  leave_stdout_to(path);
}

void MadeSet::finish() {
  need(writer.complete());
  need(write_costs(path, costs));
  need(writer.finish());  // last: where the cases are, all is
}

void MadeSet::add(const MadeCases& made) {
  add_cost(costs, made.cost);
  for (const Case& value : made.cases) {
    if (clearance_of<MissTree>(value.truth) != nullptr) ++trees;
    count.add(value);
    need(writer.write(value));
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
