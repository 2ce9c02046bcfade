#include "finds/intake.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "finds/finds.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

/// Misses every contact of a first patch whose coordinate is at least `least`.
struct Misses : Method {
  explicit Misses(double from) : least(from) {}
  Answered answer(const Query& query, const SearchOptions&) override {
    return {query.patches[0].positions[0][0] >= least ? Answer::miss() : Answer::hit(0)};
  }
  double least;
};

Asker asker_of(double least) {
  return Asker({}, MethodSet([least](const std::string&) -> Result<std::unique_ptr<Method>> {
                 return std::make_unique<Misses>(least);
               }));
}

/// An intake whose methods miss from `least` on.
struct Taken {
  Taken(const std::string& folder, double least)
      : store(open_store(folder)),
        intake(
            store, [least] { return asker_of(least); }, [least] { return asker_of(least); }) {}

  void offer(const Case& find) {
    Case bare = find;
    bare.expect.clear();
    intake.offer(failures_of(find).front(), bare);
  }

  Store store;
  Intake intake;
};

TEST(Intake, KeepsAndStoresTheSmallestOfEachFailure) {
  const ScratchFolder folder;
  Taken taken(folder.path(), 1);
  for (const double x : {7, 15, 3, 31}) taken.offer(find_of(x));
  taken.offer(find_of(5, "trad"));
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3), find_of(5, "trad")));
  EXPECT_EQ(taken.intake.count(), 2U);
  const std::vector<Find> finds = taken.intake.finds();
  ASSERT_EQ(finds.size(), 2U);
  EXPECT_TRUE(finds[0].is_new);
  EXPECT_EQ(finds[0].path, folder / "tdibm-missed-VV-at-an-end.json");
}

TEST(Intake, KnowsAnEntryThatStillFails) {
  const ScratchFolder folder;
  Taken(folder.path(), 1).offer(find_of(3));
  Taken again(folder.path(), 1);
  again.offer(find_of(7));
  EXPECT_TRUE(again.intake.has(failures_of(find_of(7)).front()).value());
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
  EXPECT_EQ(again.intake.count(), 0U);
  ASSERT_EQ(again.intake.finds().size(), 1U);
  EXPECT_FALSE(again.intake.finds()[0].is_new);
  EXPECT_EQ(again.intake.finds()[0].value, find_of(3)) << "the one that stands there";
}

// A forged or outdated entry, by its failure's name or by another, silences nothing.
TEST(Intake, AnEntryThatDoesNotFailAsItSaysHidesNoFind) {
  for (const std::string name : {"tdibm-missed-VV-at-an-end", "forged"}) {
    const ScratchFolder folder;
    ASSERT_TRUE(open_store(folder.path()).put_named(name, find_of(1)));
    Taken taken(folder.path(), 2);
    const Failure failure = failures_of(find_of(3)).front();
    EXPECT_FALSE(taken.intake.has(failure).value());
    taken.offer(find_of(3));
    EXPECT_EQ(taken.intake.count(), 1U) << name;
    EXPECT_THAT(cases_in(folder.path()), testing::UnorderedElementsAre(find_of(1), find_of(3)))
        << name;
    EXPECT_TRUE(fs::exists(taken.store.path_of(failure)));
  }
}

TEST(Intake, BehindAForgedEntryTheSmallestFindStillTakesItsPlace) {
  const ScratchFolder folder;
  {
    Store store = open_store(folder.path());
    put(store, find_of(31));
    ASSERT_TRUE(store.put_named("forged", find_of(1)));
  }
  Taken taken(folder.path(), 2);
  taken.offer(find_of(7));
  EXPECT_THAT(cases_in(folder.path()), testing::UnorderedElementsAre(find_of(1), find_of(7)));
}

TEST(Intake, OneFindThatCannotBeStoredHoldsUpNoOther) {
  const ScratchFolder folder;
  Taken taken(folder.path(), 1);
  const std::string path = taken.store.path_of(failures_of(find_of(3)).front());
  write_text(path, "garbage");
  taken.offer(find_of(3));
  taken.offer(find_of(5, "trad"));
  EXPECT_EQ(read_text(path), "garbage");
  EXPECT_TRUE(fs::exists(taken.store.path_of(failures_of(find_of(5, "trad")).front())));
  ASSERT_TRUE(taken.intake.trouble());
  EXPECT_EQ(taken.intake.trouble()->where.substr(0, path.size()), path);
}

/// Puts a find into a folder by its failure, and returns its entry there.
NamedCase entry_in(const std::string& folder, const Case& find) {
  Store store = open_store(folder);
  put(store, find);
  return *store.standing(failures_of(find).front()).value();
}

TEST(Intake, TakesTheSmallerOfTwoEntriesThatFailAlike) {
  for (const bool smaller_first : {false, true}) {
    const ScratchFolder folder, other;
    Taken taken(folder.path(), 1);
    ASSERT_TRUE(taken.intake.take(entry_in(other / "a", find_of(smaller_first ? 3 : 31))));
    ASSERT_TRUE(taken.intake.take(entry_in(other / "b", find_of(smaller_first ? 31 : 3))));
    EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
  }
}

TEST(Intake, EntriesOfOtherFoldersAreKnownIfTheyFailAsTheySay) {
  const ScratchFolder folder, other;
  Taken taken(folder.path(), 2);
  const Failure failure = failures_of(find_of(3)).front();
  const NamedCase forged = entry_in(other / "a", find_of(1));
  taken.store.know(forged);
  EXPECT_FALSE(taken.intake.has(failure).value());
  taken.store.know(forged);
  taken.store.know(entry_in(other / "b", find_of(7)));
  EXPECT_TRUE(taken.intake.has(failure).value()) << "behind a smaller one that is forged";
  fs::remove_all(folder.path());
  EXPECT_EQ(taken.store.standing(failure).value()->value, find_of(7)) << "in a folder made again";
}

// Forged: find_of(1) does not fail; it says so and is the smaller.
TEST(Intake, AnEntryThatDoesNotFailAsItSaysTakesNoOthersPlace) {
  for (const bool forged_first : {false, true}) {
    const ScratchFolder folder, other;
    Taken taken(folder.path(), 2);
    ASSERT_TRUE(taken.intake.take(entry_in(other / "a", find_of(forged_first ? 1 : 31))));
    ASSERT_TRUE(taken.intake.take(entry_in(other / "b", find_of(forged_first ? 31 : 1))));
    EXPECT_EQ(taken.intake.take_doubtful().value(), 1U);
    EXPECT_THAT(cases_in(folder.path()), testing::UnorderedElementsAre(find_of(1), find_of(31)));
    const std::string path = taken.store.path_of(failures_of(find_of(31)).front());
    EXPECT_EQ(read_case(path).value().value, find_of(31));
  }
}

/// find_of(3) whose contact is not proven, which nobody can miss.
Case unproven_find() {
  Case weak = find_of(3);
  weak.truth = {};
  return weak;
}

TEST(Intake, KeepsTheStrongerTruthOfTwoEntriesOfOneQuery) {
  for (const std::string name : {"tdibm-missed-VV-at-an-end", "own name (1)"}) {
    for (const bool proven_first : {false, true}) {
      const ScratchFolder folder, other;
      for (const bool is_proven : {proven_first, !proven_first}) {
        const std::string to = other / (is_proven ? "proven" : "weak");
        ASSERT_TRUE(open_store(to).put_named(name, is_proven ? find_of(3) : unproven_find()));
        Taken taken(folder.path(), 1);
        ASSERT_TRUE(
            taken.intake.take({to + "/" + name + ".json", is_proven ? find_of(3) : unproven_find(),
                               to + "/" + name + ".json"}));
        ASSERT_TRUE(taken.intake.take_doubtful());
      }
      EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3))) << name << proven_first;
      EXPECT_TRUE(fs::exists(folder / (name + ".json")));
    }
  }
}

TEST(Intake, AnEntryThatNoLongerFailsIsNotCalledByItsFailure) {
  const ScratchFolder folder, other;
  Taken taken(folder.path(), 4);
  ASSERT_TRUE(taken.intake.take(entry_in(other.path(), find_of(3))));
  EXPECT_EQ(taken.intake.take_doubtful().value(), 1U);
  EXPECT_TRUE(fs::exists(folder / (content_address(find_of(3).query) + ".json")));
  EXPECT_FALSE(fs::exists(taken.store.path_of(failures_of(find_of(3)).front())));
}

TEST(Intake, AsksTheMethodWhenEntriesOfOneQueryDisagree) {
  const std::string nobody = "plugin-exec:./nobody";
  Case one = find_of(3), two = find_of(3);
  one.expect = {{"tdibm", Outcome::kCorrect}, {nobody, Outcome::kMissed}};
  two.expect = {{"tdibm", Outcome::kUnknown}, {nobody, Outcome::kCorrect}};
  for (const bool is_one_first : {false, true}) {
    const ScratchFolder folder;
    Taken taken(folder.path(), 1);
    ASSERT_TRUE(taken.intake.take({"a/x.json", is_one_first ? one : two, "a/x.json"}));
    ASSERT_TRUE(taken.intake.take({"b/x.json", is_one_first ? two : one, "b/x.json"}));
    const Case now = cases_in(folder.path()).front();
    EXPECT_EQ(now.expect.at("tdibm").outcome, Outcome::kMissed) << "what it shows";
    EXPECT_EQ(now.expect.at(nobody), (is_one_first ? one : two).expect.at(nobody)) << "the first";
    EXPECT_EQ(taken.intake.settled().asked, 1U);
    EXPECT_THAT(taken.intake.settled().kept, ElementsAre(testing::Pair(nobody, 1U)));
  }
}

// Nothing that a file names is started, so nobody knows whether such an entry is true.
TEST(Intake, EntriesOfMethodsThatNobodyAdmittedAreAllKept) {
  const ScratchFolder folder, other;
  Taken taken(folder.path(), 1);
  const std::string who = "plugin-exec:./nobody";
  for (const double x : {31, 3, 7, 31, 3, 7}) {
    ASSERT_TRUE(taken.intake.take(entry_in(other / std::to_string(x), find_of(x, who))));
  }
  EXPECT_EQ(cases_in(folder.path()).size(), 3U) << "each once, however often it comes";
}

TEST(Intake, FinishShrinksToTheSameFailureAndAsksTheOthers) {
  const ScratchFolder folder;
  Taken taken(folder.path(), 2);
  taken.offer(find_of(31));
  const std::atomic<bool> stop = false;
  const auto any = [](const auto&) { return true; };
  ASSERT_TRUE(taken.intake.finish({1, any, any, [] { return 600; }, {"tdibm", "other"}, stop}));
  const std::vector<Case> cases = cases_in(folder.path());
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_LT(rank_of(cases[0].query), rank_of(find_of(31).query));
  EXPECT_GE(cases[0].query.patches[0].positions[0][0], 2) << "it fails still";
  EXPECT_EQ(failures_of(cases[0]).back(), failures_of(find_of(31)).front());
  EXPECT_EQ(cases[0].expect.at("other"), Outcome::kMissed);
}

}  // namespace
}  // namespace ccdfuzz
