// Random sequences of what happens to a store, held to a model: a map from failures to finds.
#include <filesystem>
#include <map>
#include <optional>

#include <rapidcheck/state.h>
#include "finds/content_address.hpp"
#include "finds/finds.hpp"
#include "finds/store.hpp"
#include "rapidcheck.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

using Put = Store::Put;

struct StoreModel {
  std::map<Failure, Case> finds;  ///< the smallest of each failure
  std::uint64_t removals = 0;     ///< of the folder
};

struct StoreUnderTest {
  ScratchFolder scratch;
  std::string folder = scratch / "finds";
  std::optional<Store> store = open_store(folder);
};

using StoreCommand = rc::state::Command<StoreModel, StoreUnderTest>;

/// The folder holds the finds of the model, each under the name of its failure, and nothing else.
void check_folder(const StoreModel& model, StoreUnderTest& sut) {
  const auto entries = sut.store->load();
  RC_ASSERT(entries.has_value());
  std::map<Failure, Case> held;
  for (const NamedCase& entry : *entries) {
    const std::optional<Failure> failure = named_by_failure(entry);
    RC_ASSERT(failure.has_value());
    RC_ASSERT(entry.id == sut.store->path_of(*failure));
    held[*failure] = entry.value;
  }
  RC_ASSERT(held == model.finds);
  const auto files = std::filesystem::directory_iterator(sut.folder);
  const auto visible = std::count_if(begin(files), end(files), [](const auto& file) {
    return !file.path().filename().string().starts_with('.');
  });
  RC_ASSERT(static_cast<size_t>(visible) == model.finds.size());
}

struct PutFind : StoreCommand {
  Case find;

  PutFind() {
    // No query is a find of two methods: of one both expectations would be kept.
    const auto who = *rc::gen::inRange<size_t>(0, 3);
    const std::string method = std::array{"tdibm", "trad", "tdibm-e"}.at(who);
    const auto x = *rc::gen::inRange(0, 8) * 8 + static_cast<int>(who) * 2 + 1;
    const Outcome outcome = *rc::gen::element(Outcome::kMissed, Outcome::kLate);
    find = find_of(x + (outcome == Outcome::kLate ? 64 : 0), method, outcome);
  }

  Failure failure() const { return failures_of(find).front(); }
  static bool is_smaller(const Case& a, const Case& b) {
    return rank_of(a.query) < rank_of(b.query);
  }

  void apply(StoreModel& model) const override {
    const auto [standing, is_new] = model.finds.try_emplace(failure(), find);
    if (!is_new && is_smaller(find, standing->second)) standing->second = find;
  }
  void run(const StoreModel& model, StoreUnderTest& sut) const override {
    const auto standing = model.finds.find(failure());
    const Put expected = standing == model.finds.end()        ? Put::kNew
                         : is_smaller(find, standing->second) ? Put::kSmaller
                                                              : Put::kKnown;
    RC_ASSERT(put(*sut.store, find) == expected);
    check_folder(nextState(model), sut);
  }
  void show(std::ostream& out) const override { out << "put " << to_json(find); }
};

struct Reopen : StoreCommand {
  void run(const StoreModel& model, StoreUnderTest& sut) const override {
    sut.store.reset();
    sut.store = open_store(sut.folder);
    check_folder(model, sut);
  }
  void show(std::ostream& out) const override { out << "open the folder again"; }
};

struct RemoveFolder : StoreCommand {
  void apply(StoreModel& model) const override { model.finds.clear(); }
  void run(const StoreModel&, StoreUnderTest& sut) const override {
    std::filesystem::remove_all(sut.folder);
    RC_ASSERT(sut.store->load()->empty());
  }
  void show(std::ostream& out) const override { out << "remove the folder"; }
};

struct AskForStanding : StoreCommand {
  PutFind of;

  void run(const StoreModel& model, StoreUnderTest& sut) const override {
    const auto standing = sut.store->standing(of.failure());
    RC_ASSERT(standing.has_value());
    const auto expected = model.finds.find(of.failure());
    RC_ASSERT(standing->has_value() == (expected != model.finds.end()));
    if (*standing) RC_ASSERT((*standing)->value == expected->second);
  }
  void show(std::ostream& out) const override { out << "standing: " << to_text(of.failure()); }
};

RC_GTEST_PROP(StoreState, HoldsTheSmallestFindOfEachFailureWhateverHappens, ()) {
  StoreUnderTest sut;
  rc::state::check(StoreModel(), sut,
                   rc::state::gen::execOneOfWithArgs<PutFind, PutFind, PutFind, Reopen,
                                                     RemoveFolder, AskForStanding>());
}

}  // namespace
}  // namespace ccdfuzz
