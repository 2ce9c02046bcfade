#include <fmt/format.h>
#include <gmock/gmock.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <thread>

#include "finds/finds.hpp"
#include "io/output_file.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using Put = Store::Put;
using testing::ElementsAre;

/// Runs work in a process of its own, and gives its exit code, or minus the signal it died of.
int in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 99;
    try {
      code = work();
    } catch (...) {
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// What two hunts add: 30 finds, a third of which of the same failure.
std::vector<Case> many_finds(const std::string& who) {
  std::vector<Case> finds;
  for (int i = 0; i < 10; ++i) {
    finds.push_back(find_of(2 * (10 - i) + 1));
    finds.push_back(find_of(1 + i, fmt::format("own-{}{}", who, i)));
    finds.push_back(find_of(1 + i, fmt::format("shared{}", i)));
  }
  return finds;
}

/// 1 of tdibm, 10 own ones of each writer and 10 that both have; no temporary files; every failure
/// once.
void expect_union_of_two(const ScratchFolder& folder) {
  const std::vector<Case> cases = cases_in(folder.path());
  std::map<std::string, int> expectations;
  for (const Case& c : cases) {
    for (const auto& [method, expected] : c.expect) ++expectations[method];
  }
  EXPECT_EQ(expectations.size(), 31U);
  for (const auto& [method, count] : expectations) EXPECT_EQ(count, 1) << method;
  EXPECT_EQ(folder.entry_count(), cases.size());
}

TEST(StoreInTrouble, TwoProcessesShareAFolder) {
  const ScratchFolder folder;
  const auto hunt = [&](const std::string& who) {
    Store store = open_store(folder.path());
    for (const Case& find : many_finds(who)) put(store, find);
    return 0;
  };
  std::vector<std::thread> parents;
  std::array<int, 2> codes{};
  for (size_t i = 0; i < 2; ++i) {
    parents.emplace_back([&, i] { codes[i] = in_child([&] { return hunt(i == 0 ? "a" : "b"); }); });
  }
  for (std::thread& t : parents) t.join();
  EXPECT_THAT(codes, ElementsAre(0, 0));
  expect_union_of_two(folder);
}

TEST(StoreInTrouble, TwoThreadsShareAStoreOrAFolder) {
  for (const bool one_store : {true, false}) {
    const ScratchFolder folder;
    Store a = open_store(folder.path()), b = open_store(folder.path());
    std::thread first([&] {
      for (const Case& f : many_finds("a")) put(a, f);
    });
    std::thread second([&] {
      for (const Case& f : many_finds("b")) put(one_store ? a : b, f);
    });
    first.join();
    second.join();
    expect_union_of_two(folder);
  }
}

TEST(StoreInTrouble, KilledAtAnyMomentLeavesWholeEntries) {
  const ScratchFolder folder;
  constexpr int kRounds = 20;
  for (int round = 1; round <= kRounds; ++round) {
    std::array<int, 2> added{};
    ASSERT_EQ(::pipe(added.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        // Every fourth find is the first of its failure. Each of the others is smaller than the one
        // before it, so that files come and go all the time.
        Store store = open_store(folder.path());
        for (int i = 0;; ++i) {
          put(store, find_of(std::ldexp(1, 5 - i % 4) - 1, fmt::format("m{}-{}", round, i / 4)));
          if (::write(added[1], "", 1) != 1) break;
        }
      } catch (...) {
      }
      ::_exit(99);
    }
    // Let it add something, and then strike somewhere within what it does next.
    char byte = 0;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(::read(added[0], &byte, 1), 1);
    ::usleep(static_cast<useconds_t>(round * 977 % 8000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    for (const int end : added) ::close(end);
    ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    const auto read = for_each_entry(folder.path(), [](const NamedCase&) {});
    ASSERT_TRUE(read) << read.error().message();
  }
  Store store = open_store(folder.path());
  std::set<std::string> methods;
  for (const Case& entry : cases_in(folder.path())) {
    for (const auto& [method, expected] : entry.expect) {
      EXPECT_TRUE(methods.insert(method).second) << method << " is kept twice";
    }
  }
  EXPECT_GE(methods.size(), kRounds);
  EXPECT_EQ(folder.entry_count(), store.load()->size()) << "leftovers stay";
}

TEST(StoreInTrouble, OpeningRemovesWhatAKilledWriterLeft) {
  const ScratchFolder scratch;
  const std::string before = scratch / "before", finds = scratch / "finds";
  fs::create_directory(before);
  const auto living = OutputFile::create(before + "/a");
  fs::rename(before, finds);  // this process cleared the folder of the other name
  const std::string left = finds + "/.ccdfuzz-tmp-1-0";  // as of a process that lives for ever
  write_text(left, "{\"format\": \"ccdf");
  Store store = open_store(finds);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::is_empty(finds)) << "that of a living writer is gone";
}

/// Runs as a user whom permissions bind, which root is not.
int as_nobody(const std::function<int()>& work) {
  return in_child([&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 &&
        (::setgroups(0, nullptr) != 0 || ::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) {
      return 98;
    }
    return work();
  });
}

TEST(StoreInTrouble, AReadOnlyFolderIsAnErrorAtOnce) {
  const ScratchFolder folder;
  {
    Store store = open_store(folder.path());
    put(store, find_of(3));
  }
  fs::permissions(folder.path(), fs::perms(0555));
  EXPECT_EQ(as_nobody([&] {
              const auto store = Store::open(folder.path());
              return !store && store.error().message() ==
                                   folder.path() + ": cannot write: Permission denied"
                         ? 0
                         : 1;
            }),
            0);
  EXPECT_EQ(as_nobody([&] {
              const auto store = Store::open(folder / "below");
              return !store && store.error().message() ==
                                   folder / "below: cannot make the folder: Permission denied"
                         ? 0
                         : 1;
            }),
            0);
  EXPECT_EQ(
      as_nobody([&] { return for_each_entry(folder.path(), [](const NamedCase&) {}) ? 0 : 1; }), 0);
  fs::permissions(folder.path(), fs::perms(0755));
}

TEST(StoreInTrouble, AFolderInsideThatCannotBeReadIsNamed) {
  const ScratchFolder folder;
  fs::create_directories(folder / "above/below");
  fs::permissions(folder.path(), fs::perms(0755));
  fs::permissions(folder / "above/below", fs::perms(0000));
  EXPECT_EQ(as_nobody([&] {
              const auto entries = list_entries(folder.path());
              return !entries && entries.error().message() ==
                                     folder / "above/below: cannot read: Permission denied"
                         ? 0
                         : 1;
            }),
            0);
}

TEST(StoreInTrouble, AFullDiskIsAnErrorAndKeepsTheFindsSoFar) {
  const ScratchFolder folder;
  // A limit on the size of files stops the write as a full disk does, in the middle of the text.
  const int code = in_child([&] {
    Store store = open_store(folder.path());
    if (put(store, find_of(3)) != Put::kNew) return 1;
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit few_bytes = {100, 100};
    if (::setrlimit(RLIMIT_FSIZE, &few_bytes) != 0) return 2;
    const auto done = try_put(store, find_of(1));
    const std::string path = store.path_of(failures_of(find_of(1)).front());
    if (done || done.error().message() != path + ": cannot write: File too large") return 3;
    return store.load()->size() == 1 ? 0 : 4;
  });
  EXPECT_EQ(code, 0);
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
  EXPECT_EQ(folder.entry_count(), 1U);
}

}  // namespace
}  // namespace ccdfuzz
