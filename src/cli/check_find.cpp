#include "cli/check_find.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "cli/command.hpp"
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
  CheckFind find{shrunk_counterexample(property, numbers, tries), "", "", ""};
  // No bytes at all are zeros, as many as are asked for.
  const std::string hex = find.least.bytes.empty() ? "00" : to_hex_bytes(find.least.bytes);
  find.reproduce = fmt::format("{} check {} --hex {}", program_name(), property.name, hex);
  find.test = fmt::format(
      "TEST(Found, {}) {{\n"
      "  const auto bytes = ccdfuzz::parse_hex_bytes(\"{}\");\n"
      "  ccdfuzz::ByteChoices choices(*bytes);\n"
      "  const auto check = ccdfuzz::run(*ccdfuzz::property_named(\"{}\"), choices);\n"
      "  EXPECT_EQ(check.status, ccdfuzz::Check::Status::kHolds) << check.text;\n"
      "}}\n",
      test_name(property.name), hex, property.name);
  return find;
}

Result<std::string> save_find(const std::string& folder, const Property& property,
                              const CheckFind& find) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return system_error(folder, "make the folder", error.value());
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
