#include "finds/store.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <random>

#include "base/output_file.hpp"
#include "case/case_json.hpp"
#include "finds/finds.hpp"
#include "rapidcheck.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using Added = Store::Added;
using testing::ElementsAre;

TEST(Store, KeepsAFindUnderItsAddress) {
  const ScratchFolder folder;
  Store store = open_store(folder / "new/finds");
  EXPECT_EQ(add(store, find_of(3)), Added::kNew);
  const auto entries = load_corpus(folder / "new/finds");
  ASSERT_TRUE(entries) << entries.error().message();
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->at(0).value, find_of(3));
  EXPECT_EQ(entries->at(0).id, folder / "new/finds/" + content_address(find_of(3).query) + ".json");
  EXPECT_EQ(add(store, find_of(3)), Added::kKnown);
}

TEST(Store, ASmallerFindTakesThePlaceOfALargerOne) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  EXPECT_EQ(add(store, find_of(7)), Added::kNew);
  EXPECT_EQ(add(store, find_of(15)), Added::kKnown);
  EXPECT_EQ(add(store, find_of(3)), Added::kSmaller);
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
  EXPECT_EQ(folder.entry_count(), 1U);
}

TEST(Store, FailuresOfOtherMethodsClassesAndSignaturesStandApart) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  EXPECT_EQ(add(store, find_of(3)), Added::kNew);
  EXPECT_EQ(add(store, find_of(5, "tdibm-h:1e-16")), Added::kNew);
  EXPECT_EQ(add(store, find_of(7, "tdibm", Outcome::kLate)), Added::kNew);
  EXPECT_EQ(add(store, find_of(9, "tdibm", Outcome::kMissed, "VE")), Added::kNew);
  Case other_generator = find_of(11);
  other_generator.origin.generator = "grazing";
  EXPECT_EQ(add(store, other_generator), Added::kNew);
  EXPECT_EQ(cases_in(folder.path()).size(), 5U);
}

TEST(Store, TheSameQueryFailingTwoMethodsIsOneEntry) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  add(store, find_of(3, "tdibm"));
  EXPECT_EQ(add(store, find_of(3, "trad", Outcome::kLate)), Added::kMerged);
  EXPECT_EQ(add(store, find_of(3, "tdibm-e", Outcome::kCorrect)), Added::kMerged);
  Case both = find_of(3, "tdibm");
  both.expect["trad"] = Outcome::kLate;
  both.expect["tdibm-e"] = Outcome::kCorrect;
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(both));
}

TEST(Store, NeverChangesAnExpectation) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  add(store, find_of(3));
  EXPECT_EQ(add(store, find_of(3, "tdibm", Outcome::kLate)), Added::kKnown);
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
}

TEST(Store, AnEntryStaysForTheFailuresOfWhichNoSmallerOneTells) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  Case both = find_of(15, "tdibm");
  both.expect["trad"] = Outcome::kMissed;
  add(store, both);
  EXPECT_EQ(add(store, find_of(3, "tdibm")), Added::kSmaller);
  EXPECT_THAT(cases_in(folder.path()),
              testing::UnorderedElementsAre(find_of(3, "tdibm"), find_of(15, "trad")));
  EXPECT_EQ(add(store, both), Added::kKnown);
  Case smaller = find_of(7, "tdibm");
  smaller.expect["trad"] = Outcome::kMissed;
  EXPECT_EQ(add(store, smaller), Added::kSmaller);  // than 15 for trad, but not than 3 for tdibm
  EXPECT_THAT(cases_in(folder.path()),
              testing::UnorderedElementsAre(find_of(3, "tdibm"), find_of(7, "trad")));
}

TEST(Store, NamedEntriesAreNeverTakenAway) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  Case named = find_of(7);
  named.origin.name = "underflow-in-tdibm";
  EXPECT_EQ(add(store, named), Added::kNew);
  EXPECT_TRUE(fs::exists(folder / "underflow-in-tdibm.json"));
  EXPECT_EQ(add(store, find_of(15)), Added::kKnown);
  EXPECT_EQ(add(store, find_of(3)), Added::kSmaller);
  EXPECT_EQ(cases_in(folder.path()).size(), 2U);
  Case second = find_of(15);
  second.origin.name = "second";
  EXPECT_EQ(add(store, second), Added::kSmaller) << "kept though larger";
  EXPECT_EQ(cases_in(folder.path()).size(), 3U);
}

TEST(Store, WhatTwoFindsComeDownToTakesThePlaceOfBoth) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  Case other = find_of(15);
  other.origin.generator = "mutant";
  add(store, find_of(3));
  add(store, other);
  Case simpler = find_of(3);
  simpler.origin.generator = "mutant";
  EXPECT_EQ(add(store, simpler), Added::kKnown);  // under the origin that it has already
  EXPECT_EQ(cases_in(folder.path()).size(), 2U);
  ASSERT_TRUE(store.supersede(other, "tdibm", simpler));
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(find_of(3)));
}

TEST(Store, OtherFailuresAndNamedEntriesAreNotSuperseded) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  add(store, find_of(3));
  const Case late = find_of(15, "tdibm", Outcome::kLate);
  const Case other_class = find_of(17, "tdibm", Outcome::kMissed, "VE");
  const Case other_method = find_of(19, "trad");
  Case named = find_of(21);
  named.origin.name = "kept";
  for (const Case& find : {late, other_class, other_method, named}) {
    add(store, find);
    ASSERT_TRUE(store.supersede(find, find.expect.begin()->first, find_of(3)));
  }
  ASSERT_TRUE(store.supersede(find_of(3), "tdibm", find_of(3)));
  ASSERT_TRUE(store.supersede(find_of(3), "tdibm", find_of(33)));  // which is not there
  ASSERT_TRUE(store.supersede(find_of(33), "tdibm", find_of(3)));
  EXPECT_EQ(cases_in(folder.path()).size(), 5U);
}

TEST(Store, AFindMayGetANameLater) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  add(store, find_of(7));
  Case named = find_of(7);
  named.origin.name = "first";
  EXPECT_EQ(add(store, named), Added::kMerged);
  EXPECT_THAT(cases_in(folder.path()), ElementsAre(named));
  EXPECT_EQ(add(store, find_of(7)), Added::kKnown);
  named.origin.name = "again";
  EXPECT_EQ(add(store, named), Added::kKnown);
}

TEST(Store, NamesThatAreNoFileNamesOrTakenAreErrors) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  const auto refused = [&](const std::string& name, double x) {
    Case named = find_of(x);
    named.origin.name = name;
    const auto added = store.add(named);
    return added ? "accepted" : added.error().message();
  };
  EXPECT_EQ(refused("good", 3), "accepted");
  EXPECT_EQ(refused("good", 5), folder / "good.json: holds another case of this name");
  for (const std::string bad : {"../up", ".hidden", "a b", "\xc3\xa4"}) {
    EXPECT_THAT(refused(bad, 5), testing::StartsWith("origin.name: ")) << bad;
  }
  EXPECT_EQ(cases_in(folder.path()).size(), 1U);
}

TEST(Store, RefusesARefutedFind) {
  const ScratchFolder folder;
  Store store = open_store(folder.path());
  Case wrong = find_of(3);
  wrong.truth.witness->t = Rational(1, 2);
  const auto added = store.add(wrong);
  ASSERT_FALSE(added);
  EXPECT_THAT(added.error().message(), testing::StartsWith("truth.witness.uv: "));
}

TEST(Store, WritesToRegressionsWhereThatIsAndKnowsTheSeeds) {
  const ScratchFolder folder;
  fs::create_directories(folder / "regressions");
  fs::create_directories(folder / "seeds");
  ASSERT_TRUE(write_file(folder / "seeds/a.json", to_json(find_of(3)) + "\n"));
  Store store = open_store(folder.path());
  EXPECT_EQ(add(store, find_of(7)), Added::kKnown);
  EXPECT_EQ(add(store, find_of(7, "trad")), Added::kNew);
  EXPECT_TRUE(fs::exists(folder / "regressions/" + content_address(find_of(7).query) + ".json"));
  EXPECT_EQ(add(store, find_of(1)), Added::kSmaller);
  EXPECT_TRUE(fs::exists(folder / "seeds/a.json"));
}

TEST(Store, TheOrderOfFindsDoesNotMatter) {
  std::vector<Case> finds;
  for (const double x : {5, 7, 9, 11}) {
    finds.push_back(find_of(x, "tdibm"));
    if (x < 7) continue;
    finds.push_back(find_of(x, "trad", Outcome::kLate));
    finds.push_back(find_of(x, "tdibm"));
    finds.back().expect["trad"] = Outcome::kLate;
    finds.back().expect["tdibm-e"] = Outcome::kCorrect;
  }
  std::vector<std::string> first;
  std::mt19937 engine(1);  // the same on every machine, unlike the distributions
  for (int round = 0; round < 10; ++round) {
    for (size_t i = finds.size(); i > 1; --i) std::swap(finds[i - 1], finds[engine() % i]);
    const ScratchFolder folder;
    Store store = open_store(folder.path());
    for (const Case& find : finds) add(store, find);
    std::vector<std::string> texts;
    for (Case c : cases_in(folder.path())) {
      std::erase_if(c.expect, [](const auto& e) { return !is_failure(e.second.outcome); });
      texts.push_back(to_json(c));
    }
    if (round == 0) first = texts;
    EXPECT_EQ(texts, first);
  }
  EXPECT_THAT(first, testing::SizeIs(testing::Ge(1U)));
}

TEST(Store, RefusesAnEntryUnderTheAddressOfAnotherAtOnce) {
  const ScratchFolder folder;
  const std::string path = folder / (content_address(find_of(3).query) + ".json");
  write_text(path, to_json(find_of(4)));
  const auto store = Store::open(folder.path());
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().where, path);
  EXPECT_NE(store.error().what.find(content_address(find_of(4).query)), std::string::npos);
}

TEST(LoadCorpus, AnEmptyOrMissingCorpusIsAnError) {
  const ScratchFolder folder;
  write_text(folder / "README.md", "no entry");
  EXPECT_EQ(load_corpus(folder.path()).error().message(),
            folder.path() + ": the corpus is empty: no .json entry in it");
  EXPECT_EQ(load_corpus(folder / "none").error().message(),
            folder / "none: cannot read: No such file or directory");
  std::filesystem::create_symlink("nowhere", folder / "entry.json");
  EXPECT_EQ(load_corpus(folder.path()).error().message(),
            folder / "entry.json: cannot read: No such file or directory");
  write_text(folder / "file", "");
  EXPECT_EQ(Store::open(folder / "file").error().message(),
            folder / "file: cannot make the folder: Not a directory");
}

}  // namespace
}  // namespace ccdfuzz
