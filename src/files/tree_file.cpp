#include "files/tree_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <array>
#include <cerrno>
#include <filesystem>

#include "base/verify.hpp"
#include "io/descriptor.hpp"
#include "io/hash_name.hpp"
#include "io/input_bytes.hpp"

namespace ccdfuzz {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kCaseEndings = {".jsonl.zst", ".jsonl", ".json"};

/// `length` bytes from `offset` on.
Result<std::string> read_range(const std::string& path, std::uint64_t offset, size_t length) {
  CCDFUZZ_TRY_VOID(refuse_irregular(path));
  const Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (*descriptor < 0) return system_error(path, "read", errno);
  std::string bytes(length, '\0');
  for (size_t done = 0; done < length;) {
    const ssize_t got =
        ::pread(*descriptor, bytes.data() + done, length - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(path, "read", errno);
    if (got == 0) {
      return input_error(path,
                         fmt::format("ends before byte {}, where a tree ends", offset + length));
    }
    done += static_cast<size_t>(got);
  }
  return bytes;
}

Result<std::string> tree_at(const std::string& path, const TreeRef& tree) {
  // Both limits keep a wrong number from being allocated.
  if (tree.length > ZSTD_compressBound(kMaxTreeBytes)) {
    return input_error(path, fmt::format("a tree of {} bytes is larger than any", tree.length));
  }
  CCDFUZZ_TRY(const auto frame, read_range(path, tree.offset, tree.length));
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN ||
      ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size()) {
    return input_error(path, fmt::format("holds no tree at byte {}", tree.offset));
  }
  if (size > kMaxTreeBytes) {
    return input_error(path, fmt::format("a tree of {} bytes is larger than any", size));
  }
  std::string bytes(size, '\0');
  const size_t got = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
  if (ZSTD_isError(got) != 0 || got != bytes.size()) {
    return input_error(path,
                       fmt::format("the tree at byte {} is not sound zstd data", tree.offset));
  }
  if (const std::string hash = hash_name(bytes); hash != tree.xxh3) {
    return input_error(path, fmt::format("the tree at byte {} has the hash {}, not {}", tree.offset,
                                         hash, tree.xxh3));
  }
  return bytes;
}

}  // namespace

std::string path_beside(const std::string& case_path, std::string_view ending) {
  size_t length = case_path.size();
  for (const std::string_view own : kCaseEndings) {
    if (case_path.ends_with(own)) length = case_path.size() - own.size();
  }
  return case_path.substr(0, length).append(ending);
}

std::string trees_path(const std::string& case_path) {
  return path_beside(case_path, kTreesEnding);
}

Result<std::string> read_tree(const std::string& path, const TreeRef& tree) {
  return tree_at(path, tree).map_error([](InputError error) {
    error.is_limit = true;
    return error;
  });
}

Result<std::string> tree_of(const Truth& truth, const std::string& trees) {
  const MissTree* const miss = miss_tree(truth);
  if (miss == nullptr) return "";
  const auto named = [](const InputError& error) {
    return InputError{"truth.certificate.clear.tree", error.message(), error.is_limit};
  };
  return read_tree(trees, miss->tree).map_error(named);
}

bool drop_tree(Truth& truth) {
  if (miss_tree(truth) == nullptr) return false;
  truth.clearance.reset();
  truth.clear_until.reset();
  if (truth.collides == false) truth.proof = "rational-tdibm";
  return true;
}

Result<void> carry_tree(Truth& truth, const std::string& trees, const std::string& case_path) {
  if (trees.empty()) drop_tree(truth);
  MissTree* const miss = miss_tree(truth);
  if (miss == nullptr) return {};
  CCDFUZZ_TRY(const auto bytes, read_tree(trees, miss->tree));
  TreeWriter writer(case_path);
  CCDFUZZ_TRY(miss->tree, writer.write(bytes));
  return writer.finish();
}

Result<void> refuse_shared(const std::string& case_path, std::string_view ending) {
  std::error_code ignored;
  const std::string beside = path_beside(case_path, ending);
  if (!fs::exists(beside, ignored)) return {};
  for (const std::string_view of_cases : kCaseEndings) {
    const std::string other = path_beside(case_path, of_cases);
    if (other == case_path || !fs::exists(other, ignored)) continue;
    return input_error(case_path,
                       fmt::format("would share {} with {}; choose another name", beside, other));
  }
  return {};
}

Result<void> remove_beside(const std::string& case_path, std::string_view ending) {
  if (!refuse_shared(case_path, ending)) return {};
  std::error_code error;
  const std::string old = path_beside(case_path, ending);
  CCDFUZZ_TRY_VOID(refuse_read_only(old));
  if (fs::is_regular_file(old, error)) fs::remove(old, error);
  if (error && error != std::errc::no_such_file_or_directory) {
    return system_error(old, "remove", error.value());
  }
  return {};
}

Result<TreeRef> TreeWriter::write(std::string_view bytes) {
  CCDFUZZ_VERIFY(bytes.size() <= kMaxTreeBytes);
  if (!file_) {
    CCDFUZZ_TRY(file_, OutputFile::create(path_));
  }
  constexpr int kLevel = 9;
  std::string frame(ZSTD_compressBound(bytes.size()), '\0');
  const size_t length =
      ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), kLevel);
  CCDFUZZ_VERIFY(ZSTD_isError(length) == 0);
  frame.resize(length);
  const TreeRef tree{offset_, length, hash_name(bytes)};
  CCDFUZZ_TRY_VOID(file_->write(frame));
  offset_ += length;
  return tree;
}

Result<void> TreeWriter::finish() {
  return file_ ? file_->commit() : Result<void>();
}

}  // namespace ccdfuzz
