#include "finds/claim_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <utility>

#include "finds/entries.hpp"
#include "io/folder_lock.hpp"
#include "io/hash_name.hpp"
#include "io/json_write.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

namespace {

/// The inputs of fuzz targets end at 1 MiB, each byte of which may be a choice.
constexpr std::size_t kMostFindBytes = 16 << 20;

std::string path_of(const std::string& folder, const std::string& name) {
  return fmt::format("{}/{}.json", folder, name);
}

bool is_there(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(std::filesystem::symlink_status(path, none));
}

/// Whether these are the entries of a folder of claims.
bool are_claims(const std::string& folder, const std::vector<std::string>& entries) {
  if (!entries.empty()) return read_claim(entries.front()).has_value();
  const auto plain = std::filesystem::path(folder).lexically_normal();
  std::error_code none;
  return (plain.has_filename() ? plain : plain.parent_path()).filename() == kClaims &&
         !std::filesystem::exists(claims_in(folder), none);
}

}  // namespace

std::string claims_in(const std::string& corpus) {
  return fmt::format("{}/{}", corpus, kClaims);
}

bool is_claims_folder(const std::string& path) {
  return are_claims(path, list_entries(path).value_or(std::vector<std::string>()));
}

Result<CorpusFiles> cases_and_claims(const std::string& corpus) {
  std::error_code none;
  if (std::filesystem::exists(corpus, none) && !std::filesystem::is_directory(corpus, none)) {
    const bool is_claim = corpus.ends_with(".json") && read_claim(corpus);
    return is_claim ? CorpusFiles{{}, {corpus}} : CorpusFiles{{corpus}, {}};
  }
  CCDFUZZ_TRY(auto entries, list_entries(corpus));
  if (are_claims(corpus, entries)) return CorpusFiles{{}, std::move(entries)};
  CorpusFiles files{std::move(entries), {}};
  if (std::filesystem::is_directory(claims_in(corpus), none)) {
    CCDFUZZ_TRY(files.claims, list_entries(claims_in(corpus)));
  }
  return files;
}

Result<ClaimFind> read_claim(const std::string& path) {
  return read_file(path, kMostFindBytes).and_then([&](const std::string& json) {
    return from_json<ClaimFind>(json, path);
  });
}

std::string file_text(const ClaimFind& find) {
  return readable_json(to_json(find)) + "\n";
}

Result<std::optional<ClaimFind>> saved_claim(const std::string& folder, const ClaimFind& like) {
  const std::string path = path_of(folder, like.stem());
  if (!is_there(path)) return std::nullopt;
  return read_claim(path).map([&](ClaimFind find) {
    const bool is_alike = find.expect == like.expect && find.method == like.method;
    return is_alike ? std::optional(std::move(find)) : std::nullopt;
  });
}

Result<SavedClaim> save_claim(const std::string& folder, const ClaimFind& find,
                              const std::string& name) {
  CCDFUZZ_TRY_VOID(make_folder(folder));
  CCDFUZZ_TRY(const auto lock, FolderLock::take(folder));
  const std::string stem = find.stem();
  SavedClaim saved{path_of(folder, name.empty() ? stem : name)};
  if (saved.path == path_of(folder, stem)) {
    CCDFUZZ_TRY(saved.replaced, saved_claim(folder, find));
  }
  if (saved.replaced) {
    if (!find.replaces(*saved.replaced)) return SavedClaim{saved.path, false};
  } else if (is_there(saved.path)) {
    saved.path = path_of(folder, hash_name(to_json(find)));
    if (is_there(saved.path)) return SavedClaim{saved.path, false};
  }
  CCDFUZZ_TRY_VOID(write_file(saved.path, file_text(find)));
  return saved;
}

Result<MergedClaims> merge_claims(const std::vector<std::string>& files, const std::string& corpus,
                                  const std::vector<Property>& known) {
  MergedClaims merged;
  const std::string folder = claims_in(corpus);
  std::set<std::pair<std::string, ChoiceNumbers>> inputs;  // in it
  CCDFUZZ_TRY(const CorpusFiles there, cases_and_claims(corpus));
  for (const std::string& path : there.claims) {
    CCDFUZZ_TRY(const ClaimFind find, read_claim(path));
    inputs.insert(find.input());
  }
  if (!files.empty()) CCDFUZZ_TRY_VOID(make_writable_folder(folder));
  for (const std::string& path : files) {
    CCDFUZZ_TRY(const ClaimFind find, read_claim(path));
    if (const auto property = property_named(find.property, known); !property) {
      return input_error(path + ": property", property.error().what);
    }
    ++merged.entries;
    const bool has_input = find.shrunk != Shrunk::kNot;
    if (!has_input) ++merged.without_input;
    if (!has_input || inputs.contains(find.input())) continue;
    const std::string name = std::filesystem::path(path).stem();
    CCDFUZZ_TRY(const SavedClaim saved, save_claim(folder, find, name));
    if (saved.replaced) inputs.erase(saved.replaced->input());
    if (!saved.is_new) continue;
    inputs.insert(find.input());
    ++merged.taken;
  }
  return merged;
}

}  // namespace ccdfuzz
