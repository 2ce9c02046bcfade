#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <utility>

#include "base/folder_lock.hpp"
#include "base/input_bytes.hpp"
#include "base/json_write.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "cli/command.hpp"

namespace ccdfuzz {

namespace {

/// "tdibm-e.safe_roots" → "TdibmESafeRoots".
std::string test_name(std::string_view property) {
  std::string name;
  bool starts = true;
  for (const char c : property) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter) name += starts ? static_cast<char>(std::toupper(c)) : c;
    starts = !letter;
  }
  return name;
}

/// The inputs of fuzz targets end at 1 MiB; in hex they are twice as long, and stand there thrice.
constexpr std::size_t kMostFindBytes = 16 << 20;

std::string path_of(const std::string& folder, const std::string& property,
                    const std::string& error) {
  std::string name = error.empty() ? property : property + "-" + error;
  std::ranges::replace(name, ' ', '-');
  return fmt::format("{}/{}.json", folder, name);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::string check_command(const Property& property, std::span<const std::uint8_t> bytes) {
  return fmt::format("{} check {} --hex {}", shell_word(program_name()), property.name,
                     to_hex_word(bytes));
}

std::string check_command(const Property& property, std::uint64_t seed, std::uint64_t index) {
  return fmt::format("{} check {} --seed {} --first {} --count 1", shell_word(program_name()),
                     property.name, seed, index);
}

void set_least(CheckFind& find, const Property& property, Counterexample least) {
  find.least = std::move(least);
  find.reproduce = check_command(property, find.least->bytes);
  find.test = fmt::format(
      "#include <gtest/gtest.h>\n\n"
      "#include \"properties/registry.hpp\"\n\n"
      "TEST(Found, {}) {{\n"
      "  const auto bytes = ccdfuzz::parse_hex_bytes(\"{}\");\n"
      "  ccdfuzz::ByteChoices choices(*bytes);\n"
      "  const auto check = ccdfuzz::run(*ccdfuzz::property_named(\"{}\"), choices);\n"
      "  EXPECT_EQ(check.status, ccdfuzz::Check::Status::kHolds) << check.text;\n"
      "}}\n",
      test_name(property.name), to_hex_bytes(find.least->bytes), property.name);
}

Result<void> make_find_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return system_error(folder, "make the folder", error.value());
  return OutputFile::create(folder + "/a file").map([](const OutputFile&) {});
}

std::string_view name_of(Shrunk shrunk) {
  constexpr std::array<std::string_view, 3> kNames = {"not", "cut short", "to the end"};
  return kNames[static_cast<size_t>(shrunk)];
}

SavedFind::SavedFind(const Property& of, const CheckFind& find)
    : property(of.name),
      claim(of.claim),
      error(find.error),
      found(find.text),
      as_found(find.as_found) {
  if (!find.least) return;
  // A hang is never shrunk further.
  shrunk = find.least->is_cut_short && error != "hang" ? Shrunk::kCutShort : Shrunk::kToTheEnd;
  input = to_hex_bytes(find.least->bytes);
  text = find.least->check.text;
  reproduce = find.reproduce;
  test = lines_of(find.test);
}

bool SavedFind::replaces(const SavedFind& other) const {
  if (shrunk != other.shrunk) return shrunk > other.shrunk;
  return shrunk == Shrunk::kNot || input.size() < other.input.size();
}

Result<std::optional<SavedFind>> saved_find(const std::string& folder, const std::string& property,
                                            const std::string& error) {
  const std::string path = path_of(folder, property, error);
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return std::nullopt;
  return refuse_irregular(path)
      .and_then([&] { return open_input(path, false); })
      .and_then([](const auto& in) { return in->read(kMostFindBytes); })
      .and_then([&](const std::string& json) { return from_json<SavedFind>(json, path); })
      .map([](SavedFind find) { return std::optional(std::move(find)); });
}

Result<std::string> save_find(const std::string& folder, const SavedFind& find) {
  if (const auto made = make_find_folder(folder); !made) return tl::unexpected(made.error());
  const auto lock = FolderLock::take(folder);
  if (!lock) return tl::unexpected(lock.error());
  std::string path = path_of(folder, find.property, find.error);
  const auto standing = saved_find(folder, find.property, find.error);
  if (!standing) return tl::unexpected(standing.error());
  if (*standing && !find.replaces(**standing)) return path;
  return write_file(path, readable_json(to_json(find)) + "\n").map([&] { return std::move(path); });
}

}  // namespace ccdfuzz
