#include "eval/imported.hpp"

#include "certify/linear/first_contact.hpp"
#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

Result<Imported> import_case(const CsvQuery& from, bool round, std::uint64_t index) {
  Imported out;
  out.id = from.id();
  out.layout = from.layout;
  out.label = from.label;
  auto query = to_query(from, round, out.rounded);
  if (!query) return tl::unexpected(query.error());
  out.value.query = *std::move(query);
  Origin& origin = out.value.origin;
  origin.generator = "import";
  origin.index = index;
  if (from.label) origin.more["label"] = *from.label ? "1" : "0";
  if (from.layout == CsvLayout::kCurved) return out;
  origin.contact = from.layout == CsvLayout::kEdgeEdge ? "EE" : "VF";
  out.value.truth = decide(out.value.query).truth;
  out.collides = out.rounded == 0 ? out.value.truth.collides
                                  : linear::first_contact(from.patches(), 1).has_value();
  return out;
}

Result<std::vector<CsvQuery>> read_csv(const std::string& path, CsvLayout layout,
                                       const std::string& truths) {
  auto reader = CsvReader::open(path, layout, truths);
  if (!reader) return tl::unexpected(reader.error());
  std::vector<CsvQuery> all;
  for (;;) {
    auto next = reader->next();
    if (!next) return tl::unexpected(next.error());
    if (!*next) return all;
    all.push_back(**std::move(next));
  }
}

}  // namespace ccdfuzz
