// plant FAULTS SOURCES OUT: writes to OUT the source files that have faults. There each right text
// becomes a choice between it and the wrong ones, made when the program runs. OUT/faults.txt is the
// list as it was then: faults are known by their places in it. Nothing else of the project knows of
// faults. A fault is stale if its text is not in its file just once. It is left out with a warning
// and named in OUT/left_out.txt, so that whoever changes a source can still build. If OUT is "-",
// nothing is written, and the exit code is 1 if any fault is stale. So a test says that the list
// must follow.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "fault_list.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The text that replaces `from` and all faults in it.
std::string choice(const std::vector<PlantedFault>& faults,
                   const std::vector<std::size_t>& numbers) {
  std::string text = faults[numbers[0]].from;
  for (const std::size_t n : numbers) {
    text = faults[n].statement
               ? fmt::format("if (::ccdfuzz::planted::active({})) {{ {} }} else {{ {}\n}}", n + 1,
                             faults[n].to, text)
               : fmt::format("CCDFUZZ_PLANT({}, ({}), ({}))", n + 1, faults[n].to, text);
  }
  return text;
}

int fail(const std::string& message) {
  std::cerr << "plant: " << message << '\n';
  return 2;
}

/// Leaves a file as it is where nothing changes, so that nothing is compiled again.
bool write_if_changed(const fs::path& path, const std::string& text) {
  if (fs::exists(path) && content_of(path) == text) return true;
  fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out << text;
  return static_cast<bool>(out);
}

int plant(const std::string& list, const fs::path& sources, const fs::path& out) {
  const auto faults = read_faults(list);
  if (!faults) return fail(faults.error().message());
  /// file → right text → the faults in its place
  std::map<std::string, std::map<std::string, std::vector<std::size_t>>> by_file;
  for (std::size_t n = 0; n < faults->size(); ++n) {
    by_file[(*faults)[n].file][(*faults)[n].from].push_back(n);
  }
  std::size_t stale = 0;
  std::string left_out;
  for (const auto& [file, places] : by_file) {
    std::string text = content_of(sources / file);
    if (text.empty()) return fail(file + ": cannot be read");
    /// From the end to the front, so that what is replaced moves nothing that is still to be found.
    std::map<std::size_t, const std::vector<std::size_t>*> found;
    for (const auto& [from, numbers] : places) {
      const std::string& name = (*faults)[numbers[0]].name;
      const std::size_t at = text.find(from);
      if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) {
        std::cerr << fmt::format("plant: {} is left out: its text is not just once in {}: {}\n",
                                 name, file, from);
        stale += numbers.size();
        for (const std::size_t n : numbers) left_out += (*faults)[n].name + '\n';
        continue;
      }
      found[at] = &numbers;
    }
    std::size_t end = text.size();
    for (auto it = found.rbegin(); it != found.rend(); ++it) {
      const std::string& from = (*faults)[it->second->front()].from;
      if (it->first + from.size() > end) return fail(file + ": two faults overlap: " + from);
      end = it->first;
      text.replace(it->first, from.size(), choice(*faults, *it->second));
    }
    text.insert(0, "#include \"bench/scoreboard/planted.hpp\"\n#line 1\n");
    if (out == "-") continue;
    if (!write_if_changed(out / file, text))
      return fail((out / file).string() + ": cannot be written");
  }
  const std::map<std::string, std::string> about = {{"left_out.txt", left_out},
                                                    {"faults.txt", content_of(list)}};
  for (const auto& [name, text] : about) {
    if (out != "-" && !write_if_changed(out / name, text)) {
      return fail((out / name).string() + ": cannot be written");
    }
  }
  return stale > 0 && out == "-" ? 1 : 0;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  if (argc != 4) return ccdfuzz::fail("usage: plant FAULTS SOURCES OUT");
  return ccdfuzz::plant(argv[1], argv[2], argv[3]);
}
