#pragma once

#include <string>

#include "case/case.hpp"
#include "case/query_csv.hpp"

namespace ccdfuzz {

/// A query of a CSV as a case, and how that stands to what the file says.
struct Imported {
  std::string id;
  CsvLayout layout = CsvLayout::kEdgeEdge;
  Case value;                    ///< with its exact truth, if it is linear
  std::uint64_t rounded = 0;     ///< numbers of the query that are not those of the file
  std::optional<bool> label;     ///< what the file says
  std::optional<bool> collides;  ///< what is so of the very numbers of the file, if it is linear

  /// Without its case.
  static void fields(auto& archive, auto& query) {
    archive("query", query.id);
    archive("label", query.label);
    archive("in_file", query.collides);
    archive("as_rounded", query.value.truth.collides);
    archive("rounded", query.rounded);
  }

  bool label_is_wrong() const { return label && collides && *label != *collides; }
  bool rounding_changed_the_truth() const { return collides && value.truth.collides != collides; }
};

/// Decides a linear query exactly; a curved one is left without truth. index: of the query in its
/// file. Errors: as to_query.
Result<Imported> import_case(const CsvQuery& from, bool round, std::uint64_t index);

/// Reads a whole file. truths: as CsvReader::open. Errors: as there, and as to_query.
Result<std::vector<CsvQuery>> read_csv(const std::string& path, CsvLayout layout,
                                       const std::string& truths = "");

}  // namespace ccdfuzz
