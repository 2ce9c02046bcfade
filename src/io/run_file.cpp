#include "io/run_file.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "io/fields.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// No item comes near this; it bounds the memory that a wrong file takes.
constexpr size_t kLongestLine = 64 << 20;

/// The header's parts except the share, by name.
std::map<std::string, std::string> parts_of(const RunHeader& header) {
  std::map<std::string, std::string> parts = header.asked;
  parts["run"] = header.run;
  parts["ccdfuzz"] = header.version;
  parts["inputs"] = fmt::format("{}", fmt::join(header.inputs, " "));
  parts["items"] = fmt::format("{}", header.items);
  return parts;
}

std::string text_of(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.of);
}

}  // namespace

std::optional<std::string> RunHeader::difference(const RunHeader& other) const {
  const std::map<std::string, std::string> ours = parts_of(*this);
  std::map<std::string, std::string> theirs = parts_of(other);
  for (const auto& [name, value] : ours) {
    const auto found = theirs.find(name);
    if (found == theirs.end()) return fmt::format("no {} in place of {}", name, value);
    if (found->second != value) {
      return fmt::format("{} {} in place of {}", name, found->second, value);
    }
    theirs.erase(found);
  }
  if (theirs.empty()) return std::nullopt;
  return fmt::format("{} {}, which was not given here", theirs.begin()->first,
                     theirs.begin()->second);
}

Result<RunLines> RunLines::open(const std::string& path, std::uint64_t most) {
  CCDFUZZ_TRY_VOID(refuse_irregular(path));
  CCDFUZZ_TRY(LineReader lines, LineReader::open(path, false, kLongestLine));
  RunLines run(std::move(lines));
  run.most_ = most;
  CCDFUZZ_TRY(const auto first, run.next_whole());
  if (!first) return input_error(path, "is not the file of a run");
  Result<RunHeader> header = from_json<RunHeader>(*first, path);
  if (!header) {
    return input_error(header.error().where,
                       header.error().what +
                           ": this is neither the file of a run nor a share, as --shard makes it");
  }
  run.header_ = *std::move(header);
  const Shard& shard = run.header_.shard;
  if (shard.index >= shard.of) return input_error(path, "shard: there is no such share");
  return run;
}

Result<std::optional<std::string_view>> RunLines::next() {
  if (given_ == most_) return std::nullopt;
  auto line = next_whole();
  if (!line || !*line) return line;
  const std::uint64_t place = given_++;
  if (header_.items == 0) return line;
  const Shard& shard = header_.shard;
  if (place == shard.size(header_.items)) {
    return input_error(where(), "the share has more than its items");
  }
  const std::uint64_t item = shard.item(place);
  if (!(*line)->starts_with(fmt::format("{{\"index\":{},", item))) {
    return input_error(where(), "is not the line of item {}", item);
  }
  return line;
}

Result<std::optional<std::string_view>> RunLines::next_whole() {
  auto line = lines_.next();
  if (!line || !*line || !lines_.is_ended()) {
    return line ? std::optional<std::string_view>() : line;
  }
  bytes_ += (*line)->size() + 1;
  return line;
}

Result<RunFile> RunFile::open(const std::string& path, const RunHeader& header) {
  for (;;) {
    RunFile file(path,
                 Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)));
    const int descriptor = *file.descriptor_;
    if (descriptor < 0) return system_error(path, "write", errno);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && !is_without_locks(errno)) {
      if (errno == EWOULDBLOCK) return input_error(path, "another process is at this run");
      return system_error(path, "lock", errno);
    }
    // The one who held it before may have finished and taken it away.
    if (!is_path_of(path, descriptor)) continue;
    CCDFUZZ_TRY_VOID(file.resume(header));
    return file;
  }
}

Result<void> RunFile::begin(const RunHeader& header) {
  if (::ftruncate(*descriptor_, 0) != 0) return system_error(path_, "write", errno);
  return write(to_json(header) + "\n");
}

Result<void> RunFile::resume(const RunHeader& header) {
  // A run that was killed at once leaves a part of the header's line.
  const std::string first = to_json(header) + "\n";
  std::string begun(first.size(), '\0');
  const ssize_t got = ::pread(*descriptor_, begun.data(), begun.size(), 0);
  if (got < 0) return system_error(path_, "read", errno);
  begun.resize(static_cast<size_t>(got));
  if (begun.size() < first.size() && first.starts_with(begun)) return begin(header);

  auto lines = RunLines::open(path_);
  if (!lines) {
    return input_error(path_, "is not the file of this run, and in the way: " + lines.error().what);
  }
  const RunHeader& theirs = lines->header();
  auto other = header.difference(theirs);
  if (!other && theirs.shard != header.shard) {
    other = fmt::format("--shard {} in place of {}", text_of(theirs.shard), text_of(header.shard));
  }
  if (other) {
    return input_error(path_, "belongs to a run with {}; take the file away to begin anew", *other);
  }
  for (;;) {
    CCDFUZZ_TRY(const auto line, lines->next());
    if (!line) break;
    ++size_;
  }
  if (::ftruncate(*descriptor_, static_cast<off_t>(lines->bytes())) == 0) return {};
  return system_error(path_, "write", errno);
}

Result<void> RunFile::append(std::string_view line) {
  return write(std::string(line) + "\n").map([this] { ++size_; });
}

Result<void> RunFile::write(std::string_view bytes) {
  if (const int error = write_all(*descriptor_, bytes)) return system_error(path_, "write", error);
  return {};
}

Result<void> RunFile::rename(const std::string& output) {
  if (::fsync(*descriptor_) != 0) return system_error(path_, "write", errno);
  if (::rename(path_.c_str(), output.c_str()) != 0) return system_error(output, "write", errno);
  return {};
}

Result<void> RunFile::remove() {
  if (::unlink(path_.c_str()) != 0) return system_error(path_, "remove", errno);
  return {};
}

Result<MergedRun> MergedRun::open(const std::vector<std::string>& paths) {
  std::map<std::uint64_t, RunLines> shares;
  MergedRun merged;
  for (const std::string& path : paths) {
    CCDFUZZ_TRY(RunLines lines, RunLines::open(path));
    const RunHeader& header = lines.header();
    const Shard shard = header.shard;
    if (shares.empty()) merged.header_ = header;
    if (const auto other = merged.header_.difference(header)) {
      return input_error(path, "is of another run than {}: {}", paths[0], *other);
    }
    if (shard.of != merged.header_.shard.of) {
      return input_error(path, "is one of {} shares, and {} of {}", shard.of, paths[0],
                         merged.header_.shard.of);
    }
    if (!shares.emplace(shard.index, std::move(lines)).second) {
      return input_error(path, "share {} is there twice", text_of(shard));
    }
  }
  const std::uint64_t of = std::exchange(merged.header_.shard, Shard()).of;
  for (std::uint64_t i = 0; i < of; ++i) {
    const auto share = shares.find(i);
    if (share == shares.end()) {
      return input_error("input", "share {} is missing", text_of({i, of}));
    }
    merged.shares_.push_back(std::move(share->second));
  }
  return merged;
}

Result<std::optional<std::string_view>> MergedRun::next() {
  at_ = given_ % shares_.size();
  CCDFUZZ_TRY(auto line, shares_[at_].next());
  if (given_ < header_.items && !line) {
    return input_error(shares_[at_].where(), "the share is not complete: its run is to go on");
  }
  if (given_ < header_.items) {
    ++given_;
    return line;
  }
  for (RunLines& share : shares_) {
    CCDFUZZ_TRY_VOID(share.next());
  }
  return line;
}

}  // namespace ccdfuzz
