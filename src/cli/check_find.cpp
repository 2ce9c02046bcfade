#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "finds/entries.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "io/folder_lock.hpp"
#include "io/hash_name.hpp"
#include "io/json_write.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"

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
  if (!entries.empty()) return read_find(entries.front()).has_value();
  const auto plain = std::filesystem::path(folder).lexically_normal();
  std::error_code none;
  return (plain.has_filename() ? plain : plain.parent_path()).filename() == kClaims &&
         !std::filesystem::exists(claims_in(folder), none);
}

}  // namespace

std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on) {
  const std::string words = method.empty() ? "" : method_words(std::vector<std::string>{method});
  return fmt::format("{} check {}{} {}", shell_word(program_name()), property, words, on);
}

std::string words_of(const ChoiceNumbers& choices) {
  return "--choices " + to_word(choices);
}

std::string words_of(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("--seed {} --first {} --count 1", seed, index);
}

ClaimFind::ClaimFind(const Property& of, std::string ended_in, std::string first_text,
                     const std::string& on)
    : property(of.name),
      claim(of.claim),
      method(of.method),
      error(std::move(ended_in)),
      found(std::move(first_text)),
      as_found(check_command(property, method, on)) {}

void ClaimFind::set_least(const Counterexample& least) {
  // A hang is never shrunk further.
  shrunk = least.is_cut_short && error != "hang" ? Shrunk::kCutShort : Shrunk::kToTheEnd;
  choices = least.numbers;
  text = least.check.text;
}

std::string ClaimFind::stem() const {
  std::string name = error.empty() ? property : property + "-" + error;
  if (!method.empty()) name += "-" + method;
  for (const char other : {' ', '/', ':'}) std::ranges::replace(name, other, '-');
  constexpr std::size_t kLongest = 200;  // a file's name may have 255 bytes
  return name.size() <= kLongest ? name : name.substr(0, kLongest / 2) + "-" + hash_name(name);
}

std::string ClaimFind::reproduce() const {
  return shrunk == Shrunk::kNot ? as_found : check_command(property, method, words_of(choices));
}

bool ClaimFind::replaces(const ClaimFind& other) const {
  if (shrunk != other.shrunk) return shrunk > other.shrunk;
  return shrunk == Shrunk::kNot || simpler(choices, other.choices);
}

std::string claims_in(const std::string& corpus) {
  return fmt::format("{}/{}", corpus, kClaims);
}

bool is_claims_folder(const std::string& path) {
  return are_claims(path, list_entries(path).value_or(std::vector<std::string>()));
}

Result<CorpusFiles> cases_and_claims(const std::string& corpus) {
  std::error_code none;
  if (std::filesystem::exists(corpus, none) && !std::filesystem::is_directory(corpus, none)) {
    const bool is_claim = corpus.ends_with(".json") && read_find(corpus);
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

Result<ClaimFind> read_find(const std::string& path) {
  return read_file(path, kMostFindBytes).and_then([&](const std::string& json) {
    return from_json<ClaimFind>(json, path);
  });
}

std::string file_text(const ClaimFind& find) {
  return readable_json(to_json(find)) + "\n";
}

Result<std::optional<ClaimFind>> saved_find(const std::string& folder, const ClaimFind& like) {
  const std::string path = path_of(folder, like.stem());
  if (!is_there(path)) return std::nullopt;
  return read_find(path).map([&](ClaimFind find) {
    const bool is_alike = find.expect == like.expect && find.method == like.method;
    return is_alike ? std::optional(std::move(find)) : std::nullopt;
  });
}

Result<SavedFind> save_find(const std::string& folder, const ClaimFind& find,
                            const std::string& name) {
  CCDFUZZ_TRY_VOID(make_folder(folder));
  CCDFUZZ_TRY(const auto lock, FolderLock::take(folder));
  const std::string stem = find.stem();
  SavedFind saved{path_of(folder, name.empty() ? stem : name)};
  if (saved.path == path_of(folder, stem)) {
    CCDFUZZ_TRY(saved.replaced, saved_find(folder, find));
  }
  if (saved.replaced) {
    if (!find.replaces(*saved.replaced)) return SavedFind{saved.path, false};
  } else if (is_there(saved.path)) {
    saved.path = path_of(folder, hash_name(to_json(find)));
    if (is_there(saved.path)) return SavedFind{saved.path, false};
  }
  CCDFUZZ_TRY_VOID(write_file(saved.path, file_text(find)));
  return saved;
}

}  // namespace ccdfuzz
