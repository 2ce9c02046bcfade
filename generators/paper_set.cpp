#include "generators/paper_set.hpp"

#include "base/verify.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/build_tree.hpp"
#include "generators/shaped/shaped_case.hpp"

namespace ccdfuzz {

namespace {

/// How many cases of a contact class the paper's set has (Table 4): `regular` RP and as many RN,
/// `grazing` NHP and as many NMN.
struct PaperCounts {
  std::uint64_t regular, grazing;
};
constexpr std::array<PaperCounts, kContactClasses.size()> kPaperCounts = {
    {{6003, 600}, {1020, 100}, {1000, 100}, {1000, 100}, {1000, 100}, {1000, 100}}};

}  // namespace

std::vector<PaperItem> paper_items(std::uint64_t one_in) {
  CCDFUZZ_VERIFY(one_in >= 1);
  const auto part = [one_in](std::uint64_t count) {
    return count / one_in + (count % one_in != 0 ? 1 : 0);
  };
  std::vector<PaperItem> items;
  for (const ContactClass contact : kContactClasses) {
    const PaperCounts& counts = kPaperCounts[static_cast<size_t>(contact)];
    for (std::uint64_t i = 0; i < part(counts.regular); ++i) {
      items.push_back({contact, CaseKind::kRP, i});
    }
    for (const CaseKind kind : {CaseKind::kNHP, CaseKind::kNMN}) {
      for (std::uint64_t i = 0; i < part(counts.grazing); ++i) items.push_back({contact, kind, i});
    }
  }
  return items;
}

PaperCases make_paper_cases(const PaperItem& item, std::uint64_t seed) {
  GeneratorOptions options;
  options.contact = item.contact;
  options.kind = item.kind;
  options.seed = seed;
  Generated made = generate(options, item.index);
  PaperCases out;
  out.discards = made.discards;
  out.cases.push_back(std::move(made.value));
  Case& value = out.cases[0];
  Truth& truth = value.truth;
  if (item.kind == CaseKind::kNMN && !truth.clearance) {
    truth.clearance = build_miss_tree(value.query, exact(value.query.t_max), kPaperTreeNodes);
    if (truth.clearance) truth.proof = proof_word(*truth.clearance);
    CCDFUZZ_VERIFY(!truth.clearance || check_absence(value));
  }
  if (item.kind != CaseKind::kRP) return out;
  options.kind = CaseKind::kRN;
  out.cases.push_back(as_asked(value, options).value());
  out.cases[1].origin.kind = name_of(options.kind);
  return out;
}

}  // namespace ccdfuzz
