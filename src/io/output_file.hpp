#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace ccdfuzz {

/// Whether the file of an open descriptor is at the path.
bool is_path_of(const std::string& path, int descriptor);
/// Whether the path is that of the standard output, such as /dev/stdout. Its file may have no name
/// by now, and what others write to it stays.
bool is_standard_output(const std::string& path);
/// Whether it is that, a pipe or a device: nothing lies beside it.
bool is_stream(const std::string& path);

/// Errors: a file is at the path, and may not be written. To replace it, the system would ask its
/// folder alone.
Result<void> refuse_read_only(const std::string& path);

/// A file that appears complete or not at all. It is written under a temporary name in the same
/// folder, flushed to the disk and renamed over its path by commit(). Until then, and for ever if
/// commit is never reached, the file at the path stays. The new file has its permissions. The first
/// output to a folder removes what killed writers left there; a lock says that a writer lives. A
/// device, a pipe and the standard output (as /dev/stdout) are written directly. Errors: what the
/// system says, naming the path, also of a file at it that may not be written; "-", which others
/// take for stdout.
class OutputFile {
 public:
  static Result<OutputFile> create(const std::string& path);
  OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }
  OutputFile& operator=(OutputFile&& other) noexcept;
  ~OutputFile() { abandon(); }

  Result<void> write(std::string_view bytes);
  Result<void> commit();

 private:
  OutputFile() = default;
  void abandon();
  tl::unexpected<InputError> failed(const char* doing, int error);

  std::string path_;       ///< as the caller named it, for messages
  std::string target_;     ///< what to rename to; empty if written directly
  std::string temporary_;  ///< empty if written directly or nothing is left to remove
  int descriptor_ = -1;
};

/// Writes a complete file so.
Result<void> write_file(const std::string& path, std::string_view bytes);

/// Makes a folder, and those that it lies in, unless it is there. Errors: as above.
Result<void> make_folder(const std::string& folder);

/// The same. Errors: also if no file can be made in it.
Result<void> make_writable_folder(const std::string& folder);

/// Whether a temporary file of OutputFile has such a name.
bool is_temporary(std::string_view file_name);

/// Removes the temporary files that this process writes to, for a signal handler that ends it.
void remove_unfinished_files();

/// "path: cannot DOING: what the system says of this errno".
tl::unexpected<InputError> system_error(const std::string& path, const char* doing, int error);

}  // namespace ccdfuzz
