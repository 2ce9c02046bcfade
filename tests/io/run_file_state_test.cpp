// Random sequences of what happens to a run file, held to a model: how many items are done.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include <rapidcheck/state.h>
#include "io/run_file.hpp"
#include "rapidcheck.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

constexpr std::uint64_t kItems = 12;

std::string state_line(std::uint64_t item) {
  return fmt::format("{{\"index\":{},\"text\":\"{}\"}}", item, std::string(item % 5, 'x'));
}

struct RunUnderTest {
  ScratchFolder folder;
  std::string path = folder / "x.partial";
  RunHeader header{"test", "1.0", {"a.jsonl"}, {{"--seed", "7"}}, kItems, {}};
  std::optional<RunFile> file;

  RunUnderTest() { open(); }
  void open() { file.emplace(value_or_throw(RunFile::open(path, header))); }
};

using RunCommand = rc::state::Command<std::uint64_t, RunUnderTest>;

/// The file is the header and the lines of this many items.
void check_lines(std::uint64_t done, const RunUnderTest& sut) {
  RC_ASSERT(sut.file->size() == done);
  Result<RunLines> lines = RunLines::open(sut.path);
  RC_ASSERT(lines.has_value());
  for (std::uint64_t item = 0; item < done; ++item) {
    const auto line = lines->next();
    RC_ASSERT(line.has_value());
    RC_ASSERT(*line == state_line(item));
  }
  RC_ASSERT(!lines->next()->has_value());
}

struct Append : RunCommand {
  void checkPreconditions(const std::uint64_t& done) const override { RC_PRE(done < kItems); }
  void apply(std::uint64_t& done) const override { ++done; }
  void run(const std::uint64_t& done, RunUnderTest& sut) const override {
    RC_ASSERT(sut.file->append(state_line(done)).has_value());
    check_lines(done + 1, sut);
  }
  void show(std::ostream& out) const override { out << "append"; }
};

/// What a kill leaves: a beginning of the file.
struct CutAndGoOn : RunCommand {
  std::uint64_t bytes = *rc::gen::inRange<std::uint64_t>(0, 60);

  static std::uint64_t left_of(std::uint64_t done, std::uint64_t bytes) {
    for (; done > 0 && bytes > 0; --done) {
      const std::uint64_t line = state_line(done - 1).size() + 1;
      bytes -= std::min(bytes, line);
    }
    return done;
  }
  void apply(std::uint64_t& done) const override { done = left_of(done, bytes); }
  void run(const std::uint64_t& done, RunUnderTest& sut) const override {
    sut.file.reset();
    std::uint64_t in_lines = 0;
    for (std::uint64_t item = 0; item < done; ++item) in_lines += state_line(item).size() + 1;
    const std::uint64_t size = std::filesystem::file_size(sut.path);
    std::filesystem::resize_file(sut.path, size - std::min(bytes, in_lines));
    sut.open();
    check_lines(left_of(done, bytes), sut);
  }
  void show(std::ostream& out) const override { out << "cut " << bytes << " bytes off, go on"; }
};

struct AnotherRunIsRefused : RunCommand {
  void run(const std::uint64_t& done, RunUnderTest& sut) const override {
    sut.file.reset();
    RunHeader other = sut.header;
    other.asked["--seed"] = "8";
    RC_ASSERT(!RunFile::open(sut.path, other).has_value());
    sut.open();
    check_lines(done, sut);
  }
  void show(std::ostream& out) const override { out << "open as another run"; }
};

/// Ends the run where all is done, and begins it anew.
struct Finish : RunCommand {
  void checkPreconditions(const std::uint64_t& done) const override { RC_PRE(done == kItems); }
  void apply(std::uint64_t& done) const override { done = 0; }
  void run(const std::uint64_t&, RunUnderTest& sut) const override {
    RC_ASSERT(sut.file->rename(sut.folder / "x").has_value());
    RC_ASSERT(!std::filesystem::exists(sut.path));
    Result<MergedRun> merged = MergedRun::open({sut.folder / "x"});
    RC_ASSERT(merged.has_value());
    for (std::uint64_t item = 0; item < kItems; ++item) {
      RC_ASSERT(merged->next()->value() == state_line(item));
    }
    RC_ASSERT(!merged->next()->has_value());
    sut.file.reset();
    sut.open();
    check_lines(0, sut);
  }
  void show(std::ostream& out) const override { out << "finish"; }
};

RC_GTEST_PROP(RunFileState, GoesOnAfterTheLastWholeLineWhateverHappens, ()) {
  RunUnderTest sut;
  rc::state::check(std::uint64_t{0}, sut,
                   rc::state::gen::execOneOfWithArgs<Append, Append, Append, Append, CutAndGoOn,
                                                     AnotherRunIsRefused, Finish>());
}

}  // namespace
}  // namespace ccdfuzz
