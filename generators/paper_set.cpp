#include "generators/paper_set.hpp"

#include "base/verify.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/build_tree.hpp"
#include "files/tree_file.hpp"
#include "generators/finalize.hpp"

namespace ccdfuzz {

namespace {

/// How many cases of a contact class the paper's set has (Table 4): `regular` RP and as many RN,
/// `grazing` NHP and as many NMN.
struct PaperCounts {
  std::uint64_t regular, grazing;
};
constexpr std::array<PaperCounts, kContactClasses.size()> kPaperCounts = {
    {{6003, 600}, {1020, 100}, {1000, 100}, {1000, 100}, {1000, 100}, {1000, 100}}};

/// The RN case of an RP case.
Case negative_of(const Case& positive) {
  CCDFUZZ_VERIFY(positive.truth.clear_until);
  const std::optional<double> t_max = to_double_exactly(*positive.truth.clear_until);
  CCDFUZZ_VERIFY(t_max);
  Case negative = positive;
  say_clear(negative, *t_max);
  negative.origin.kind = name_of(CaseKind::kRN);
  return negative;
}

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
  const Case& value = out.cases[0];
  if (item.kind == CaseKind::kRP) out.cases.push_back(negative_of(value));
  if (item.kind == CaseKind::kNMN && !value.truth.clearance) {
    const Rational until = exact(value.query.t_max);
    auto tree = build_miss_tree(value.query, until, kPaperTreeNodes);
    if (tree && tree->size() <= kMaxTreeBytes) {
      CCDFUZZ_VERIFY(check_clearance(value.query, MissTree{until, {}}, *tree));
      out.tree = *std::move(tree);
    }
  }
  return out;
}

}  // namespace ccdfuzz
