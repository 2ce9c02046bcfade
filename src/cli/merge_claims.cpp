#include "cli/merge_claims.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <set>

#include "cli/check_find.hpp"
#include "cli/session.hpp"
#include "finds/entries.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "io/hash_name.hpp"
#include "io/json_write.hpp"
#include "io/output_file.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

std::string claims_of(const std::string& corpus) {
  return is_claims_folder(corpus) ? corpus : fmt::format("{}/{}", corpus, kClaims);
}

/// The same for the same input of the same claim, and for no other.
std::string input_of(const ClaimFind& find) {
  return hash_name(fmt::format("{} {}", find.property, to_word(find.choices)));
}

/// The inputs in a folder (input_of).
std::set<std::string> inputs_in(const std::string& folder) {
  std::set<std::string> inputs;
  for (const std::string& path : need(list_entries(folder))) {
    inputs.insert(input_of(need(read_find(path))));
  }
  return inputs;
}

/// Returns whether the folder changed. inputs: those in it.
bool take(const ClaimFind& find, const std::string& stem, const std::string& folder,
          std::set<std::string>& inputs) {
  if (inputs.contains(input_of(find))) return false;
  const std::string own = fmt::format("{}/{}.json", folder, stem), json = to_json(find);
  if (stem == find.stem()) {
    const auto standing = need(saved_find(folder, find.property, find.error));
    if (!standing || standing->expect == find.expect) {
      need(save_find(folder, find));
      if (standing && !find.replaces(*standing)) return false;
      if (standing) inputs.erase(input_of(*standing));
      inputs.insert(input_of(find));
      return true;
    }
  }
  inputs.insert(input_of(find));
  const bool is_free = !fs::exists(fs::symlink_status(own));
  need(write_file(is_free ? own : fmt::format("{}/{}.json", folder, hash_name(json)),
                  readable_json(json) + "\n"));
  return true;
}

}  // namespace

bool is_claims_folder(const std::string& path) {
  const fs::path plain = fs::path(path).lexically_normal();
  return (plain.has_filename() ? plain : plain.parent_path()).filename() == kClaims;
}

MergedClaims merge_claims(const std::vector<std::string>& corpora, const std::string& into,
                          const std::vector<Property>& known) {
  MergedClaims merged;
  const std::string folder = fmt::format("{}/{}", into, kClaims);
  std::optional<std::set<std::string>> inputs;  // in it
  for (const std::string& corpus : corpora) {
    if (!fs::is_directory(claims_of(corpus))) continue;
    need(make_find_folder(folder));
    if (!inputs) inputs = inputs_in(folder);
    for (const std::string& path : need(list_entries(claims_of(corpus)))) {
      const ClaimFind find = need(read_find(path));
      if (const auto property = property_named(find.property, known); !property) {
        throw BadInput{{path + ": property", property.error().what}};
      }
      ++merged.entries;
      const bool has_input = find.shrunk != Shrunk::kNot;
      if (!has_input) ++merged.without_input;
      if (has_input && take(find, fs::path(path).stem(), folder, *inputs)) ++merged.taken;
    }
  }
  if (fs::is_directory(folder)) merged.now = need(list_entries(folder)).size();
  return merged;
}

}  // namespace ccdfuzz
