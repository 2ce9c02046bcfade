#include "cli/triage_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/output_file.hpp"
#include "cli/output.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// What libFuzzer makes and reads unless it is told otherwise (-max_len).
constexpr std::size_t kMostInputBytes = 1 << 20;

}  // namespace

Result<std::vector<std::string>> triage_files(const std::vector<std::string>& inputs) {
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error)) return input_error(input, "no such file or folder");
    if (!fs::is_directory(input, error)) {
      files.push_back(input);
      continue;
    }
    std::vector<std::string> inside;
    fs::recursive_directory_iterator at(input, error), end;
    for (; !error && at != end; at.increment(error)) {
      std::error_code gone;  // meanwhile
      const bool is_being_written = temporary_writer(at->path().filename().string()).has_value();
      if (!is_being_written && at->is_regular_file(gone)) inside.push_back(at->path());
    }
    if (error) return input_error(input, "cannot be read: " + error.message());
    std::ranges::sort(inside);
    std::ranges::move(inside, std::back_inserter(files));
  }
  return files;
}

Result<std::vector<std::uint8_t>> read_bytes(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return input_error(path, "is no file");
  std::ifstream in(path, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  std::array<char, 1 << 16> part;
  while (in) {
    in.read(part.data(), part.size());
    bytes.insert(bytes.end(), part.begin(), part.begin() + in.gcount());
    if (bytes.size() > kMostInputBytes) {
      return input_error(path, "is larger than the inputs of fuzz targets are, 1 MiB");
    }
  }
  if (!in.eof()) return input_error(path, "cannot be read");
  return bytes;
}

Result<void> TriageWalk::go(const std::vector<std::string>& files, const Read& read) {
  counts_.files = files.size();
  for (const std::string& file : files) {
    const Result<Work> work = read(file);
    // Somebody else may work on the same folder.
    if (std::error_code error; !work && !fs::exists(file, error)) continue;
    if (!work) {
      note(fmt::format("ccdfuzz: {}; it is left as it is\n", work.error().message()));
      ++counts_.files_unread;
      continue;
    }
    if (is_over_()) break;
    const Result<bool> worked = (*work)();
    if (!worked) return tl::unexpected(worked.error());
    // What was done in spite of that is done.
    if (!*worked && is_over_()) break;
    ++counts_.files_done;
    if (*worked && remove_) {
      std::error_code error;
      fs::remove(file, error);
      if (error) return input_error(file, "cannot be removed: " + error.message());
    }
    progress_.show(static_cast<double>(counts_.files_done) / static_cast<double>(counts_.files),
                   fmt::format("{} new", counts_.finds), counts_.files_done, "inputs");
  }
  progress_.clear();
  return {};
}

void TriageWalk::note(const std::string& line) {
  progress_.clear();
  print_err(line);
}

void TriageWalk::note_find() {
  progress_.clear();
  ++counts_.finds;
}

void print_triage(const TriageCounts& counts, const std::string& folder, bool json) {
  if (json) {
    print_json({{"row", "summary"},
                {"files", counts.files},
                {"files_done", counts.files_done},
                {"files_unread", counts.files_unread},
                {"inputs", counts.inputs},
                {"failures", counts.failures},
                {"known", counts.known},
                {"harmless", counts.harmless},
                {"refuting", counts.refuting},
                {"finds", counts.finds}});
  } else {
    print_out(fmt::format(
        "{} of {} files: {} failures, {} of them like one that is stored; {} inputs on which "
        "no full run fails; {} new in {}\n",
        counts.files_done, counts.files, counts.failures, counts.known, counts.harmless,
        counts.finds, folder));
    if (counts.refuting > 0) {
      print_out(
          fmt::format("{} refute a claim by no full run (see above), and stay\n", counts.refuting));
    }
  }
}

}  // namespace ccdfuzz
