#include "case/case_files.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>

#include "base/line_reader.hpp"
#include "base/output_file.hpp"
#include "base/verify.hpp"
#include "case/case_json.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kPiece = 1 << 16;

/// Of a file; 0 of a pipe and of what is not there.
std::uint64_t size_of(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  return none ? 0 : size;
}

}  // namespace

struct CaseReader::State {
  LineReader lines;
  CaseFileKind kind = CaseFileKind::kJson;
  bool any = false;  ///< gave a case
  std::uint64_t bytes_given = 0;
  /// Compressed, gigabytes of them are a small file.
  static constexpr std::uint64_t kMostBlankLines = 1000;
  std::uint64_t blank_lines = 0;

  Result<std::optional<NamedCase>> next() {
    const bool whole = kind == CaseFileKind::kJson;
    if (whole && any) return std::nullopt;
    for (;;) {
      const auto text = lines.next(whole);
      if (!text) return tl::unexpected(text.error());
      const bool blank = !*text || trimmed(**text).empty();
      if (blank && (whole || !*text)) {
        if (any) return std::nullopt;
        const bool is_empty = lines.line() == 0 || whole;
        return input_error(lines.path(), is_empty ? "is empty" : "holds no case");
      }
      if (blank) {
        if (++blank_lines <= kMostBlankLines) continue;
        return input_error(fmt::format("{}:{}", lines.path(), lines.line()),
                           fmt::format("is one of more than {} blank lines", kMostBlankLines));
      }
      const std::string id =
          whole ? lines.path() : fmt::format("{}:{}", lines.path(), lines.line());
      auto value = parse_case(**text, id);
      if (!value) return tl::unexpected(value.error());
      any = true;
      bytes_given += (*text)->size();
      return NamedCase{id, *std::move(value), lines.path()};
    }
  }
};

CaseReader::CaseReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
CaseReader::CaseReader(CaseReader&&) noexcept = default;
CaseReader& CaseReader::operator=(CaseReader&&) noexcept = default;
CaseReader::~CaseReader() = default;

Result<CaseReader> CaseReader::open(const std::string& path) {
  // A wrong name is told as such before a wrong ending.
  auto lines = LineReader::open(path, path.ends_with(".zst"), kMaxCaseBytes);
  if (!lines) return tl::unexpected(lines.error());
  const auto kind = case_file_kind(path);
  if (!kind) return tl::unexpected(kind.error());
  return CaseReader(std::make_unique<State>(State{*std::move(lines), *kind}));
}

Result<std::optional<NamedCase>> CaseReader::next() {
  return state_->next();
}

std::uint64_t CaseReader::bytes_given() const {
  return state_->bytes_given;
}

std::uint64_t CaseReader::position() const {
  return state_->lines.position();
}

CaseStream::CaseStream(std::vector<std::string> paths) : paths_(std::move(paths)) {
  for (const std::string& path : paths_) size_ += size_of(path);
}

Result<std::optional<NamedCase>> CaseStream::next() {
  for (; file_ < paths_.size(); ++file_) {
    if (!reader_) {
      auto opened = CaseReader::open(paths_[file_]);
      if (!opened) return tl::unexpected(opened.error());
      reader_ = *std::move(opened);
    }
    auto given = reader_->next();
    if (!given || *given) return given;
    size_before_ += size_of(paths_[file_]);
    given_before_ += reader_->bytes_given();
    reader_.reset();
  }
  return std::nullopt;
}

double CaseStream::share() const {
  const std::uint64_t read = size_before_ + (reader_ ? reader_->position() : 0);
  return size_ == 0 ? 0 : std::min(1.0, static_cast<double>(read) / static_cast<double>(size_));
}

std::uint64_t CaseStream::bytes_given() const {
  return given_before_ + (reader_ ? reader_->bytes_given() : 0);
}

Result<NamedCase> read_case(const std::string& path) {
  CaseStream stream({path});
  auto first = stream.next();
  if (!first) return tl::unexpected(first.error());
  const auto second = stream.next();
  if (!second) return tl::unexpected(second.error());
  if (*second) return input_error(path, "holds more than one case");
  return **std::move(first);
}

Result<std::vector<NamedCase>> read_cases(const std::vector<std::string>& paths) {
  std::vector<NamedCase> cases;
  CaseStream stream(paths);
  for (;;) {
    auto next = stream.next();
    if (!next) return tl::unexpected(next.error());
    if (!*next) return cases;
    if (stream.bytes_given() + cases.size() * sizeof(NamedCase) > kMostBytesHeld) {
      return input_error((*next)->id,
                         fmt::format("the cases so far take more than {} bytes, the most that this "
                                     "command holds in memory",
                                     kMostBytesHeld));
    }
    cases.push_back(**std::move(next));
  }
}

Result<std::vector<NamedCase>> read_cases(const std::string& path) {
  return read_cases(std::vector{path});
}

struct CaseWriter::State {
  struct FreeContext {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  };

  std::string path;
  CaseFileKind kind;
  OutputFile file;
  std::string pending;
  size_t written = 0;
  std::unique_ptr<ZSTD_CCtx, FreeContext> zstd;

  /// Hands the pending text on, compressed where that is asked for.
  Result<void> flush(bool last) {
    if (!zstd) {
      auto done = file.write(pending);
      pending.clear();
      return done;
    }
    std::string out(ZSTD_CStreamOutSize(), '\0');
    ZSTD_inBuffer in = {pending.data(), pending.size(), 0};
    for (bool done = false; !done;) {
      ZSTD_outBuffer packed = {out.data(), out.size(), 0};
      const size_t left =
          ZSTD_compressStream2(zstd.get(), &packed, &in, last ? ZSTD_e_end : ZSTD_e_continue);
      CCDFUZZ_VERIFY(ZSTD_isError(left) == 0);
      if (auto r = file.write(std::string_view(out).substr(0, packed.pos)); !r) return r;
      done = last ? left == 0 : in.pos == in.size;
    }
    pending.clear();
    return {};
  }
};

CaseWriter::CaseWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
CaseWriter::CaseWriter(CaseWriter&&) noexcept = default;
CaseWriter& CaseWriter::operator=(CaseWriter&&) noexcept = default;
CaseWriter::~CaseWriter() = default;

Result<CaseWriter> CaseWriter::open(const std::string& path) {
  const auto kind = case_file_kind(path);
  if (!kind) return tl::unexpected(kind.error());
  auto file = OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  auto state = std::make_unique<State>(State{path, *kind, *std::move(file), {}, 0, {}});
  if (*kind == CaseFileKind::kJsonLinesZstd) {
    state->zstd.reset(ZSTD_createCCtx());
    CCDFUZZ_VERIFY(state->zstd != nullptr);
    ZSTD_CCtx_setParameter(state->zstd.get(), ZSTD_c_checksumFlag, 1);
  }
  return CaseWriter(std::move(state));
}

Result<void> CaseWriter::write(const Case& value) {
  State& s = *state_;
  if (s.kind == CaseFileKind::kJson && s.written == 1) {
    return input_error(s.path, "a .json file holds one case; .jsonl holds many");
  }
  ++s.written;
  s.pending +=
      to_json(value, s.kind == CaseFileKind::kJson ? JsonLayout::kReadable : JsonLayout::kOneLine);
  s.pending += '\n';
  return s.pending.size() < kPiece ? Result<void>() : s.flush(false);
}

Result<void> CaseWriter::finish() {
  State& s = *state_;
  if (s.kind == CaseFileKind::kJson && s.written == 0) {
    return input_error(s.path, "no case to write");
  }
  if (auto flushed = s.flush(true); !flushed) return flushed;
  return s.file.commit();
}

}  // namespace ccdfuzz
