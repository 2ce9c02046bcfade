// The inputs of fuzz_query and fuzz_witnessed, with any compiler: made of cases, shown as cases, or
// run again. There is one program for each of the two targets, query_inputs and witnessed_inputs:
//   encode FOLDER CORPUS     a file for each case with a witness and method, as seeds
//   decode FILE...           the cases that a file is (cases_of), each as one line of JSON
//   run FILE...              what the fuzz target does with it
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "finds/content_address.hpp"
#include "finds/entries.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/unproven.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

int refuse(const std::string& message) {
  std::cerr << "case inputs: " << message << '\n';
  return 2;
}

std::optional<std::vector<std::uint8_t>> read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  return std::vector<std::uint8_t>(std::istreambuf_iterator<char>(in), {});
}

bool write_bytes(const fs::path& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(out.flush());
}

int encode(const std::string& folder, const std::string& corpus) {
  const Result<std::vector<std::string>> paths = corpus_files(corpus);
  if (!paths) return refuse(paths.error().message());
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return refuse(fmt::format("{}: {}", folder, error.message()));
  size_t written = 0;
  CaseStream cases(*paths);
  for (;;) {
    const Result<std::optional<NamedCase>> next = cases.next();
    if (!next) return refuse(next.error().message());
    if (!*next) break;
    const auto q = contact_of((*next)->value);
    for (std::uint8_t method = 0; q && method < kUnproven.size(); ++method) {
      const auto bytes = to_bytes(*q, method);
      if (!bytes) break;
      const fs::path file =
          fs::path(folder) / fmt::format("{}-{}", content_address(q->query), method);
      if (!write_bytes(file, *bytes)) return refuse(fmt::format("{}: cannot write", file.string()));
      ++written;
    }
  }
  std::cout << fmt::format("{} seeds in {}\n", written, folder);
  return 0;
}

int for_each_file(const std::vector<std::string>& paths, bool decodes) {
  for (const std::string& path : paths) {
    const auto bytes = read_bytes(path);
    if (!bytes) return refuse(fmt::format("{}: cannot read", path));
    if (!decodes) {
      LLVMFuzzerTestOneInput(bytes->data(), bytes->size());
      continue;
    }
    const std::vector<Case> cases = cases_of(*bytes);
    if (cases.empty()) return refuse(fmt::format("{}: is no valid query", path));
    for (const Case& value : cases) std::cout << to_json(value) << '\n';
  }
  if (!decodes) std::cout << fmt::format("{} inputs run, none failed\n", paths.size());
  return 0;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;  // NOLINT: the program's own
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string mode = words.empty() ? "" : words[0];
  if (mode == "encode" && words.size() == 3) return encode(words[1], words[2]);
  if ((mode == "run" || mode == "decode") && words.size() >= 2) {
    return for_each_file({words.begin() + 1, words.end()}, mode == "decode");
  }
  return refuse("say: encode FOLDER CORPUS, decode FILE..., or run FILE...");
}
