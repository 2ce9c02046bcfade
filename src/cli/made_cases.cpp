#include "cli/made_cases.hpp"

#include "base/hex_bytes.hpp"
#include "cli/output.hpp"

namespace ccdfuzz {

Result<MadeSet> MadeSet::open(const std::string& path) {
  MadeSet set;
  if (path.empty() || path == "-") return set;
  CCDFUZZ_TRY(DataSetWriter writer, DataSetWriter::open(path));
  leave_stdout_to(path);
  set.path_ = path;
  set.writer_ = std::move(writer);
  return set;
}

Result<void> MadeSet::add(MadeCases made) {
  add_cost(costs_, made.cost);
  const std::string tree = parse_hex_bytes(made.tree).value();
  for (Case& value : made.cases) {
    ++cases_;
    Result<void> written;
    if (!tree.empty()) {
      value.truth.clearance = MissTree{exact(value.query.t_max), {}};
      value.truth.proof = proof_word(*value.truth.clearance);
      ++trees_;
    }
    if (writer_) {
      written = writer_->write(std::move(value), tree);
    } else {
      print_out(to_json(value) + "\n");
      written = check_stdout();
    }
    if (!written) return written;
  }
  return {};
}

Result<void> MadeSet::finish() {
  if (!writer_) return flush_stdout();
  return writer_->complete().and_then([&] { return write_costs(path_, costs_); }).and_then([&] {
    return writer_->finish();
  });
}

}  // namespace ccdfuzz
