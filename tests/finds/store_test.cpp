#include "finds/store.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "files/case_json.hpp"
#include "finds/finds.hpp"
#include "io/output_file.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using Put = Store::Put;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

const Failure kMissed = failures_of(find_of(3)).front();

struct StoreInAFolder : testing::Test {
  ScratchFolder folder;
  Store store = open_store(folder.path());
};

TEST_F(StoreInAFolder, FailuresOfOtherMethodsOutcomesClassesCausesAndSettingsStandApart) {
  EXPECT_EQ(put(store, find_of(3)), Put::kNew);
  EXPECT_EQ(put(store, find_of(5, "tdibm-h:1e-16")), Put::kNew);
  EXPECT_EQ(put(store, find_of(7, "tdibm", Outcome::kLate)), Put::kNew);
  EXPECT_EQ(put(store, find_of(9, "tdibm", Outcome::kMissed, "VE")), Put::kNew);
  Case other_cause = find_of(11);
  other_cause.expect["tdibm"].cause = "hull";
  EXPECT_EQ(put(store, other_cause), Put::kNew);
  Case later = find_of(13);
  later.query.t_max = 2;
  EXPECT_EQ(put(store, later), Put::kNew);
  Case other_generator = find_of(15);
  other_generator.origin.generator = "grazing";
  EXPECT_EQ(put(store, other_generator), Put::kKnown) << "where it comes from is no matter";
  EXPECT_EQ(cases_in(folder.path()).size(), 6U);
}

TEST_F(StoreInAFolder, AQueryThatTwoMethodsFailOnStandsInTwoFiles) {
  Case both = find_of(3, "tdibm");
  both.expect["trad"] = Outcome::kLate;
  for (const Failure& failure : failures_of(both)) {
    EXPECT_EQ(store.put(failure, both).value(), Put::kNew);
  }
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(both, both));
}

TEST_F(StoreInAFolder, TheSameQueryAgainAddsExpectationsAndChangesNone) {
  put(store, find_of(3));
  Case more = find_of(3);
  more.expect["tdibm-c"] = Outcome::kCorrect;
  EXPECT_EQ(put(store, more), Put::kMerged);
  EXPECT_EQ(put(store, find_of(3)), Put::kKnown);
  Case other = more;
  other.expect["tdibm-c"] = Outcome::kMissed;
  EXPECT_EQ(store.put(kMissed, other).value(), Put::kKnown);
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(more));
}

TEST(Store, EntriesOfOtherNamesAreKnownAndNeverTakenAway) {
  const ScratchFolder folder;
  {
    Store store = open_store(folder.path());
    EXPECT_EQ(store.put_named("underflow-in-tdibm", find_of(7)).value(), Put::kNew);
    EXPECT_TRUE(fs::exists(folder / "underflow-in-tdibm.json"));
    EXPECT_EQ(put(store, find_of(15)), Put::kKnown);
    EXPECT_EQ(store.standing(kMissed).value()->value, find_of(7));
  }
  Store store = open_store(folder.path());
  EXPECT_EQ(put(store, find_of(15)), Put::kKnown) << "of a store opened anew";
  EXPECT_EQ(put(store, find_of(3)), Put::kNew);
  EXPECT_EQ(store.put_named("second", find_of(15)).value(), Put::kNew) << "kept though larger";
  EXPECT_EQ(store.put_named("second", find_of(15)).value(), Put::kKnown);
  EXPECT_EQ(cases_in(folder.path()).size(), 3U);
  EXPECT_EQ(store.standing(kMissed).value()->value, find_of(3));
}

TEST_F(StoreInAFolder, NamesThatAreNoFileNamesAreErrors) {
  const auto refused = [&](const std::string& name, double x) {
    const auto done = store.put_named(name, find_of(x));
    return done ? "accepted" : done.error().message();
  };
  for (const std::string good : {"good", "my find (1)", "\xc3\xa4"}) {
    EXPECT_EQ(refused(good, 3), "accepted") << good;
    EXPECT_TRUE(fs::exists(folder / (good + ".json")));
  }
  for (const std::string bad : {"../up", ".hidden", "a/b", ""}) {
    EXPECT_THAT(refused(bad, 5), testing::StartsWith("\"" + bad + "\" is not a file name")) << bad;
  }
  EXPECT_EQ(refused(std::string(300, 'x'), 7), "accepted");
  EXPECT_TRUE(fs::exists(folder / (content_address(find_of(7).query) + ".json")));
  EXPECT_EQ(cases_in(folder.path()).size(), 4U);
}

TEST_F(StoreInAFolder, NamesAnEntryByItsAddressWhenAnotherHasItsName) {
  EXPECT_EQ(store.put_named("good", find_of(3)).value(), Put::kNew);
  EXPECT_EQ(store.put_named("good", find_of(5)).value(), Put::kNew);
  EXPECT_EQ(store.put_named("good", find_of(5)).value(), Put::kKnown);
  EXPECT_TRUE(fs::exists(folder / (content_address(find_of(5).query) + ".json")));
  EXPECT_THAT(cases_in(folder.path()), UnorderedElementsAre(find_of(3), find_of(5)));
}

TEST_F(StoreInAFolder, KeepsTheEntryOfAnAddressWhenAnotherIsMovedThere) {
  Case by_hand = find_of(7);
  by_hand.origin.note = "keep me";
  by_hand.expect = {{"trad", Outcome::kCorrect}};
  const std::string address = content_address(by_hand.query);
  ASSERT_TRUE(store.put_named(address, by_hand));
  put(store, find_of(7));
  ASSERT_TRUE(store.disown(kMissed, store.path_of(kMissed)));
  by_hand.expect["tdibm"] = Outcome::kMissed;
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(by_hand));
}

// An entry stood by the name of another failure, and was moved to its address.
TEST_F(StoreInAFolder, AnEntryPutAsideIsUnitedWithNoOtherQuery) {
  const Case moved = find_of(31, "trad");
  ASSERT_TRUE(store.put_named(fs::path(store.path_of(kMissed)).stem(), moved));
  put(store, find_of(7));
  ASSERT_TRUE(store.put_aside(failures_of(moved).front(), moved));
  ASSERT_TRUE(store.put_aside(kMissed, find_of(7)));
  EXPECT_THAT(cases_in(folder.path()), UnorderedElementsAre(moved, find_of(7)));
}

TEST_F(StoreInAFolder, APipeInThePlaceOfAFindIsAnError) {
  ASSERT_EQ(::mkfifo(store.path_of(kMissed).c_str(), 0600), 0);
  const auto done = try_put(store, find_of(3));
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message(), testing::HasSubstr("is not a regular file"));
}

TEST_F(StoreInAFolder, AnEntryThatIsDisownedKeepsItsAddressAsItsName) {
  put(store, find_of(3));
  ASSERT_TRUE(store.disown(kMissed, store.path_of(kMissed)));
  EXPECT_FALSE(store.standing(kMissed).value());
  EXPECT_TRUE(fs::exists(folder / (content_address(find_of(3).query) + ".json")));
  EXPECT_EQ(put(store, find_of(15)), Put::kNew);
  EXPECT_THAT(cases_in(folder.path()), UnorderedElementsAre(find_of(3), find_of(15)));
}

TEST_F(StoreInAFolder, ANamedEntryThatIsDisownedStaysAndHidesNothing) {
  ASSERT_TRUE(store.put_named("forged", find_of(1)));
  ASSERT_TRUE(store.disown(kMissed, folder / "forged.json"));
  EXPECT_EQ(put(store, find_of(15)), Put::kNew);
  EXPECT_THAT(cases_in(folder.path()), UnorderedElementsAre(find_of(1), find_of(15)));
}

TEST(Store, MovesAsideAnEntryNamedByAFailureThatItDoesNotShow) {
  const ScratchFolder folder;
  Case other = find_of(1, "trad");
  ASSERT_TRUE(write_file(folder / "tdibm-missed-VV-at-an-end.json", to_json(other)));
  Store store = open_store(folder.path());
  EXPECT_EQ(put(store, find_of(7)), Put::kNew);
  EXPECT_THAT(cases_in(folder.path()), UnorderedElementsAre(other, find_of(7)));
}

TEST_F(StoreInAFolder, RefusesARefutedFind) {
  Case wrong = find_of(3);
  wrong.truth.witness->t = Rational(1, 2);
  const auto done = try_put(store, wrong);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message(), testing::StartsWith("truth.witness.uv: "));
}

TEST(Store, WritesToCasesWhereThatIsAndKnowsTheSeeds) {
  const ScratchFolder folder;
  fs::create_directories(folder / "cases");
  fs::create_directories(folder / "seeds");
  ASSERT_TRUE(write_file(folder / "seeds/a.json", to_json(find_of(3)) + "\n"));
  Store store = open_store(folder.path());
  EXPECT_EQ(put(store, find_of(7)), Put::kKnown);
  EXPECT_EQ(put(store, find_of(7, "trad")), Put::kNew);
  EXPECT_TRUE(fs::exists(folder / "cases/trad-missed-VV-at-an-end.json"));
  EXPECT_EQ(put(store, find_of(1)), Put::kNew);
  EXPECT_TRUE(fs::exists(folder / "seeds/a.json"));
}

}  // namespace
}  // namespace ccdfuzz
