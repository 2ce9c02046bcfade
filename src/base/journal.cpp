#include "base/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <cerrno>
#include <optional>

#include "base/output_file.hpp"

namespace ccdfuzz {

namespace {

constexpr std::string_view kJournalLine = "ccdfuzz-journal 1\n";
constexpr size_t kFrameHead = 16;
/// No record comes near this; it keeps a wrong length from being allocated.
constexpr std::uint64_t kMaxRecord = 64 << 20;

void put_number(std::string& to, std::uint64_t x) {
  for (int i = 0; i < 8; ++i) to += static_cast<char>((x >> (8 * i)) & 0xff);
}

std::uint64_t number_at(std::string_view bytes) {
  std::uint64_t x = 0;
  for (size_t i = 0; i < 8; ++i)
    x |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return x;
}

/// Up to `length` bytes from `offset` on, fewer at the end of the file.
Result<std::string> read_at(const std::string& path, int descriptor, std::uint64_t offset,
                            size_t length) {
  std::string bytes(length, '\0');
  size_t done = 0;
  while (done < length) {
    const ssize_t got =
        ::pread(descriptor, bytes.data() + done, length - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(path, "read", errno);
    if (got == 0) break;
    done += static_cast<size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

/// The bytes of the frame at `offset`; nothing if no whole and sound one is there.
Result<std::optional<std::string>> frame_at(const std::string& path, int descriptor,
                                            std::uint64_t offset) {
  const auto head = read_at(path, descriptor, offset, kFrameHead);
  if (!head) return tl::unexpected(head.error());
  if (head->size() < kFrameHead) return std::nullopt;
  const std::uint64_t length = number_at(*head);
  if (length > kMaxRecord) return std::nullopt;
  auto bytes = read_at(path, descriptor, offset + kFrameHead, length);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::uint64_t hash = number_at(std::string_view(*head).substr(8));
  if (bytes->size() < length || XXH3_64bits(bytes->data(), length) != hash) return std::nullopt;
  return *std::move(bytes);
}

std::string header_text(const Journal::Header& header) {
  std::string text;
  for (const auto& [name, value] : header) text += fmt::format("{}\t{}\n", name, value);
  return text;
}

/// The value of a name in the text of a header; nothing if it is not there.
std::optional<std::string> value_in(const std::string& text, const std::string& name) {
  const std::string start = name + "\t";
  size_t at = text.starts_with(start) ? 0 : text.find("\n" + start);
  if (at == std::string::npos) return std::nullopt;
  at = text.find('\t', at) + 1;
  return text.substr(at, text.find('\n', at) - at);
}

/// The text of the journal's header; nothing if it was killed before there was anything in it.
/// Errors: it belongs to a run with another header; it is no journal.
Result<std::optional<std::string>> matching_header(const std::string& path, int descriptor,
                                                   const Journal::Header& header) {
  const auto line = read_at(path, descriptor, 0, kJournalLine.size());
  if (!line) return tl::unexpected(line.error());
  if (!kJournalLine.starts_with(*line)) {
    return input_error(path, "is not the journal of a run; it is in the way");
  }
  auto text = frame_at(path, descriptor, kJournalLine.size());
  if (!text || !*text) return text;
  for (const auto& [name, value] : header) {
    const std::optional<std::string> theirs = value_in(**text, name);
    if (theirs != value) {
      return input_error(path, fmt::format("belongs to a run with {} {}, and this one has {}; "
                                           "take the file away to begin anew",
                                           name, theirs.value_or("not given"), value));
    }
  }
  if (**text != header_text(header)) {
    return input_error(path, "belongs to a run of another kind; take the file away to begin anew");
  }
  return text;
}

std::uint64_t end_of_header(const std::string& text) {
  return kJournalLine.size() + kFrameHead + text.size();
}

/// Hands on the records from `at` to the last whole one; returns where that ends.
Result<std::uint64_t> walk_records(const std::string& path, int descriptor, std::uint64_t at,
                                   const std::function<void(std::string&&)>& visit) {
  for (;;) {
    auto record = frame_at(path, descriptor, at);
    if (!record) return tl::unexpected(record.error());
    if (!*record) return at;
    at += kFrameHead + (*record)->size();
    visit(**std::move(record));
  }
}

/// True iff the descriptor's file is the one that stands at the path.
bool stands_at(const std::string& path, int descriptor) {
  struct stat named {
  }, held{};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &held) == 0 &&
         named.st_dev == held.st_dev && named.st_ino == held.st_ino;
}

/// Some file systems of clusters know no locks; there it is for the user to run one at a time.
bool is_without_locks(int error) {
  return error == ENOSYS || error == EOPNOTSUPP || error == ENOLCK;
}

}  // namespace

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      first_record_(other.first_record_) {}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<Journal> Journal::open(const std::string& path, const Header& header) {
  for (;;) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) return system_error(path, "write", errno);
    Journal journal(path, descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && !is_without_locks(errno)) {
      if (errno == EWOULDBLOCK) return input_error(path, "another process is at this run");
      return system_error(path, "lock", errno);
    }
    // The one who held it before may have finished and taken it away.
    if (!stands_at(path, descriptor)) continue;
    if (auto resumed = journal.resume(header); !resumed) return tl::unexpected(resumed.error());
    return journal;
  }
}

Result<std::vector<std::string>> Journal::read(const std::string& path, const Header& header) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return system_error(path, "read", errno);
  const Journal closes(path, descriptor);
  std::vector<std::string> records;
  const auto text = matching_header(path, descriptor, header);
  if (!text) return tl::unexpected(text.error());
  if (!*text) return records;
  return walk_records(path, descriptor, end_of_header(**text),
                      [&](std::string&& record) { records.push_back(std::move(record)); })
      .map([&](std::uint64_t) { return records; });
}

Result<void> Journal::begin(const Header& header) {
  if (::ftruncate(descriptor_, 0) != 0) return system_error(path_, "write", errno);
  const std::string text = header_text(header);
  std::string bytes(kJournalLine);
  put_number(bytes, text.size());
  put_number(bytes, XXH3_64bits(text.data(), text.size()));
  bytes += text;
  first_record_ = bytes.size();
  if (::pwrite(descriptor_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    return system_error(path_, "write", errno);
  }
  return ::lseek(descriptor_, 0, SEEK_END) < 0 ? system_error(path_, "write", errno)
                                               : Result<void>();
}

Result<void> Journal::resume(const Header& header) {
  const auto text = matching_header(path_, descriptor_, header);
  if (!text) return tl::unexpected(text.error());
  if (!*text) return begin(header);
  first_record_ = end_of_header(**text);
  const auto end = walk_records(path_, descriptor_, first_record_, [&](std::string&&) { ++size_; });
  if (!end) return tl::unexpected(end.error());
  if (::ftruncate(descriptor_, static_cast<off_t>(*end)) != 0 ||
      ::lseek(descriptor_, 0, SEEK_END) < 0) {
    return system_error(path_, "write", errno);
  }
  return {};
}

Result<void> Journal::append(std::string_view record) {
  std::string bytes;
  bytes.reserve(kFrameHead + record.size());
  put_number(bytes, record.size());
  put_number(bytes, XXH3_64bits(record.data(), record.size()));
  bytes += record;
  for (std::string_view left = bytes; !left.empty();) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return system_error(path_, "write", errno);
    left.remove_prefix(static_cast<size_t>(written));
  }
  ++size_;
  return {};
}

Result<void> Journal::for_each(const std::function<Result<void>(std::string_view)>& visit) const {
  std::uint64_t at = first_record_;
  for (std::uint64_t i = 0; i < size_; ++i) {
    const auto record = frame_at(path_, descriptor_, at);
    if (!record) return tl::unexpected(record.error());
    if (!*record) return input_error(path_, "was changed by something else");
    at += kFrameHead + (*record)->size();
    if (auto visited = visit(**record); !visited) return visited;
  }
  return {};
}

Result<void> Journal::remove() {
  if (::unlink(path_.c_str()) != 0) return system_error(path_, "remove", errno);
  return {};
}

}  // namespace ccdfuzz
