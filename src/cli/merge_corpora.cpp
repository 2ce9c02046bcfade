#include <fmt/format.h>

#include "case/tree_file.hpp"
#include "cli/merge.hpp"
#include "cli/session.hpp"
#include "finds/entries.hpp"
#include "finds/store.hpp"

namespace ccdfuzz {

namespace {

/// What a merge of corpora did.
struct MergedCorpora {
  std::uint64_t entries = 0, taken = 0, now = 0;

  static void fields(auto& archive, auto& merged) {
    archive("entries", merged.entries);
    archive("taken_over", merged.taken);
    archive("now", merged.now);
  }
};

}  // namespace

int merge_corpora(const std::vector<std::string>& inputs, const std::string& output,
                  Session& session) {
  std::vector<NamedCase> finds;
  for (const std::string& input : inputs) {
    if (need(list_entries(input)).empty()) continue;  // a hunt that found nothing
    std::ranges::move(need(load_corpus(input)), std::back_inserter(finds));
  }
  Store store = need(Store::open(output));
  MergedCorpora merged;
  merged.entries = finds.size();
  for (const NamedCase& find : finds) {
    const Store::Added done = need(store.add(find.value, trees_path(find.file)));
    if (done != Store::Added::kKnown) ++merged.taken;
  }
  merged.now = need(store.load()).size();
  if (session.json) print_out(to_json(merged) + "\n");
  session.summary(fmt::format("{} entries of {} corpora, {} taken over, {} now in {}",
                              merged.entries, inputs.size(), merged.taken, merged.now, output));
  return 0;
}

}  // namespace ccdfuzz
