#pragma once

#include <cstdint>
#include <vector>

#include "generators/generate.hpp"

namespace ccdfuzz {

/// Generated queries of a contact class, so many of each kind: up to t*, and up to t* − 2^-20.
inline std::vector<Query> generated_queries(ContactClass contact, std::uint64_t of_each_kind) {
  std::vector<Query> all;
  for (std::uint64_t i = 0; i < of_each_kind; ++i) {
    for (const CaseKind kind : {CaseKind::kRP, CaseKind::kRN}) {
      GeneratorOptions options;
      options.contact = contact;
      options.kind = kind;
      options.construction = Construction::kOneSided;
      options.seed = 1;
      all.push_back(generate(options, i).value.query);
    }
  }
  return all;
}

}  // namespace ccdfuzz
