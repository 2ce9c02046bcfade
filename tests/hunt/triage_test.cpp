#include "hunt/triage.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

#include "certify/checker/check_truth.hpp"
#include "files/case_json.hpp"
#include "finds/content_address.hpp"
#include "finds/failure.hpp"
#include "generators/contact.hpp"
#include "hunt/draw.hpp"
#include "hunt/serve.hpp"
#include "scratch_folder.hpp"
#include "served_by_test.hpp"

namespace ccdfuzz {
namespace {

constexpr const char* kFails = "tdibm";

TriageOptions quick_options() {
  TriageOptions options;
  options.methods = {kFails, "tdibm-c"};
  options.search.max_pops = 2000;
  options.shrink_trials = 60;
  return options;
}

/// Contacts as a fuzzer hands them over: nothing is known but the contact.
std::vector<Case> raw_finds() {
  std::vector<Case> finds;
  for (std::uint64_t i = 0; i < 4; ++i) {
    for (const CheckedCase& asked : Draws(3).at(ContactClass::kVV, i)) {
      if (const auto q = contact_of(asked.value())) finds.push_back(case_of(*q));
    }
  }
  return finds;
}

struct TriageFind {
  Failure failure;
  Case value;
};

std::vector<TriageFind> triaged(Triage& triage, const std::vector<Case>& raw) {
  std::vector<TriageFind> finds;
  for (const Case& candidate : raw) {
    EXPECT_TRUE(triage.add(candidate, [&](const Failure& failure, const Case& find) {
      finds.push_back({failure, find});
    }));
  }
  return finds;
}

struct TriageIntoAStore : testing::Test {
  ScratchFolder folder;
  Store store = Store::open(folder.path()).value();
};

TEST_F(TriageIntoAStore, StoresWhatFailsShrunkWithItsTruthAndFindsNothingTwice) {
  const std::vector<Case> raw = raw_finds();
  Triage first(store, quick_options());
  const std::vector<TriageFind> finds = triaged(first, raw);
  ASSERT_GE(finds.size(), 1U);
  std::set<Failure> failures;
  for (const TriageFind& find : finds) {
    EXPECT_EQ(find.failure.who, kFails);
    EXPECT_TRUE(is_false_negative(find.failure.outcome));
    EXPECT_EQ(find.value.expect.at("tdibm-c"), Outcome::kCorrect);
    EXPECT_TRUE(check_truth(find.value)) << to_json(find.value);
    EXPECT_TRUE(failures.insert(find.failure).second) << to_text(find.failure) << " twice";
    EXPECT_EQ(failure_of(find.value, kFails, find.value.expect.at(kFails)), find.failure);
  }
  EXPECT_EQ(first.tally().inputs, raw.size());
  EXPECT_EQ(first.tally().failures, first.tally().known + finds.size());
  EXPECT_EQ(store.load().value().size(), finds.size());

  Triage again(store, quick_options());
  std::vector<Case> backwards(raw.rbegin(), raw.rend());
  EXPECT_THAT(triaged(again, backwards), testing::IsEmpty()) << "in whatever order";
  EXPECT_EQ(again.tally().failures, again.tally().known);
}

/// Misses contacts where t_max is large.
struct Farsighted : Method {
  explicit Farsighted(double limit_) : limit(limit_) {}

  Answered answer(const Query& query, const SearchOptions&) override {
    return query.t_max >= limit ? Answered{Answer::miss()} : Answered();
  }

  double limit;
};

/// Fails on contacts by its spec's name: where a velocity of the first patch is not 0.
struct Failing : Method {
  explicit Failing(std::string how_) : how(std::move(how_)) {}

  Answered answer(const Query& query, const SearchOptions&) override {
    const auto& velocities = query.patches[0].velocities;
    if (std::ranges::all_of(velocities, [](const auto& v) { return v.isZero(); })) return {};
    if (how == "aborts") std::abort();
    if (how == "throws") throw std::runtime_error("cannot");
    while (how == "spins") asm volatile("");
    return {Answer::miss()};
  }

  std::string how;
};

/// What the children of these tests have: whatever is no method of ours fails as its name says.
/// Words behind "--triage" say what of its errands is made up.
void serve_made_up(int argc, char** argv) {
  Served served;
  served.make = [](const std::string& spec) -> Result<std::unique_ptr<Method>> {
    if (spec.starts_with("far:")) return std::make_unique<Farsighted>(std::stod(spec.substr(4)));
    if (auto ours = make_method(spec)) return ours;
    return std::make_unique<Failing>(spec);
  };
  const std::string last = argv[argc - 1];
  const bool is_made_up = argc > 2 && std::string(argv[argc - 2]) == "--triage";
  served.errand = [last](const std::string& question) -> std::string {
    const auto is_made_up_as = [&](const std::string& name, const char* how) {
      return last == name + how && question.starts_with("{\"errand\":\"" + name);
    };
    if (is_made_up_as("decide", " aborts") || is_made_up_as("refute", " aborts")) std::abort();
    return is_made_up_as("refute", " all") ? R"({"text":"it is lost"})" : served_errand(question);
  };
  serve_if_asked(is_made_up ? argc - 1 : argc, argv, served);
}

[[maybe_unused]] const bool serves = (served_by_test = serve_made_up, true);

/// A method that spins is given little time, so that others are not to be judged by what they do.
Result<std::unique_ptr<Method>> served_patiently(const std::string& spec) {
  ChildLimits limits = kServedLimits;
  if (spec == "spins") limits.cpu_seconds = 0.04;
  return served_method(spec, limits);
}

TEST_F(TriageIntoAStore, AsksAnInputAsItStandsToo) {
  Case far = raw_finds().front();
  const double limit = 16 * far.query.t_max;
  far.query.t_max = limit;
  TriageOptions options = quick_options();
  options.methods = {fmt::format("far:{}", limit)};
  options.make = served_patiently;
  Triage triage(store, options);
  const std::vector<TriageFind> finds = triaged(triage, {far});
  ASSERT_EQ(finds.size(), 1U);
  EXPECT_EQ(finds[0].failure.outcome, Outcome::kMissed);
  EXPECT_GE(finds[0].value.query.t_max, limit);
}

// A miss of a contact at the end of the query says less than one of a contact before it.
TEST_F(TriageIntoAStore, KeepsTheFormThatConvincesMost) {
  TriageOptions options = quick_options();
  options.methods = {"far:0"};
  options.make = served_patiently;
  Triage triage(store, options);
  const std::vector<TriageFind> finds = triaged(triage, {raw_finds().front()});
  ASSERT_EQ(finds.size(), 1U);
  EXPECT_EQ(finds[0].failure.setting, Setting::kOrdinary);
}

TEST_F(TriageIntoAStore, FindsAnewWhatItCouldNotShrinkToTheEnd) {
  TriageOptions options = quick_options();
  options.methods = {kFails};
  bool is_over = false;
  int asked = 0;
  options.stop = [&] { return is_over && ++asked > 1; };
  Triage triage(store, options);
  const std::vector<Case> raw = raw_finds();
  // Over as soon as a failure is being shrunk: nothing of it is had.
  is_over = true;
  for (const Case& candidate : raw) {
    asked = 0;
    EXPECT_THAT(triaged(triage, {candidate}), testing::IsEmpty());
  }
  EXPECT_GT(triage.tally().failures, 0U);
  EXPECT_EQ(triage.tally().known, 0U);
  is_over = false;
  EXPECT_GE(triaged(triage, raw).size(), 1U);
}

TEST_F(TriageIntoAStore, AsksNoMethodOnceItIsToStop) {
  TriageOptions options = quick_options();
  int asked = 0;
  options.make = [&](const std::string& spec) {
    ++asked;
    return make_served_method(spec);
  };
  options.stop = [&] { return asked == 1; };
  Triage triage(store, options);
  EXPECT_TRUE(triaged(triage, {raw_finds().front()}).empty());
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(triage.tally().harmless, 0U) << "not all methods were asked";
}

TEST_F(TriageIntoAStore, DecidesWhatComesWithoutTruth) {
  Triage triage(store, quick_options());
  std::vector<Case> raw = raw_finds();
  for (Case& c : raw) c.truth = {};
  EXPECT_GE(triaged(triage, raw).size(), 1U);
}

TriageOptions failing_options(const std::vector<std::string>& methods) {
  TriageOptions options = quick_options();
  options.methods = methods;
  options.make = served_patiently;
  return options;
}

TEST(Triage, KeepsACrashOfEachNameShrunkWithWhatOthersSay) {
  const std::vector<Case> raw = raw_finds();
  const std::map<std::string, std::string> names = {
      {"aborts", "crash SIGABRT"}, {"throws", "exception"}, {"spins", "hang"}};
  for (const auto& [method, name] : names) {
    const ScratchFolder folder;
    Store store = Store::open(folder.path()).value();
    // What spins is given so little time that no other can be judged by it.
    const bool spins = method == "spins";
    Triage triage(store, failing_options(spins ? std::vector{method}
                                               : std::vector<std::string>{method, "tdibm-c"}));
    const std::vector<TriageFind> finds = triaged(triage, {raw.begin(), raw.begin() + 1});
    ASSERT_EQ(finds.size(), 1U) << method;
    const TriageFind& find = finds.front();
    EXPECT_EQ(find.failure.outcome, Outcome::kError);
    EXPECT_EQ(find.failure.cause, name);
    EXPECT_EQ(find.value.expect.at(method), Expected(Outcome::kError, name));
    EXPECT_LT(size_of(find.value.query), size_of(raw.front().query)) << to_json(find.value);
    EXPECT_TRUE(check_truth(find.value)) << to_json(find.value);
    if (!spins) {
      EXPECT_TRUE(find.value.truth.collides) << to_json(find.value);
      EXPECT_EQ(find.value.expect.at("tdibm-c"), Outcome::kCorrect) << to_json(find.value);
    }

    Triage again(store, failing_options({method}));
    const auto few = raw.begin() + (method == "spins" ? 1 : 3);
    EXPECT_THAT(triaged(again, {raw.begin(), few}), testing::IsEmpty());
    EXPECT_EQ(again.tally().known, few - raw.begin());
  }
}

TEST(Triage, ACrashOfTheOracleIsAFind) {
  Case raw = raw_finds().front();
  raw.truth = {};
  for (const bool repeats : {true, false}) {
    const ScratchFolder folder;
    Store store = Store::open(folder.path()).value();
    TriageOptions options = quick_options();
    options.methods = {"tdibm-c"};
    options.errands = {"--triage", "decide aborts"};
    options.make = [&](const std::string& spec) {
      return spec == "oracle" && repeats ? served_patiently("aborts") : make_served_method(spec);
    };
    std::vector<std::string> warnings;
    options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
    Triage triage(store, options);
    const std::vector<TriageFind> finds = triaged(triage, {raw, raw});
    if (!repeats) {
      EXPECT_THAT(finds, testing::IsEmpty());
      EXPECT_THAT(warnings, testing::SizeIs(2));
      EXPECT_THAT(warnings[0], testing::HasSubstr("the oracle came to grief: crash SIGABRT: "));
      continue;
    }
    ASSERT_EQ(finds.size(), 1U);
    EXPECT_EQ(finds[0].failure.who, "oracle");
    EXPECT_EQ(finds[0].failure.cause, "crash SIGABRT");
    EXPECT_EQ(finds[0].value.expect.at("oracle"), Expected(Outcome::kError, "crash SIGABRT"));
    EXPECT_EQ(triage.tally().known, 1U) << "the same again";
    EXPECT_THAT(warnings, testing::IsEmpty());
  }
}

TEST_F(TriageIntoAStore, TellsWhatRefutesAClaimThoughNoFullRunFails) {
  TriageOptions options = quick_options();
  options.methods = {"tdibm-c"};
  std::vector<std::string> warnings;
  options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
  const Case raw = raw_finds().front();
  EXPECT_TRUE(Triage(store, options).add(raw, [](const Failure&, const Case&) { FAIL(); }));
  EXPECT_THAT(warnings, testing::IsEmpty());
  options.errands = {"--triage", "refute all"};
  Triage refuted(store, options);
  EXPECT_TRUE(refuted.add(raw, [](const Failure&, const Case&) { FAIL(); }));
  options.errands = {"--triage", "refute aborts"};
  Triage crashed(store, options);
  EXPECT_TRUE(crashed.add(raw, [](const Failure&, const Case&) { FAIL(); }));
  EXPECT_THAT(warnings,
              testing::ElementsAre("no full run of a sound method fails, but: it is lost",
                                   "no full run of a sound method fails, but: crash SIGABRT"));
  EXPECT_EQ(refuted.tally().refuting, 1U);
  EXPECT_EQ(crashed.tally().refuting, 1U);
  // Nor does what other methods fail on hide it.
  warnings.clear();
  options.methods = {kFails};
  options.errands = {"--triage", "refute all"};
  Triage failing(store, options);
  EXPECT_THAT(triaged(failing, raw_finds()), testing::Not(testing::IsEmpty()));
  EXPECT_EQ(failing.tally().refuting, raw_finds().size());
  EXPECT_EQ(warnings.size(), raw_finds().size());
}

TEST_F(TriageIntoAStore, KeepsWhatCannotBeTraced) {
  Triage triage(store, failing_options({"misses"}));
  const std::vector<TriageFind> finds = triaged(triage, raw_finds());
  ASSERT_EQ(finds.size(), 1U) << "one class";
  EXPECT_EQ(finds[0].failure.outcome, Outcome::kMissed);
  EXPECT_EQ(finds[0].failure.cause, "");
  EXPECT_EQ(store.load().value().size(), 1U);
}

}  // namespace
}  // namespace ccdfuzz
