#include "fuzz/lost_inputs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

// Process ids come again, in containers at once: a session begins as the one before it did.
TEST(LostInputs, KeepWhatAnotherSessionLeft) {
  const ScratchFolder folder;
  ASSERT_EQ(::setenv("CCDFUZZ_LOST", folder.path().c_str(), 1), 0);
  constexpr std::array<std::array<std::uint8_t, 2>, 2> kInputs = {{{1, 2}, {3, 4}}};
  for (const auto& input : kInputs) {
    LostInputs session;
    session.keep(input, "a kind");
    session.keep(kInputs[0], "a kind");  // the first is enough
  }
  ::unsetenv("CCDFUZZ_LOST");
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

}  // namespace
}  // namespace ccdfuzz
