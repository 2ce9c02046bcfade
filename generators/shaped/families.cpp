#include "generators/shaped/families.hpp"

#include "base/verify.hpp"

namespace ccdfuzz {

bool own_shapes(ContactClass, const ShapePair&) {
  return false;
}

const FamilyRow& row_of(Family family) {
  static const auto kRows = [] {
    std::array<FamilyRow, kAllFamilies.size()> rows;
    for (const auto& rows_of_a_file :
         {moving_families(), odd_families(), extended_families(), other_families(), body_families(),
          weighted_families(), round_families(), trimmed_families(), ends_families(),
          separated_families(), turning_families(), mesh_families()}) {
      for (const FamilyRow& row : rows_of_a_file) rows.at(static_cast<size_t>(row.family)) = row;
    }
    for (const FamilyRow& row : rows) CCDFUZZ_VERIFY(!row.name.empty());
    return rows;
  }();
  return kRows.at(static_cast<size_t>(family));
}

}  // namespace ccdfuzz
