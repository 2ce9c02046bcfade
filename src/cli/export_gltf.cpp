#include "cli/export_gltf.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/common_options.hpp"
#include "query/output_file.hpp"
#include "report/gltf.hpp"

namespace ccdfuzz {

namespace {

/// "corpus/a.json" → "a.gltf", "b.jsonl.zst:12" → "b-12.gltf".
std::string gltf_name(const std::string& id) {
  const size_t end = id.find(".json", id.find_last_of('/') + 1);
  const size_t line = id.find(':', end == std::string::npos ? 0 : end);
  const std::string stem = std::filesystem::path(id.substr(0, end)).filename();
  return stem + (line == std::string::npos ? "" : "-" + id.substr(line + 1)) + ".gltf";
}

}  // namespace

Result<std::vector<std::string>> export_gltf(const std::vector<std::string>& files,
                                             const std::vector<double>& times,
                                             const std::string& output) {
  const Result<std::vector<NamedCase>> cases = read_all_checked(files);
  if (!cases) return tl::unexpected(cases.error());
  const bool one_file = output.ends_with(".gltf");
  if (one_file && cases->size() != 1) {
    return input_error(output,
                       fmt::format("takes one case, not {}; name a folder instead", cases->size()));
  }
  if (!one_file) {
    std::error_code error;
    std::filesystem::create_directories(output, error);
    if (error) return input_error(output, "cannot make the folder: " + error.message());
  }
  std::vector<std::string> written;
  for (const NamedCase& named : *cases) {
    const std::string path = one_file ? output : output + "/" + gltf_name(named.id);
    if (auto done = write_file(path, to_gltf(named.value, times)); !done) {
      return tl::unexpected(done.error());
    }
    written.push_back(path);
  }
  return written;
}

}  // namespace ccdfuzz
