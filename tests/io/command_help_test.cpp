#include "io/command_help.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace ccdfuzz {
namespace {

TEST(EndedBy, TellsFaultsFromWhatTheSystemRefuses) {
  EXPECT_EQ(ended_by(std::bad_alloc()), "there is no memory left");
  const std::system_error refused(EMFILE, std::generic_category(), "cannot make a pipe");
  EXPECT_EQ(ended_by(refused), "the system refuses: cannot make a pipe: Too many open files");
  EXPECT_EQ(ended_by(std::logic_error("x > 0")), "internal error: x > 0");
}

}  // namespace
}  // namespace ccdfuzz
