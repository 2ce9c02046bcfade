#include "cli/triage_files.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::ElementsAre;

/// A process that is no more.
pid_t ended_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(TriageFiles, AreWhatIsWholeInAFolder) {
  const ScratchFolder folder;
  write_text(folder / "b", "");
  write_text(folder / "a", "");
  write_text(folder / fmt::format(".ccdfuzz-tmp-{}-7", ::getpid()), "");
  write_text(folder / fmt::format(".ccdfuzz-tmp-{}-0", ended_process()), "");
  EXPECT_THAT(triage_files({folder.path()}).value(), ElementsAre(folder / "a", folder / "b"));
}

TEST(TriageWalk, RemovesWhatIsDoneAndPassesOverWhatIsGone) {
  const ScratchFolder folder;
  const std::vector<std::string> files = {folder / "done", folder / "stays", folder / "gone",
                                          folder / "unread"};
  for (const std::string& file : files) {
    if (file != folder / "gone") write_text(file, "");
  }
  TriageWalk walk([] { return false; }, true);
  testing::internal::CaptureStderr();
  walk.go(files, [&](const std::string& file) -> Result<TriageWalk::Work> {
    if (file == folder / "gone" || file == folder / "unread") return input_error(file, "no input");
    return [stays = file == folder / "stays"] { return !stays; };
  });
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::AllOf(testing::HasSubstr("unread: no input; it is left as it is"),
                             testing::Not(testing::HasSubstr("gone: no input"))));
  EXPECT_EQ(walk.counts().files_done, 2U);
  EXPECT_EQ(walk.counts().files_unread, 1U);
  EXPECT_FALSE(std::filesystem::exists(folder / "done"));
  EXPECT_TRUE(std::filesystem::exists(folder / "stays"));
  EXPECT_TRUE(std::filesystem::exists(folder / "unread"));
}

}  // namespace
}  // namespace ccdfuzz
