#include <fmt/format.h>

#include "case/tree_file.hpp"
#include "cli/merge.hpp"
#include "cli/output.hpp"
#include "finds/entries.hpp"
#include "finds/store.hpp"

namespace ccdfuzz {

Result<int> merge_corpora(const std::vector<std::string>& inputs, const std::string& output) {
  std::vector<NamedCase> finds;
  for (const std::string& input : inputs) {
    const Result<std::vector<std::string>> paths = list_entries(input);
    if (!paths) return tl::unexpected(paths.error());
    if (paths->empty()) continue;  // a share that found nothing
    Result<std::vector<NamedCase>> entries = load_corpus(input);
    if (!entries) return tl::unexpected(entries.error());
    std::ranges::move(*entries, std::back_inserter(finds));
  }
  Result<Store> store = Store::open(output);
  if (!store) return tl::unexpected(store.error());
  std::uint64_t added = 0;
  for (const NamedCase& find : finds) {
    const Result<Store::Added> done = store->add(find.value, trees_path(find.file));
    if (!done) return tl::unexpected(done.error());
    if (*done != Store::Added::kKnown) ++added;
  }
  const Result<std::vector<NamedCase>> all = store->load();
  if (!all) return tl::unexpected(all.error());
  print_out(fmt::format("{} entries of {} corpora, {} taken over, {} now in {}\n", finds.size(),
                        inputs.size(), added, all->size(), output));
  return 0;
}

}  // namespace ccdfuzz
