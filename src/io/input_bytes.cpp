#include "io/input_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "base/verify.hpp"
#include "io/descriptor.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

class PlainFile : public InputBytes {
 public:
  PlainFile(std::string path, Descriptor descriptor)
      : path_(std::move(path)), descriptor_(std::move(descriptor)) {}

  Result<std::string> read(size_t most) override {
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
  std::uint64_t position() const override { return position_; }

 private:
  std::string path_;
  Descriptor descriptor_;
  std::uint64_t position_ = 0;
};

class ZstdFile : public InputBytes {
 public:
  ZstdFile(std::string path, std::unique_ptr<InputBytes> packed)
      : path_(std::move(path)), packed_(std::move(packed)), stream_(ZSTD_createDStream()) {
    CCDFUZZ_VERIFY(stream_ != nullptr);
  }

  Result<std::string> read(size_t most) override {
    std::string bytes(most, '\0');
    ZSTD_outBuffer out = {bytes.data(), bytes.size(), 0};
    while (out.pos == 0) {
      if (at_ == input_.size() && !ended_) {
        CCDFUZZ_TRY(input_, packed_->read(ZSTD_DStreamInSize()));
        at_ = 0;
        ended_ = input_.empty();
      }
      ZSTD_inBuffer in = {input_.data(), input_.size(), at_};
      const size_t status = ZSTD_decompressStream(stream_.get(), &out, &in);
      if (ZSTD_isError(status) != 0) {
        return input_error(path_,
                           fmt::format("is not sound zstd data: {}", ZSTD_getErrorName(status)));
      }
      if (in.pos != at_ || out.pos != 0) inside_frame_ = status != 0;
      at_ = in.pos;
      if (out.pos == 0 && ended_ && at_ == input_.size()) {
        if (inside_frame_) return input_error(path_, "is truncated: its zstd data end too early");
        break;
      }
    }
    bytes.resize(out.pos);
    return bytes;
  }
  std::uint64_t position() const override { return packed_->position(); }

 private:
  struct FreeStream {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
  };

  std::string path_;
  std::unique_ptr<InputBytes> packed_;
  std::unique_ptr<ZSTD_DStream, FreeStream> stream_;
  std::string input_;
  size_t at_ = 0;
  bool ended_ = false;
  bool inside_frame_ = false;
};

}  // namespace

std::optional<CaseFileKind> case_file_kind_by_name(const std::string& path) {
  if (path.ends_with(".json")) return CaseFileKind::kJson;
  if (path.ends_with(".jsonl")) return CaseFileKind::kJsonLines;
  if (path.ends_with(".jsonl.zst")) return CaseFileKind::kJsonLinesZstd;
  return std::nullopt;
}

Result<CaseFileKind> case_file_kind(const std::string& path) {
  if (const auto kind = case_file_kind_by_name(path)) return *kind;
  if (is_stream(path)) return CaseFileKind::kJsonLines;
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

Result<std::unique_ptr<InputBytes>> open_input(const std::string& path, bool zstd) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return system_error(path, "read", EISDIR);
  Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (*descriptor < 0) return system_error(path, "read", errno);
  std::unique_ptr<InputBytes> file = std::make_unique<PlainFile>(path, std::move(descriptor));
  if (zstd) file = std::make_unique<ZstdFile>(path, std::move(file));
  return file;
}

Result<std::string> read_file(const std::string& path, size_t most) {
  constexpr size_t kPiece = 1 << 16;
  CCDFUZZ_TRY_VOID(refuse_irregular(path));
  CCDFUZZ_TRY(auto file, open_input(path, false));
  std::string bytes;
  for (;;) {
    const Result<std::string> piece = file->read(kPiece);
    if (!piece || piece->empty()) return piece.map([&](const auto&) { return std::move(bytes); });
    bytes += *piece;
    if (bytes.size() > most) {
      return input_error(path, fmt::format("has more than {} bytes", most));
    }
  }
}

}  // namespace ccdfuzz
