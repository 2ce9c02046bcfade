#include <fmt/format.h>

#include <filesystem>

#include "case/tree_file.hpp"
#include "cli/merge.hpp"
#include "cli/session.hpp"
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

/// Puts an entry of another corpus: by the failure that it is called by, or under its own name.
Result<Store::Put> put_entry(Store& store, const NamedCase& entry) {
  const std::string trees = trees_path(entry.file);
  if (const auto failure = named_by_failure(entry)) {
    return store.put(*failure, entry.value, trees);
  }
  return store.put_named(std::filesystem::path(entry.id).stem(), entry.value, trees);
}

}  // namespace

int merge_corpora(const std::vector<std::string>& inputs, const std::string& output,
                  Session& session) {
  Store store = need(Store::open(output));
  MergedCorpora merged;
  for (const std::string& input : inputs) {
    need(for_each_entry(input, [&](const NamedCase& entry) {
      ++merged.entries;
      if (need(put_entry(store, entry)) != Store::Put::kKnown) ++merged.taken;
    }));
  }
  merged.now = need(list_entries(output)).size();
  if (session.json) print_out(to_json(merged) + "\n");
  session.summary(fmt::format("{} entries of {} corpora, {} taken over, {} now in {}",
                              merged.entries, inputs.size(), merged.taken, merged.now, output));
  return 0;
}

}  // namespace ccdfuzz
