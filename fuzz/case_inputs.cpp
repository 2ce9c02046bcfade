// The inputs of fuzz_query and fuzz_witnessed, with any compiler: made of cases, shown as cases, or
// run again. There is one program for each of the two targets, query_inputs and witnessed_inputs:
//   encode FOLDER CORPUS     a file for each case with a witness and method, as seeds
//   decode FILE...           the cases that a file is (cases_of), each as one line of JSON
//   run FILE...              what the fuzz target does with it
#include <fmt/format.h>

#include <iostream>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "finds/content_address.hpp"
#include "finds/entries.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/unproven.hpp"
#include "io/line_reader.hpp"
#include "io/output_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ccdfuzz {
namespace {

constexpr std::size_t kMostBytes = 64 << 20;

/// Errors: of the corpus or the folder.
Result<std::string> encode(const std::string& folder, const std::string& corpus) {
  CCDFUZZ_TRY(const auto paths, corpus_files(corpus));
  CCDFUZZ_TRY_VOID(make_folder(folder));
  size_t written = 0;
  CaseStream cases(paths);
  for (;;) {
    CCDFUZZ_TRY(const auto next, cases.next());
    if (!next) return fmt::format("{} seeds in {}", written, folder);
    const auto q = contact_of(next->value);
    for (std::uint8_t method = 0; q && method < kUnproven.size(); ++method) {
      const auto bytes = to_bytes(*q, method);
      if (!bytes) break;
      CCDFUZZ_TRY_VOID(
          write_file(fmt::format("{}/{}-{}", folder, content_address(q->query), method),
                     std::string(bytes->begin(), bytes->end())));
      ++written;
    }
  }
}

/// Errors: a file cannot be read, or is no case.
Result<std::string> for_each_file(const std::vector<std::string>& paths, bool decodes) {
  for (const std::string& path : paths) {
    CCDFUZZ_TRY(const std::string text, read_text(path, kMostBytes));
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    if (!decodes) {
      LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
      continue;
    }
    const std::vector<Case> cases = cases_of(bytes);
    if (cases.empty()) return input_error(path, "is no valid query");
    for (const Case& value : cases) std::cout << to_json(value) << '\n';
  }
  return decodes ? "" : fmt::format("{} inputs run, none failed", paths.size());
}

Result<std::string> run(const std::vector<std::string>& words) {
  const std::string mode = words.empty() ? "" : words[0];
  if (mode == "encode" && words.size() == 3) return encode(words[1], words[2]);
  if ((mode == "run" || mode == "decode") && words.size() >= 2) {
    return for_each_file({words.begin() + 1, words.end()}, mode == "decode");
  }
  return input_error("", "say: encode FOLDER CORPUS, decode FILE..., or run FILE...");
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  const auto done = ccdfuzz::run({argv + 1, argv + argc});
  if (!done) std::cerr << "case inputs: " << done.error().message() << '\n';
  if (done && !done->empty()) std::cout << *done << '\n';
  return done ? 0 : 2;
}
