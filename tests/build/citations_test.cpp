// What comments and derivations cite: sections, laws and names that are there.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = CCDFUZZ_SOURCE_DIR;

std::vector<fs::path> files_in(const char* folder, const std::vector<std::string>& extensions) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const std::string extension = entry.path().extension();
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// The derivation that a file means: the one that it names with its path, or that of its room.
fs::path derivation_of(const fs::path& file, const std::string& path_before) {
  if (path_before.starts_with("src/")) return kRoot / path_before / "DERIVATION.md";
  fs::path folder = file.parent_path();
  if (!path_before.empty()) return (folder / path_before / "DERIVATION.md").lexically_normal();
  static const std::map<std::string, std::string> kOfTests = {
      {"ccd", "src/ccd"},
      {"ccd_certified", "src/ccd/certified"},
      {"ccd_rational", "src/ccd/rational"}};
  if (const auto of = kOfTests.find(folder.filename());
      of != kOfTests.end() && folder.parent_path().filename() == "tests") {
    return kRoot / of->second / "DERIVATION.md";
  }
  while (folder != kRoot && !fs::exists(folder / "DERIVATION.md")) folder = folder.parent_path();
  return folder / "DERIVATION.md";
}

TEST(Citations, NameSectionsAndLawsThatDerivationsHave) {
  const std::regex line_break("\n *(///?)? *(\" *\")?");
  const std::regex citation("([\\w./]*/)?DERIVATION\\.md(, (\\d+|\"[^\"]+\"))?(, (L\\d+))?");
  int sections = 0, laws = 0;
  for (const char* top : {"src", "generators", "properties", "tests"}) {
    for (const fs::path& file : files_in(top, {".hpp", ".cpp"})) {
      if (file.filename() == "citations_test.cpp") continue;
      std::string text = read_text(file);
      if (text.find("DERIVATION.md") == std::string::npos) continue;
      text = std::regex_replace(text, line_break, " ");
      for (std::sregex_iterator m(text.begin(), text.end(), citation), end; m != end; ++m) {
        const fs::path path = derivation_of(file, (*m)[1]);
        ASSERT_TRUE(fs::exists(path)) << file << " cites " << path;
        const std::string derivation = read_text(path);
        std::string section = (*m)[3];
        if (!section.empty()) {
          const bool is_number = section.front() != '"';
          section = is_number ? section + ". " : section.substr(1, section.size() - 2);
          ++sections;
          EXPECT_NE(derivation.find("\n## " + section), std::string::npos)
              << file << " cites " << path << ", " << section;
        }
        if ((*m)[5].matched) {
          ++laws;
          EXPECT_NE(derivation.find("- **" + (*m)[5].str() + ". "), std::string::npos)
              << file << " cites " << (*m)[5];
        }
      }
    }
  }
  EXPECT_GT(sections, 10);
  EXPECT_GT(laws, 0);
}

TEST(Citations, DerivationsNameFunctionsThatAreThere) {
  std::string code;
  for (const char* top : {"src", "generators", "properties", "tests"}) {
    for (const fs::path& file : files_in(top, {".hpp", ".cpp"})) {
      code += read_text(file);
      code += file.filename().string() + '\n';
    }
  }
  const std::regex name("`([A-Za-z_]\\w*(::\\w+)*)(\\([^`]*\\))?`");
  int names = 0;
  for (const fs::path& path : files_in("src", {".md"})) {
    const std::string text = read_text(path);
    for (std::sregex_iterator m(text.begin(), text.end(), name), end; m != end; ++m) {
      const std::string whole = (*m)[1], last = whole.substr(whole.rfind(':') + 1);
      ++names;
      EXPECT_NE(code.find(last), std::string::npos) << path << " names " << whole;
    }
  }
  EXPECT_GT(names, 50);
}

}  // namespace
}  // namespace ccdfuzz
