#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "meeting_points.hpp"
#include "report/pack.hpp"
#include "report/report.hpp"
#include "report/rows.hpp"
#include "report/template.hpp"
#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

using Json = nlohmann::json;

/// Two points that meet at t = 1/2, of t_max 1.
Case meeting(const std::string& contact) {
  Case value;
  value.query = meeting_points(1);
  value.truth.collides = true;
  value.truth.witness = Witness{Rational(1, 2), {}};
  value.origin.contact = contact;
  value.origin.kind = "RP";
  return value;
}

GivenAnswer answered(const std::string& method, Outcome outcome, std::optional<double> toi = {}) {
  GivenAnswer given;
  given.method = method;
  given.outcome = outcome;
  given.toi = toi;
  return given;
}

ReportedCase reported(const std::string& contact, Outcome outcome) {
  ReportedCase one;
  one.id = "some.json";
  one.value = meeting(contact);
  one.answers = {answered("tdibm", outcome)};
  return one;
}

size_t count(const std::string& text, const std::string& what) {
  size_t n = 0;
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++n;
  return n;
}

Json element(const std::string& page, const std::string& id) {
  const std::string open = "<script id=\"" + id + "\" type=\"application/json\">";
  const size_t from = page.find(open) + open.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

Json data_of(const std::string& page) {
  return element(page, "report");
}

TEST(ReportPage, IsTheTemplateWithItsDataWhenNothingIsReported) {
  const std::string page = report_page({}, 1);
  EXPECT_EQ(count(std::string(report_template()), std::string(kReportDataMark)), 1U);
  EXPECT_EQ(count(page, std::string(kReportDataMark)), 0U);
  EXPECT_EQ(data_of(page)["cases"].size(), 0U);
}

TEST(ReportPage, NeedsNothingFromElsewhere) {
  const std::string page(report_template());
  for (const char* fetched : {"<script src", "<link rel=\"stylesheet\"", "@import", "<img"}) {
    EXPECT_EQ(count(page, fetched), 0U) << fetched;
  }
}

TEST(ReportPage, NoTextOfACaseEndsTheElementThatHoldsIt) {
  ReportPage report;
  report.title = "</script><script>alert(1)</script><!--";
  report.cases = {reported("</script>", Outcome::kMissed)};
  report.cases[0].id = "<!--<script>.json";
  const std::string page = report_page(report, 1), empty = report_page({}, 1);
  EXPECT_EQ(count(page, "</script>"), count(empty, "</script>") + 1) << "one for the details";
  EXPECT_EQ(data_of(page)["title"], report.title);
  EXPECT_EQ(data_of(page)["cases"][0][0], report.cases[0].id);
}

TEST(ReportPage, HasTheCourseOfAHuntAndTheScoreboard) {
  ReportPage report;
  report.hunted = {"tdibm", "trad"};
  report.course = {{0.5, 10, 100, 1, {3, std::nullopt}}};
  report.scoreboard = R"({"rows": [{"what": "</script>"}]})";
  const std::string page = report_page(report, 1), none = report_page({}, 1);
  EXPECT_EQ(data_of(page)["course"]["samples"][0], Json::parse("[0.5, 10, 100, 1, [3, null]]"));
  EXPECT_EQ(element(page, "scoreboard"), Json::parse(report.scoreboard)) << "as it stands";
  EXPECT_TRUE(data_of(none)["course"].is_null());
  EXPECT_EQ(count(none, R"(id="scoreboard")"), 0U);
}

TEST(ReportPage, HasWhatPluginsSaidOfThemselvesAndNothingOfThoseThatAreGone) {
  const ScratchFolder folder;
  const std::string program = folder / "known";
  write_text(program, R"(#!/bin/sh
read question
echo '{"protocol":1,"name":"mine","version":"1.0","conservative":true}'
)");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  ASSERT_TRUE(name_plugin("known", "plugin-exec:" + program));
  ASSERT_TRUE(std::filesystem::remove(program));
  ReportPage report;
  const std::string known = "plugin:known", gone = "plugin:lost.so";
  report.cases = {reported("VV", Outcome::kMissed)};
  report.cases[0].answers.push_back(answered(known, Outcome::kCorrect, 0.5));
  report.cases[0].answers.push_back(answered(gone, Outcome::kMissed));
  const Json data = data_of(report_page(report, 1));
  EXPECT_EQ(data["methods"][0]["spec"], "tdibm");
  EXPECT_EQ(data["methods"][1],
            (Json{{"spec", known}, {"description", "mine 1.0"}, {"claims", true}}));
  EXPECT_EQ(data["methods"][2], (Json{{"spec", gone}}));
  EXPECT_EQ(data["cases"][0][4], "mcm");
}

TEST(ReportPage, ACaseHasItsSettingItsBitsAndTheCausesOfItsFailures) {
  ReportPage report;
  report.cases = {reported("VV", Outcome::kMissed)};
  report.cases[0].answers.push_back(answered("plugin:./gone.so", Outcome::kError));
  report.cases[0].answers.push_back(answered("tdibm-c", Outcome::kCorrect, 0.5));
  report.cases[0].value.expect = {{"tdibm", {Outcome::kMissed, "left root"}},
                                  {"plugin:./gone.so", {Outcome::kError, "hang"}},
                                  {"tdibm-c", {Outcome::kCorrect}}};
  const Json row = data_of(report_page(report, 1))["cases"][0];
  EXPECT_EQ(row[7], "ordinary");
  EXPECT_EQ(row[8], 4U) << "four ones: two velocities, a position and t_max";
  EXPECT_EQ(row[9], (Json{{"tdibm", "left root"}, {"plugin:./gone.so", "hang"}}));
}

TEST(ReportPage, TakesTheCauseFromTheTraceWhenACaseExpectsNone) {
  ReportPage report;
  report.cases = {reported("VV", Outcome::kMissed)};
  const Json row = data_of(report_page(report, 1))["cases"][0];
  EXPECT_EQ(row[9], (Json{{"tdibm", ""}})) << "which loses nothing here";
}

TEST(ReportPage, IsTheOnlyFileOfItsFolder) {
  ReportPage report;
  report.scoreboard = "{}";
  report.tables.push_back({"table-3", "Linear queries", Table({{"a"}})});
  report.tables.back().table.add_row({{"b"}});
  report.cases = {reported("VV", Outcome::kMissed)};
  const ScratchFolder folder;
  ASSERT_TRUE(write_report(report, folder / "page", 1));
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "page")) {
    names.insert(entry.path().filename());
  }
  EXPECT_EQ(names, (std::set<std::string>{"index.html"}));
  EXPECT_EQ(data_of(read_text(folder / "page/index.html"))["tables"][0]["rows"][0][0], "b");
}

TEST(ReportPage, HasFewerCasesWhenItIsTooLarge) {
  ReportPage report;
  for (int i = 0; i < 150; ++i) {
    report.cases.push_back(reported("VV", Outcome::kMissed));
    report.cases.back().id = std::to_string(i);
  }
  const ScratchFolder folder;
  const size_t most = report_page({}, 1).size() + 10'000;
  ASSERT_GT(report_page(report, 1).size(), most);
  ASSERT_TRUE(write_report(report, folder / "page", 1, most));
  const std::string page = read_text(folder / "page/index.html");
  EXPECT_LE(page.size(), most);
  const size_t kept = data_of(page)["cases"].size();
  EXPECT_GT(kept, 0U);
  EXPECT_EQ(data_of(page)["cases_left_out"], 150 - kept);
}

TEST(ReportPage, IsTheSameWithAnyNumberOfThreads) {
  ReportPage report;
  for (int i = 0; i < 100; ++i) {
    report.cases.push_back(reported(i % 2 == 0 ? "VV" : "VE", Outcome::kMissed));
    report.cases.back().id = std::to_string(i);
  }
  EXPECT_EQ(report_page(report, 1), report_page(report, 4));
}

TEST(ReportPage, KeepsAsManyOfEverySort) {
  ReportPage report;
  report.cases.assign(100, reported("VV", Outcome::kMissed));
  report.cases.push_back(reported("FF", Outcome::kMissed));
  report.cases.push_back(reported("VV", Outcome::kLate));
  keep_most_telling(report, 10);
  ASSERT_EQ(report.cases.size(), 10U);
  EXPECT_EQ(report.cases_left_out, 92U);
  EXPECT_EQ(report.cases[8].value.origin.contact, "FF");
  EXPECT_EQ(report.cases[9].answers[0].outcome, Outcome::kLate);
}

TEST(ReportRows, AreSummedUpAndFailuresAreKept) {
  Rows rows;
  ReportRows shown;
  const auto add = [&](const char* id, Outcome of_tdibm) {
    EvaluatedCase one{0, id, "VV", "", true, {}};
    for (const auto& [method, outcome] :
         {std::pair("tdibm", of_tdibm), std::pair("tdibm-c", Outcome::kCorrect)}) {
      one.answers.push_back(answered(method, outcome));
      one.answers.back().cost.seconds = .5;
    }
    rows.add(one);
    shown.add(one, meeting("VV"), 1e-4);
  };
  add("a", Outcome::kCorrect);
  add("b", Outcome::kMissed);
  ReportPage report;
  shown.finish(report, rows, {});
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_EQ(report.rows[0].key.method, "tdibm");
  EXPECT_EQ(report.rows[0].tally.count(Outcome::kMissed), 1U);
  EXPECT_EQ(report.rows[1].tally.seconds.sum(), 1);
  ASSERT_EQ(report.cases.size(), 1U) << "the case without a failure has no place beside one";
  EXPECT_EQ(report.cases[0].id, "b");
  EXPECT_EQ(report.cases[0].answers.size(), 2U);
}

TEST(Pack, IsGzipInBase64) {
  const std::string packed = gzip_base64("abc");
  EXPECT_TRUE(packed.starts_with("H4sI")) << packed;
  EXPECT_EQ(packed.size() % 4, 0U);
  EXPECT_EQ(packed, gzip_base64("abc"));
  EXPECT_LT(gzip_base64(std::string(100'000, 'x')).size(), 1000U);
}

}  // namespace
}  // namespace ccdfuzz
