#include "fault_list.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>

namespace ccdfuzz {

Result<std::vector<PlantedFault>> read_faults(const std::string& path) {
  std::ifstream in(path);
  if (!in) return input_error(path, "cannot be read");
  std::vector<PlantedFault> faults;
  std::set<std::string> names;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto fails = [&](const std::string& what) {
      return input_error(fmt::format("{}:{}", path, number), what);
    };
    if (line.empty() || line[0] == '#') continue;
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) return fails("is not \"key: text\"");
    const std::string key = line.substr(0, colon), text = line.substr(colon + 2);
    if (key == "fault") {
      if (!names.insert(text).second) return fails(text + " is there twice");
      faults.push_back({text, "", "", false, "", "", ""});
      continue;
    }
    if (faults.empty()) return fails("stands before the first fault");
    PlantedFault& fault = faults.back();
    if (key == "what") {
      fault.what = text;
    } else if (key == "file") {
      fault.file = text;
    } else if (key == "expr" || key == "stmt") {
      fault.statement = key == "stmt";
      fault.from = text;
    } else if (key == "to") {
      fault.to = text;
    } else if (key == "equivalent") {
      fault.equivalent = text;
    } else {
      return fails(fmt::format("unknown key \"{}\"", key));
    }
  }
  for (const PlantedFault& f : faults) {
    if (f.what.empty() || f.file.empty() || f.from.empty() || f.to.empty()) {
      return input_error(path, f.name + " lacks what, file, expr or stmt, or to");
    }
  }
  return faults;
}

}  // namespace ccdfuzz
