#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "io/folder_lock.hpp"
#include "io/input_bytes.hpp"
#include "io/json_write.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// The inputs of fuzz targets end at 1 MiB, each byte of which may be a choice.
constexpr std::size_t kMostFindBytes = 16 << 20;

std::string stem_of(const std::string& property, const std::string& error) {
  std::string name = error.empty() ? property : property + "-" + error;
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string path_of(const std::string& folder, const std::string& property,
                    const std::string& error) {
  return fmt::format("{}/{}.json", folder, stem_of(property, error));
}

}  // namespace

std::string check_command(std::string_view property, const ChoiceNumbers& choices) {
  return fmt::format("{} check {} --choices {}", shell_word(program_name()), property,
                     to_word(choices));
}

std::string check_command(std::string_view property, std::uint64_t seed, std::uint64_t index) {
  return fmt::format("{} check {} --seed {} --first {} --count 1", shell_word(program_name()),
                     property, seed, index);
}

Result<void> make_find_folder(const std::string& folder) {
  return make_folder(folder)
      .and_then([&] { return OutputFile::create(folder + "/a file"); })
      .map([](const OutputFile&) {});
}

ClaimFind::ClaimFind(const Property& of, std::string ended_in, std::string first_text,
                     std::string command)
    : property(of.name),
      claim(of.claim),
      error(std::move(ended_in)),
      found(std::move(first_text)),
      as_found(std::move(command)) {}

void ClaimFind::set_least(const Counterexample& least) {
  // A hang is never shrunk further.
  shrunk = least.is_cut_short && error != "hang" ? Shrunk::kCutShort : Shrunk::kToTheEnd;
  choices = least.numbers;
  text = least.check.text;
}

std::string ClaimFind::stem() const {
  return stem_of(property, error);
}

std::string ClaimFind::reproduce() const {
  return shrunk == Shrunk::kNot ? as_found : check_command(property, choices);
}

bool ClaimFind::replaces(const ClaimFind& other) const {
  if (shrunk != other.shrunk) return shrunk > other.shrunk;
  return shrunk == Shrunk::kNot || simpler(choices, other.choices);
}

Result<ClaimFind> read_find(const std::string& path) {
  return read_file(path, kMostFindBytes).and_then([&](const std::string& json) {
    return from_json<ClaimFind>(json, path);
  });
}

Result<std::optional<ClaimFind>> saved_find(const std::string& folder, const std::string& property,
                                            const std::string& error) {
  const std::string path = path_of(folder, property, error);
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return std::nullopt;
  return read_find(path).map([](ClaimFind find) { return std::optional(std::move(find)); });
}

Result<std::string> save_find(const std::string& folder, const ClaimFind& find) {
  CCDFUZZ_TRY_VOID(make_find_folder(folder));
  CCDFUZZ_TRY(const auto lock, FolderLock::take(folder));
  std::string path = path_of(folder, find.property, find.error);
  CCDFUZZ_TRY(const auto standing, saved_find(folder, find.property, find.error));
  if (standing && !find.replaces(*standing)) return path;
  return write_file(path, readable_json(to_json(find)) + "\n").map([&] { return std::move(path); });
}

}  // namespace ccdfuzz
