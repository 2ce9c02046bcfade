#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "cli/command.hpp"
#include "cli/shell_word.hpp"
#include "generators/random.hpp"
#include "query/output_file.hpp"

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

}  // namespace

CheckFind make_find(const Property& property, const ChoiceNumbers& numbers, std::uint64_t tries) {
  CheckFind find{shrunk_counterexample(property, numbers, tries), "", ""};
  find.reproduce = fmt::format("{} check {} --hex {}", shell_word(program_name()), property.name,
                               to_hex_word(find.least.bytes));
  find.test = fmt::format(
      "TEST(Found, {}) {{\n"
      "  const auto bytes = ccdfuzz::parse_hex_bytes(\"{}\");\n"
      "  ccdfuzz::ByteChoices choices(*bytes);\n"
      "  const auto check = ccdfuzz::run(*ccdfuzz::property_named(\"{}\"), choices);\n"
      "  EXPECT_EQ(check.status, ccdfuzz::Check::Status::kHolds) << check.text;\n"
      "}}\n",
      test_name(property.name), to_hex_bytes(find.least.bytes), property.name);
  return find;
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
  for (const std::uint8_t byte : find.least.bytes) key = Random::keyed({key, byte}).next();
  const std::string path = fmt::format("{}/{}-{:016x}.txt", folder, property.name, key);
  const std::string text = fmt::format(
      "{}: {}\n\n{}\n\nreproduce: {}\n\n#include <gtest/gtest.h>\n\n"
      "#include \"properties/registry.hpp\"\n\n{}",
      property.name, property.claim, find.least.check.text, find.reproduce, find.test);
  return write_file(path, text).map([&] { return path; });
}

}  // namespace ccdfuzz
