#include "cli/replay_claims.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/check_find.hpp"
#include "cli/interrupt.hpp"
#include "finds/entries.hpp"
#include "hunt/served_claim.hpp"
#include "io/json_write.hpp"
#include "io/output_file.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

namespace {

/// A claim that was put to its input again, as a row of the table and of the JSON output.
struct ClaimRow {
  const std::string& path;
  const ClaimFind& find;
  const Check& got;

  Change change() const {
    if (got.status == find.expect) return Change::kNone;
    if (got.status == Check::Status::kDiscarded) return Change::kOther;
    return got.status == Check::Status::kFails ? Change::kRegression : Change::kImprovement;
  }

  static void fields(auto& archive, auto& row) {
    archive("claim", row.path);
    archive("property", row.find.property);
    archive("expected", row.find.expect);
    archive("got", row.got.status);
    archive("change", row.change());
    archive.optional("text", row.got.text);
  }
};

std::vector<TableCell> claim_cells(const ClaimRow& row) {
  const bool is_good = row.change() == Change::kImprovement;
  return {{row.find.property},
          {std::string(name_of(row.find.expect))},
          {std::string(name_of(row.got.status)), is_good ? Emphasis::kPlain : Emphasis::kBad},
          {std::string(name_of(row.change()))}};
}

}  // namespace

ReplayedClaims replay_claims(const std::string& corpus, const std::vector<Property>& known,
                             bool update, Session& session) {
  ReplayedClaims claims;
  const std::string folder = fmt::format("{}/{}", corpus, kClaims);
  if (!std::filesystem::is_directory(folder)) return claims;
  ServedClaims served(&catch_interrupts());
  for (const std::string& path : need(list_entries(folder))) {
    if (session.interrupted()) break;
    ClaimFind find = need(read_find(path));
    const Result<Property> property = property_named(find.property, known);
    if (!property) throw BadInput{{path + ": property", property.error().what}};
    const InputRun run = served.on(*property, find.choices);
    if (run.error == "interrupted") break;
    const ClaimRow row{path, find, run.check};
    ++claims.claims;
    ++claims.changes[static_cast<size_t>(row.change())];
    if (session.json || row.change() != Change::kNone) session.show(row, path, claim_cells);
    if (!update || row.change() == Change::kNone) continue;
    find.expect = run.check.status;
    need(write_file(path, readable_json(to_json(find)) + "\n"));
    ++claims.updated;
  }
  return claims;
}

}  // namespace ccdfuzz
