#include "io/input_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "base/verify.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace fs = std::filesystem;

std::optional<CaseFileKind> case_file_kind_by_name(const std::string& path) {
  if (path.ends_with(".json")) return CaseFileKind::kJson;
  if (path.ends_with(".jsonl")) return CaseFileKind::kJsonLines;
  if (path.ends_with(".jsonl.zst")) return CaseFileKind::kJsonLinesZstd;
  return std::nullopt;
}

Result<CaseFileKind> case_file_kind(const std::string& path) {
  if (const auto kind = case_file_kind_by_name(path)) return *kind;
  if (path == "-") return input_error(path, "is no file; standard input is /dev/stdin");
  if (path == "/dev/stdin" || is_stream(path)) return CaseFileKind::kJsonLines;
  return input_error(path, "ends in none of .json, .jsonl, .jsonl.zst");
}

Result<void> refuse_irregular(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return {};
  return input_error(path, "is not a regular file");
}

Result<std::vector<std::string>> files_under(
    const std::string& folder, const std::function<bool(const std::string& name)>& is_left_out) {
  std::vector<std::string> files, folders{folder};
  while (!folders.empty()) {
    const std::string next = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    for (fs::directory_iterator at(next, error), end; !error && at != end; at.increment(error)) {
      if (is_left_out(at->path().filename())) continue;
      std::error_code gone;  // meanwhile
      const bool is_folder = at->symlink_status(gone).type() == fs::file_type::directory;
      (is_folder ? folders : files).push_back(at->path());
    }
    if (error) return system_error(next, "read", error.value());
  }
  std::ranges::sort(files);
  return files;
}

Result<InputBytes> InputBytes::open(const std::string& path, bool zstd) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return system_error(path, "read", EISDIR);
  InputBytes file;
  file.path_ = path;
  file.descriptor_ = Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (*file.descriptor_ < 0) return system_error(path, "read", errno);
  if (zstd) {
    file.stream_ = {ZSTD_createDStream(), ZSTD_freeDStream};
    CCDFUZZ_VERIFY(file.stream_ != nullptr);
  }
  return file;
}

Result<std::string> InputBytes::read_as_it_is(size_t most) {
  std::string bytes(most, '\0');
  ssize_t got = 0;
  do {
    got = ::read(*descriptor_, bytes.data(), bytes.size());
  } while (got < 0 && errno == EINTR);
  if (got < 0) return system_error(path_, "read", errno);
  bytes.resize(static_cast<size_t>(got));
  position_ += bytes.size();
  return bytes;
}

Result<std::string> InputBytes::read(size_t most) {
  if (!stream_) return read_as_it_is(most);
  std::string bytes(most, '\0');
  ZSTD_outBuffer out = {bytes.data(), bytes.size(), 0};
  while (out.pos == 0) {
    if (at_ == packed_.size() && !ended_) {
      CCDFUZZ_TRY(packed_, read_as_it_is(ZSTD_DStreamInSize()));
      at_ = 0;
      ended_ = packed_.empty();
    }
    ZSTD_inBuffer in = {packed_.data(), packed_.size(), at_};
    const size_t status = ZSTD_decompressStream(stream_.get(), &out, &in);
    if (ZSTD_isError(status) != 0) {
      return input_error(path_, "is not sound zstd data: {}", ZSTD_getErrorName(status));
    }
    if (in.pos != at_ || out.pos != 0) inside_frame_ = status != 0;
    at_ = in.pos;
    if (out.pos == 0 && ended_ && at_ == packed_.size()) {
      if (inside_frame_) return input_error(path_, "is truncated: its zstd data end too early");
      break;
    }
  }
  bytes.resize(out.pos);
  return bytes;
}

}  // namespace ccdfuzz
