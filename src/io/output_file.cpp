#include "io/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include "base/verify.hpp"
#include "io/descriptor.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kNoPath = "is no path here; ./- is, and /dev/stdout is standard output";

namespace fs = std::filesystem;

constexpr std::string_view kTemporaryPrefix = ".ccdfuzz-tmp-";

/// Unlike any other file's of this process; O_EXCL rules out the rest.
std::string new_temporary_name() {
  static std::atomic<std::uint64_t> counter = 0;
  return fmt::format("{}{}-{}", kTemporaryPrefix, ::getpid(), counter++);
}

/// The names of this process's temporary files, for a signal handler, which takes them out. The
/// mutex is for everybody else. What finds no place is not removed by a signal.
std::array<std::atomic<char*>, 64> unfinished{};
std::mutex unfinished_mutex;
static_assert(std::atomic<char*>::is_always_lock_free);

void enter_unfinished(const std::string& path) {
  const std::scoped_lock lock(unfinished_mutex);
  for (std::atomic<char*>& place : unfinished) {
    if (place != nullptr) continue;
    place = ::strdup(path.c_str());
    return;
  }
}

void strike_unfinished(const std::string& path) {
  const std::scoped_lock lock(unfinished_mutex);
  for (std::atomic<char*>& place : unfinished) {
    if (const char* const name = place; name != nullptr && path == name) {
      ::free(place.exchange(nullptr));
    }
  }
}

std::string folder_of(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

/// Removes what killed writers left behind: the system dropped their locks of it (is_kept). Where
/// the file system has no locks, it stays.
void remove_leftovers(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error)) {
    const std::string path = at->path().string();
    if (!is_temporary(at->path().filename().string())) continue;
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (*file >= 0 && ::flock(*file, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  }
}

/// Locks a new temporary file while it is open. False: before, somebody took it for left behind.
bool is_kept(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
  using Status = struct stat;
  Status status{};
  return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

/// Removes them once a folder: a store of finds writes many files into one.
void remove_leftovers_once(const std::string& folder) {
  static std::mutex mutex;
  static std::set<std::string> cleared;
  const std::scoped_lock lock(mutex);
  if (cleared.insert(folder).second) remove_leftovers(folder);
}

}  // namespace

bool is_path_of(const std::string& path, int descriptor) {
  using Status = struct stat;
  Status at_path{}, held{};
  return ::stat(path.c_str(), &at_path) == 0 && ::fstat(descriptor, &held) == 0 &&
         at_path.st_dev == held.st_dev && at_path.st_ino == held.st_ino;
}

bool is_standard_output(const std::string& path) {
  return is_path_of(path, STDOUT_FILENO);
}

bool is_stream(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  const bool is_file = fs::is_regular_file(status) || fs::is_directory(status);
  return is_standard_output(path) || (fs::exists(status) && !is_file);
}

bool is_temporary(std::string_view file_name) {
  if (!file_name.starts_with(kTemporaryPrefix)) return false;
  file_name.remove_prefix(kTemporaryPrefix.size());
  // As new_temporary_name makes it: two numbers.
  const size_t dash = file_name.find_first_not_of("0123456789"), rest = dash + 1;
  return dash != 0 && dash != std::string_view::npos && file_name[dash] == '-' &&
         rest < file_name.size() &&
         file_name.find_first_not_of("0123456789", rest) == std::string_view::npos;
}

void remove_unfinished_files() {
  for (std::atomic<char*>& place : unfinished) {
    if (const char* const name = place.exchange(nullptr)) ::unlink(name);
  }
}

tl::unexpected<InputError> system_error(const std::string& path, const char* doing, int error) {
  return input_error(path, "cannot {}: {}", doing, std::generic_category().message(error));
}

tl::unexpected<InputError> OutputFile::failed(const char* doing, int error) {
  abandon();
  return system_error(path_, doing, error);
}

Result<void> refuse_read_only(const std::string& path) {
  const int refused = ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0 ? 0 : errno;
  if (refused == 0 || refused == ENOENT) return {};
  return system_error(path, "write", refused);
}

Result<OutputFile> OutputFile::create(const std::string& path) {
  if (path == "-") return input_error(path, kNoPath);
  OutputFile file;
  file.path_ = path;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return system_error(path, "write", EISDIR);
  if (is_stream(path)) {
    file.descriptor_ = is_standard_output(path) ? ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)
                                                : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) return system_error(path, "write", errno);
    return file;
  }
  // Through symbolic links, so that they stay. The last may lead to no file yet.
  fs::path resolved = path;
  for (int links = 0; fs::is_symlink(resolved, ignored); ++links) {
    constexpr int kMostLinks = 40;  // as the system has it
    if (links == kMostLinks) return system_error(path, "write", ELOOP);
    resolved = resolved.parent_path() / fs::read_symlink(resolved, ignored);
  }
  resolved = fs::weakly_canonical(resolved, ignored);
  file.target_ = ignored || resolved.empty() ? path : resolved.string();
  CCDFUZZ_TRY_VOID(refuse_read_only(path));
  const std::string folder = folder_of(file.target_);
  remove_leftovers_once(folder);
  using Status = struct stat;
  Status old{};
  const bool replaces = ::stat(file.target_.c_str(), &old) == 0;
  const mode_t mode = replaces ? old.st_mode & 0777U : 0666U;
  for (;;) {
    file.temporary_ = folder + "/" + new_temporary_name();
    enter_unfinished(file.temporary_);
    file.descriptor_ =
        ::open(file.temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    const int error = errno;
    if (file.descriptor_ >= 0 && is_kept(file.descriptor_)) break;
    strike_unfinished(std::exchange(file.temporary_, {}));
    if (file.descriptor_ < 0 && error != EEXIST) return system_error(path, "write", error);
    if (file.descriptor_ >= 0) ::close(std::exchange(file.descriptor_, -1));
  }
  if (replaces) ::fchmod(file.descriptor_, mode);  // whatever the umask
  return file;
}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  abandon();
  path_ = std::move(other.path_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

void OutputFile::abandon() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  strike_unfinished(std::exchange(temporary_, {}));
}

Result<void> OutputFile::write(std::string_view bytes) {
  CCDFUZZ_VERIFY(descriptor_ >= 0);
  if (const int error = write_all(descriptor_, bytes)) return failed("write", error);
  return {};
}

Result<void> OutputFile::commit() {
  CCDFUZZ_VERIFY(descriptor_ >= 0);
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) return failed("write", errno);
  const Descriptor locked(temporary_.empty() ? -1 : ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0));
  if (::close(std::exchange(descriptor_, -1)) != 0) return failed("write", errno);
  if (temporary_.empty()) return {};
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return failed("write", errno);
  strike_unfinished(std::exchange(temporary_, {}));
  // The new name itself is on the disk only once the folder is.
  const Descriptor folder(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (*folder >= 0) ::fsync(*folder);
  return {};
}

Result<void> make_folder(const std::string& folder) {
  if (folder == "-") return input_error(folder, kNoPath);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return system_error(folder, "make the folder", error.value());
  return {};
}

Result<void> make_writable_folder(const std::string& folder) {
  CCDFUZZ_TRY_VOID(make_folder(folder));
  const auto probe = OutputFile::create(folder + "/.probe");
  return probe ? Result<void>() : input_error(folder, probe.error().what);
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  CCDFUZZ_TRY(auto file, OutputFile::create(path));
  CCDFUZZ_TRY_VOID(file.write(bytes));
  return file.commit();
}

}  // namespace ccdfuzz
