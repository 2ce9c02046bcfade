#include "cli/triage_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "cli/session.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

namespace {

/// The largest input of libFuzzer by default (-max_len).
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
  return read_file(path, kMostInputBytes).map([](const std::string& bytes) {
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  });
}

void TriageWalk::go(const std::vector<std::string>& files, const Read& read) {
  counts_.files = files.size();
  for (const std::string& file : files) {
    const Result<Work> work = read(file);
    // Somebody else may work on the same folder.
    if (std::error_code error; !work && !fs::exists(file, error)) continue;
    if (!work) {
      note(fmt::format("ccdfuzz: triage: {}; it is left as it is\n", work.error().message()));
      ++counts_.files_unread;
      continue;
    }
    if (is_over_()) break;
    const bool is_done = (*work)();
    // Work that was done in spite of that counts.
    if (!is_done && is_over_()) break;
    ++counts_.files_done;
    if (is_done && remove_) {
      std::error_code error;
      fs::remove(file, error);
      if (error) throw BadInput{{file, "cannot be removed: " + error.message()}};
    }
    progress_.show(static_cast<double>(counts_.files_done) / static_cast<double>(counts_.files),
                   fmt::format("{} new", counts_.finds), counts_.files_done, "inputs");
  }
  progress_.clear();
}

void TriageWalk::note(const std::string& line) {
  progress_.clear();
  print_err(line);
}

void TriageWalk::note_find() {
  progress_.clear();
  ++counts_.finds;
}

std::string to_text(const TriageCounts& counts, const std::string& folder) {
  const TriageTally& tally = counts.tally;
  std::string text = fmt::format(
      "{} of {} files: {} failures, {} of them like one that is stored; {} inputs on which "
      "no full run fails; {} new in {}",
      counts.files_done, counts.files, tally.failures, tally.known, tally.harmless, counts.finds,
      folder);
  if (tally.refuting == 0) return text;
  return fmt::format("{}\n{} refute a claim by no full run (see above), and stay", text,
                     tally.refuting);
}

}  // namespace ccdfuzz
