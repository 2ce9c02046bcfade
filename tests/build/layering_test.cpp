// The rooms of the project and which of them each may include (a room may always include itself).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = CCDFUZZ_SOURCE_DIR;

/// Of a room, what its folder's CMakeLists.txt says.
struct Room {
  int most_lines = 0;
  std::vector<std::string> below;  ///< directly; what those may include, it may too
};

/// Folders, without src in front. Written by the build (ccdfuzz_room).
std::map<std::string, Room> read_rooms() {
  std::map<std::string, Room> rooms;
  std::map<std::string, std::string> folder_of;  // of a library
  std::ifstream file(CCDFUZZ_ROOMS);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string folder, library;
    Room room;
    words >> folder >> library >> room.most_lines;
    if (folder.starts_with("src/")) folder.erase(0, 4);
    for (std::string below; words >> below;) room.below.push_back(below);
    folder_of[library] = folder;
    rooms[folder] = room;
  }
  for (auto& [folder, room] : rooms) {
    for (std::string& below : room.below) below = folder_of.at(below);
  }
  return rooms;
}

const std::map<std::string, Room>& rooms() {
  static const std::map<std::string, Room> kRooms = read_rooms();
  return kRooms;
}

/// Headers that only some rooms may use: those that run properties, not those that state them.
const std::map<std::string, std::set<std::string>> kDriversOnly = {
    {"gtest/", {}}, {"gmock/", {}}, {"rapidcheck", {"generators/rc"}}, {"benchmark/", {}}};

/// The room and all below it.
std::set<std::string> allowed(const std::string& room) {
  std::set<std::string> all;
  const auto add = [&](const auto& self, const std::string& one) -> void {
    if (!all.insert(one).second) return;
    for (const std::string& below : rooms().at(one).below) self(self, below);
  };
  add(add, room);
  return all;
}

/// The room of a path relative to the source folder or to src: the longest one it is in.
std::string room_of(std::string path) {
  if (path.starts_with("src/")) path.erase(0, 4);
  std::string found;
  for (const auto& [room, said] : rooms()) {
    if (path.starts_with(room + "/") && room.size() > found.size()) found = room;
  }
  return found;
}

struct Include {
  std::string name;
  bool quoted = false;
};

std::vector<Include> includes_of(const fs::path& path) {
  std::ifstream in(path);
  std::vector<Include> found;
  for (std::string line; std::getline(in, line);) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const size_t open = line.find_first_of("\"<", word);
    if (open == std::string::npos) continue;
    const bool quoted = line[open] == '"';
    const size_t close = line.find(quoted ? '"' : '>', open + 1);
    found.push_back({line.substr(open + 1, close - open - 1), quoted});
  }
  return found;
}

/// What is wrong with one include of the file at `path`; empty if nothing is.
std::string complaint(const std::string& path, const Include& include) {
  const std::string room = room_of(path);
  for (const auto& [header, rooms] : kDriversOnly) {
    if (!include.name.starts_with(header)) continue;
    const bool excepted = std::any_of(rooms.begin(), rooms.end(),
                                      [&](const auto& r) { return path.starts_with(r + "/"); });
    if (!excepted) return room + " may not use <" + include.name + ">";
  }
  if (!include.quoted) return "";
  if (!fs::exists(kTop / include.name) && !fs::exists(kTop / "src" / include.name)) {
    return "\"" + include.name + "\" is not a path from src or from the top";
  }
  const std::string used = room_of(include.name);
  if (used.empty()) return "\"" + include.name + "\" belongs to no room";
  return allowed(room).contains(used) ? "" : room + " may not include " + used;
}

std::vector<std::string> source_files() {
  std::vector<std::string> files;
  for (const char* top : {"src", "generators", "properties", "fuzz"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kTop / top)) {
      const std::string extension = entry.path().extension();
      if (extension == ".hpp" || extension == ".cpp" || extension == ".h") {
        files.push_back(fs::relative(entry.path(), kTop));
      }
    }
  }
  return files;
}

TEST(Layering, EveryIncludeGoesDownwards) {
  const std::vector<std::string> files = source_files();
  EXPECT_GT(files.size(), 20U);
  for (const std::string& path : files) {
    ASSERT_NE(room_of(path), "") << path << " stands in no room that the layers know";
    for (const Include& include : includes_of(kTop / path)) {
      EXPECT_EQ(complaint(path, include), "") << path;
    }
  }
}

/// The constants that a file declares outside of any block, each with its room.
void add_constants(const std::string& path,
                   std::map<std::string, std::set<std::string>>& rooms_of) {
  static const std::regex declares("^(inline |static )*(constexpr|const) .*"),
      name("\\b(k[A-Z]\\w*)\\b(?= *(=|\\{|\\[))");
  std::ifstream in(kTop / path);
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, declares)) continue;
    for (std::sregex_iterator m(line.begin(), line.end(), name), end; m != end; ++m) {
      rooms_of[(*m)[1]].insert(room_of(path));
    }
  }
}

// Files of a target are compiled as one: a constant of one file's unnamed namespace would silently
// hide a header's of the same name from the files that come after it.
TEST(Layering, NoConstantOfAFileHidesOneOfAHeader) {
  std::map<std::string, std::set<std::string>> in_headers;
  const std::vector<std::string> files = source_files();
  for (const std::string& path : files) {
    if (!path.ends_with(".cpp")) add_constants(path, in_headers);
  }
  EXPECT_GT(in_headers.size(), 20U);
  for (const std::string& path : files) {
    if (!path.ends_with(".cpp")) continue;
    std::map<std::string, std::set<std::string>> own;
    add_constants(path, own);
    const std::set<std::string> visible = allowed(room_of(path));
    for (const auto& [constant, room] : own) {
      for (const std::string& header_room : in_headers[constant]) {
        EXPECT_FALSE(visible.contains(header_room)) << path << ": " << constant;
      }
    }
  }
}

TEST(Layering, NoArrowPointsUp) {
  EXPECT_GT(rooms().size(), 20U);
  for (const auto& [room, said] : rooms()) {
    for (const std::string& below : said.below) {
      EXPECT_FALSE(allowed(below).contains(room)) << room << " and " << below;
    }
  }
}

TEST(Layering, NoRoomHoldsMoreLinesThanItsBudgetAndNoFileMoreThan400) {
  std::map<std::string, int> lines;
  for (const std::string& path : source_files()) {
    const std::string text = read_text(kTop / path);
    const auto of_file = static_cast<int>(std::ranges::count(text, '\n'));
    EXPECT_LE(of_file, 400) << path;
    lines[room_of(path)] += of_file;
  }
  for (const auto& [room, said] : rooms()) {
    std::printf("%-20s %5d of %5d lines\n", room.c_str(), lines[room], said.most_lines);
    EXPECT_LE(lines[room], said.most_lines) << room;
  }
}

TEST(Layering, TheCheckerIsIndependentOfTheMethods) {
  EXPECT_THAT(
      allowed("certify/checker"),
      testing::UnorderedElementsAre("certify/checker", "case", "bezier", "numeric", "base"));
}

/// The names that a header includes, and those that the project's headers among them do.
std::set<std::string> closure(const std::string& header) {
  std::set<std::string> all;
  const auto add = [&](const auto& self, const std::string& name) -> void {
    if (!all.insert(name).second) return;
    for (const Include& include : includes_of(kTop / "src" / name)) self(self, include.name);
  };
  add(add, header);
  return all;
}

// The certified method uses doubles only, and nothing of the paper's methods.
TEST(Layering, HeadersOfTheCertifiedMethodHaveNoGmpAndNothingOfThePaper) {
  int headers = 0;
  for (const auto& entry : fs::directory_iterator(kTop / "src/ccd/certified")) {
    if (entry.path().extension() != ".hpp") continue;
    ++headers;
    const std::string header = fs::relative(entry.path(), kTop / "src");
    const std::set<std::string> all = closure(header);
    EXPECT_TRUE(all.contains("array") || all.contains("cstdint") || all.contains("span")) << header;
    for (const char* barred :
         {"gmpxx.h", "gmp.h", "ccd/line.hpp", "ccd/envelope.hpp", "ccd/robustness.hpp",
          "ccd/separation.hpp", "ccd/axes.hpp", "ccd/projection.hpp"}) {
      EXPECT_FALSE(all.contains(barred)) << header << " reaches " << barred;
    }
  }
  EXPECT_GT(headers, 10);
  EXPECT_TRUE(closure("bezier/exact_patch.hpp").contains("gmpxx.h"));
}

// What decides about a proof is given values and bytes. None of the rooms below it reads or writes.
TEST(Layering, NothingBelowTheCheckerReadsFiles) {
  const std::set<std::string> below = allowed("certify/checker");
  int files = 0;
  for (const std::string& path : source_files()) {
    if (!below.contains(room_of(path))) continue;
    ++files;
    for (const Include& include : includes_of(kTop / path)) {
      for (const char* barred : {"nlohmann", "zstd", "xxhash", "tbb", "CLI", "zlib", "fstream",
                                 "iostream", "filesystem", "cstdio", "fcntl", "unistd"}) {
        EXPECT_FALSE(include.name.starts_with(barred)) << path << " includes " << include.name;
      }
    }
  }
  EXPECT_GT(files, 60);
}

TEST(Layering, RefusesWhatGoesUpwards) {
  EXPECT_EQ(complaint("src/certify/checker/x.cpp", {"ccd/search.hpp", true}),
            "certify/checker may not include ccd");
  EXPECT_EQ(complaint("src/numeric/x.cpp", {"bezier/patch.hpp", true}),
            "numeric may not include bezier");
  EXPECT_EQ(complaint("properties/x.hpp", {"gtest/gtest.h", false}),
            "properties may not use <gtest/gtest.h>");
  EXPECT_NE(complaint("src/case/x.hpp", {"query.hpp", true}), "");
  EXPECT_EQ(complaint("src/case/x.hpp", {"case/query.hpp", true}), "");
  EXPECT_EQ(complaint("src/case/x.hpp", {"vector", false}), "");
}

}  // namespace
}  // namespace ccdfuzz
