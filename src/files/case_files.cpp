#include "files/case_files.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "base/verify.hpp"
#include "files/case_json.hpp"
#include "io/line_reader.hpp"

namespace ccdfuzz {

/// The cases of a file one after the other.
class CaseFile {
 public:
  virtual ~CaseFile() = default;

  /// The next case; nothing at the end, but an error where there was none at all.
  virtual Result<std::optional<NamedCase>> next() = 0;
  /// Bytes of the file, which may be compressed, read so far.
  virtual std::uint64_t position() const = 0;
};

namespace {

namespace fs = std::filesystem;

constexpr size_t kPiece = 1 << 16;

/// The size of a file; 0 for a pipe and for what is not there.
std::uint64_t size_of(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path, none);
  return none ? 0 : size;
}

/// .json, .jsonl and .jsonl.zst.
class JsonCases : public CaseFile {
 public:
  JsonCases(LineReader lines, CaseFileKind kind) : lines_(std::move(lines)), kind_(kind) {}

  Result<std::optional<NamedCase>> next() override {
    const bool whole = kind_ == CaseFileKind::kJson;
    if (whole && any_) return std::nullopt;
    for (;;) {
      CCDFUZZ_TRY(const auto text, lines_.next(whole));
      const bool blank = !text || trimmed(*text).empty();
      if (blank && (whole || !text)) {
        if (any_) return std::nullopt;
        const bool is_empty = lines_.line() == 0 || whole;
        return input_error(lines_.path(), "{}; JSON with cases is accepted",
                           is_empty ? "is empty" : "holds no case");
      }
      if (blank) {
        if (++blank_lines_ <= kMostBlankLines) continue;
        return input_error(lines_.here(), "is one of more than {} blank lines", kMostBlankLines);
      }
      std::string_view json = *text;
      std::string of_many_lines;  // one case, as finds are kept
      if (!whole && !any_ && trimmed(json) == "{") {
        CCDFUZZ_TRY(const auto rest, lines_.next(true));
        of_many_lines = fmt::format("{{{}", rest.value_or(""));
        json = of_many_lines;
      }
      const std::string id = whole || !of_many_lines.empty() ? lines_.path() : lines_.here();
      CCDFUZZ_TRY(auto value, parse_case(json, id));
      any_ = true;
      return NamedCase{id, std::move(value), lines_.path()};
    }
  }
  std::uint64_t position() const override { return lines_.position(); }

 private:
  /// Compressed, gigabytes of them are a small file.
  static constexpr std::uint64_t kMostBlankLines = 1000;

  LineReader lines_;
  CaseFileKind kind_;
  bool any_ = false;  ///< gave a case
  std::uint64_t blank_lines_ = 0;
};

/// A query CSV.
class CsvCases : public CaseFile {
 public:
  CsvCases(CsvReader reader, CsvOptions csv) : reader_(std::move(reader)), csv_(std::move(csv)) {}

  Result<std::optional<NamedCase>> next() override {
    CCDFUZZ_TRY(auto rows, reader_.next());
    if (!rows) return std::nullopt;
    CCDFUZZ_TRY(auto value, to_case(*rows, csv_, index_++));
    const CsvQuery& query = *rows;
    return NamedCase{query.id(), std::move(value), query.path,
                     std::make_shared<const CsvQuery>(*std::move(rows))};
  }
  std::uint64_t position() const override { return reader_.position(); }

 private:
  CsvReader reader_;
  CsvOptions csv_;
  std::uint64_t index_ = 0;
};

Result<std::vector<std::string>> csv_files_in(const std::string& folder) {
  CCDFUZZ_TRY(auto files, files_under(folder, [](const std::string&) { return false; }));
  std::erase_if(files, [](const std::string& path) {
    std::error_code vanished;
    return !path.ends_with(".csv") || !fs::is_regular_file(path, vanished);
  });
  if (files.empty())
    return input_error(folder,
                       "is a folder without a .csv in it; accepted are such folders, and files of "
                       "cases: .json, .jsonl, .jsonl.zst, .csv");
  return files;
}

Result<std::unique_ptr<CaseFile>> open_cases(const std::string& path, const CsvOptions& csv) {
  if (csv.any_name || path.ends_with(".csv")) {
    CCDFUZZ_TRY(auto reader, CsvReader::open(path, csv));
    return std::make_unique<CsvCases>(std::move(reader), csv);
  }
  if (path == "-") return tl::unexpected(case_file_kind(path).error());
  // A wrong name is told as such before a wrong ending.
  CCDFUZZ_TRY(auto lines, LineReader::open(path, path.ends_with(".zst"), kMaxCaseBytes));
  const auto kind = case_file_kind(path);
  if (!kind) return input_error(path, "ends in none of .json, .jsonl, .jsonl.zst, .csv");
  return std::make_unique<JsonCases>(std::move(lines), *kind);
}

}  // namespace

void SourceBytes::add(const NamedCase& named) {
  if (bytes_ > 0 && named.file == file_) return;
  file_ = named.file;
  const std::uint64_t size = size_of(file_);
  is_known_ = is_known_ && size > 0;
  bytes_ += size;
}

std::uint64_t SourceBytes::times(std::uint64_t each) const {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return is_known_ && bytes_ < kMost / each ? bytes_ * each : kMost;
}

Result<std::vector<std::string>> case_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  const auto is_of_costs = [](const std::string& path) { return path.ends_with(kCostsEnding); };
  const bool has_others = !std::ranges::all_of(paths, is_of_costs);
  for (const std::string& path : paths) {
    if (has_others && is_of_costs(path)) continue;
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) {
      files.push_back(path);
      continue;
    }
    CCDFUZZ_TRY(const auto in_folder, csv_files_in(path));
    files.insert(files.end(), in_folder.begin(), in_folder.end());
  }
  return files;
}

CaseStream::CaseStream(const std::vector<std::string>& paths, CsvOptions csv)
    : paths_(case_files(paths)), csv_(std::move(csv)) {
  if (!paths_) return;
  for (const std::string& path : *paths_) size_ += size_of(path);
}

CaseStream::~CaseStream() = default;

Result<std::optional<NamedCase>> CaseStream::next() {
  if (!paths_) return tl::unexpected(paths_.error());
  for (; index_ < paths_->size(); ++index_) {
    const std::string& path = (*paths_)[index_];
    if (!file_) {
      CCDFUZZ_TRY(file_, open_cases(path, csv_));
    }
    auto given = file_->next();
    if (given && *given && size_ > 0) {
      const auto read = static_cast<double>(size_before_ + file_->position());
      (*given)->share = std::min(1.0, read / static_cast<double>(size_));
    }
    if (!given || *given) return given;
    size_before_ += size_of(path);
    file_.reset();
  }
  return std::nullopt;
}

Result<NamedCase> read_case(const std::string& path) {
  CaseStream stream({path});
  CCDFUZZ_TRY(auto first, stream.next());
  CCDFUZZ_TRY(const auto second, stream.next());
  if (second) return input_error(path, "holds more than one case");
  return *std::move(first);
}

Result<CaseWriter> CaseWriter::open(const std::string& path) {
  CCDFUZZ_TRY(const auto kind, case_file_kind(path));
  CCDFUZZ_TRY(auto file, OutputFile::create(path));
  CaseWriter writer(std::move(file));
  writer.path_ = path;
  writer.kind_ = kind;
  writer.piece_ = is_stream(path) ? 0 : kPiece;
  if (kind == CaseFileKind::kJsonLinesZstd) {
    writer.zstd_ = {ZSTD_createCCtx(), ZSTD_freeCCtx};
    CCDFUZZ_VERIFY(writer.zstd_ != nullptr);
    ZSTD_CCtx_setParameter(writer.zstd_.get(), ZSTD_c_checksumFlag, 1);
  }
  return writer;
}

/// Hands the pending text on, compressed where that is asked for.
Result<void> CaseWriter::flush(bool last) {
  const std::string text = std::exchange(pending_, {});
  if (!zstd_) return file_.write(text);
  std::string out(ZSTD_CStreamOutSize(), '\0');
  ZSTD_inBuffer in = {text.data(), text.size(), 0};
  for (bool done = false; !done;) {
    ZSTD_outBuffer packed = {out.data(), out.size(), 0};
    const size_t left =
        ZSTD_compressStream2(zstd_.get(), &packed, &in, last ? ZSTD_e_end : ZSTD_e_continue);
    CCDFUZZ_VERIFY(ZSTD_isError(left) == 0);
    CCDFUZZ_TRY_VOID(file_.write(std::string_view(out).substr(0, packed.pos)));
    done = last ? left == 0 : in.pos == in.size;
  }
  return {};
}

Result<void> CaseWriter::write(const Case& value) {
  const bool is_one = kind_ == CaseFileKind::kJson;
  if (is_one && written_ == 1) {
    return input_error(path_, "a .json file holds one case; .jsonl holds many");
  }
  ++written_;
  pending_ += to_json(value, is_one ? JsonLayout::kReadable : JsonLayout::kOneLine) + '\n';
  return pending_.size() < piece_ ? Result<void>() : flush(false);
}

Result<void> CaseWriter::complete() {
  if (kind_ == CaseFileKind::kJson && written_ == 0) {
    return input_error(path_, "no case to write");
  }
  return std::exchange(is_complete_, true) ? Result<void>() : flush(true);
}

Result<void> CaseWriter::finish() {
  return complete().and_then([this] { return file_.commit(); });
}

}  // namespace ccdfuzz
