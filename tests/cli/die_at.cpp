// Preloaded into a program, counts its calls that change files and ends it by SIGKILL at one of
// them:
//   CCDFUZZ_TEST_DIE_AT=N     before the N-th, counted from 0. A write counts twice: the second
//                             time, half of it is made
//   CCDFUZZ_TEST_CALLS=FILE   at none; writes their number into a file when the program ends
// Programs that this one starts are left alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace {

std::atomic<long> calls = 0;
long die_at = std::numeric_limits<long>::max();
const char* calls_path = nullptr;  // a string would be made after begin()

/// True iff the program is to end at this call.
bool is_last() {
  return calls++ == die_at;
}

void die() {
  ::kill(::getpid(), SIGKILL);
  for (;;) ::pause();
}

void change() {
  if (is_last()) die();
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool is_file(int descriptor) {
  struct stat about {};
  return ::fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode);
}

template <class Write>
ssize_t write_or_die(int descriptor, size_t count, const Write& write) {
  if (!is_file(descriptor)) return write(count);
  change();
  if (is_last()) {
    static_cast<void>(write(count / 2));
    die();
  }
  return write(count);
}

__attribute__((constructor)) void begin() {
  if (const char* const at = std::getenv("CCDFUZZ_TEST_DIE_AT")) die_at = std::atol(at);
  if (const char* const path = std::getenv("CCDFUZZ_TEST_CALLS")) calls_path = ::strdup(path);
  for (const char* name : {"LD_PRELOAD", "CCDFUZZ_TEST_DIE_AT", "CCDFUZZ_TEST_CALLS"})
    ::unsetenv(name);
}

__attribute__((destructor)) void end() {
  if (calls_path == nullptr) return;
  const long count = calls;
  if (std::FILE* const file = std::fopen(calls_path, "w")) {
    std::fprintf(file, "%ld\n", count);
    std::fclose(file);
  }
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static auto* const next = real<ssize_t(int, const void*, size_t)>("write");
  return write_or_die(descriptor, count, [&](size_t n) { return next(descriptor, bytes, n); });
}

ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t at) {
  static auto* const next = real<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return write_or_die(descriptor, count, [&](size_t n) { return next(descriptor, bytes, n, at); });
}

int open(const char* path, int flags, ...) {
  static auto* const next = real<int(const char*, int, ...)>("open");
  std::va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & (O_CREAT | O_TRUNC)) != 0) change();
  return next(path, flags, mode);
}

int rename(const char* from, const char* to) noexcept {
  static auto* const next = real<int(const char*, const char*)>("rename");
  change();
  return next(from, to);
}

int unlink(const char* path) noexcept {
  static auto* const next = real<int(const char*)>("unlink");
  change();
  return next(path);
}

int remove(const char* path) noexcept {
  static auto* const next = real<int(const char*)>("remove");
  change();
  return next(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static auto* const next = real<int(const char*, mode_t)>("mkdir");
  change();
  return next(path, mode);
}

int ftruncate(int descriptor, off_t size) noexcept {
  static auto* const next = real<int(int, off_t)>("ftruncate");
  change();
  return next(descriptor, size);
}

int fsync(int descriptor) {
  static auto* const next = real<int(int)>("fsync");
  change();
  return next(descriptor);
}

}  // extern "C"
