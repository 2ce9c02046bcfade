#include "io/output_file.hpp"

#include <unistd.h>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

/// Nobody may write read-only files, but for root, who is somebody else meanwhile.
class AsNobody {
 public:
  AsNobody() { EXPECT_EQ(user_ == 0 ? ::seteuid(65534) : 0, 0); }
  ~AsNobody() { EXPECT_EQ(::seteuid(user_), 0); }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  uid_t user_ = ::geteuid();
};

TEST(OutputFile, ReplacesNoFileThatMayNotBeWritten) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::all);
  const std::string kept = folder / "kept", link = folder / "link";
  ASSERT_TRUE(write_file(kept, "before"));
  fs::permissions(kept, fs::perms(0444));
  fs::create_symlink("kept", link);
  const AsNobody nobody;
  for (const std::string& path : {kept, link}) {
    const Result<void> refused = write_file(path, "after");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message(), path + ": cannot write: Permission denied");
  }
  EXPECT_EQ(read_text(kept), "before");
  EXPECT_TRUE(write_file(folder / "new", "after"));
}

}  // namespace
}  // namespace ccdfuzz
