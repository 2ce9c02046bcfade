#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <utility>

#include "base/output_file.hpp"
#include "base/text.hpp"
#include "cli/command.hpp"
#include "generators/random.hpp"

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

/// What stands in a file before the failure as it was found, by which finds are known that need no
/// more work.
constexpr const char* kComplete = "shrunk from:";
constexpr const char* kCutShort = "shrunk, not to the end, from:";

/// What the text of a find says.
FindQuality quality_of_text(std::istream& in) {
  constexpr std::string_view kInput = " --hex ";
  FindQuality quality;
  for (std::string line; std::getline(in, line);) {
    if (line == kComplete) quality.state = FindQuality::State::kComplete;
    if (line == kCutShort) quality.state = FindQuality::State::kCutShort;
    const std::size_t input = line.rfind(kInput);
    if (!line.starts_with("reproduce: ") || input == std::string::npos) continue;
    const std::string_view hex = std::string_view(line).substr(input + kInput.size());
    quality.bytes = hex == "''" ? 0 : hex.size() / 2;
  }
  return quality;
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

Result<std::string> save_find(const std::string& folder, const Property& property,
                              const CheckFind& find) {
  if (const Result<void> made = make_find_folder(folder); !made) {
    return tl::unexpected(made.error());
  }
  std::uint64_t key = 0;
  const auto add = [&](std::uint8_t byte) { key = Random::keyed({key, byte}).next(); };
  std::string text = fmt::format("{}: {}\n\n", property.name, property.claim);
  if (find.least) {
    std::ranges::for_each(find.least->bytes, add);
    text += fmt::format("{}\n\nreproduce: {}\n\n{}\n{}\n\n", find.least->check.text, find.reproduce,
                        find.test, quality_of(find).is_complete() ? kComplete : kCutShort);
  } else {
    for (const char c : find.as_found) add(static_cast<std::uint8_t>(c));
  }
  text += fmt::format("{}\n\nas found: {}\n", find.text, find.as_found);
  std::string path = fmt::format("{}/{}-{:016x}.txt", folder, kind_of_find(property, find), key);
  return write_file(path, text).map([&] { return std::move(path); });
}

std::string kind_of_find(const Property& property, const CheckFind& find) {
  std::string kind =
      fmt::format("{}{}{}", property.name, find.error.empty() ? "" : "-", find.error);
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

bool FindQuality::replaces(const FindQuality& other) const {
  if (state != other.state) return state > other.state;
  return state == State::kAsFound || bytes < other.bytes;
}

FindQuality quality_of(const CheckFind& find) {
  if (!find.least) return {};
  // Of a hang nobody tries more.
  const bool is_cut_short = find.least->is_cut_short && find.error != "hang";
  return {is_cut_short ? FindQuality::State::kCutShort : FindQuality::State::kComplete,
          find.least->bytes.size()};
}

std::vector<SavedFind> saved_finds(const std::string& folder) {
  static const std::regex kForm("(.+)-[0-9a-f]{16}\\.txt");
  std::vector<SavedFind> finds;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename();
    std::smatch parts;
    if (!std::regex_match(name, parts, kForm)) continue;
    std::ifstream in(at->path());
    finds.push_back({at->path(), parts[1], quality_of_text(in)});
  }
  return finds;
}

}  // namespace ccdfuzz
