#include "files/query_csv.hpp"
#include "bezier/exact_patch.hpp"

#include <gmock/gmock.h>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

constexpr const char* kVertexFaceRows =
    "# a vertex falls through a face\n"
    "1,4, 1,4, 1,1, 1\n"
    " 0, 1,0 ,1,0,1,1\n"
    "\n"
    "0,1,1,1,0,1,1\r\n"
    "1,1,0,1,0,1,1\n"
    "1,4,1,4,-1,2,1\n"
    "# the face stays\n"
    "0,1,0,1,0,1,1\n"
    "0,1,1,1,0,1,1\n"
    "1,1,0,1,0,1,1";

/// All queries of a text, or the first complaint.
Result<std::vector<CsvQuery>> read(const std::string& text, CsvLayout layout,
                                   const std::string& truths = "") {
  const ScratchFolder folder;
  const std::string path = folder / "q.csv", truths_path = folder / "t.json";
  write_text(path, text);
  if (!truths.empty()) write_text(truths_path, truths);
  auto reader =
      CsvReader::open(path, {.layout = layout, .truths = truths.empty() ? "" : truths_path});
  if (!reader) return tl::unexpected(reader.error());
  std::vector<CsvQuery> queries;
  for (;;) {
    auto next = reader->next();
    if (!next) {
      InputError error = next.error();
      error.where.erase(0, folder.path().size() + 1);
      return tl::unexpected(error);
    }
    if (!*next) return queries;
    queries.push_back(**std::move(next));
  }
}

/// The first query of a text that is read, in doubles. Counts what is rounded.
Query query_of(const Result<std::vector<CsvQuery>>& read, bool rounds, std::uint64_t& rounded) {
  if (!read) throw std::runtime_error(read.error().message());
  const auto query = to_query(read->front(), rounds, rounded);
  if (!query) throw std::runtime_error(query.error().message());
  return *query;
}

TEST(QueryCsv, ReadsRowsWithCommentsAndBlanks) {
  const auto queries = read(kVertexFaceRows, CsvLayout::kVertexFace);
  std::uint64_t rounded = 0;
  const Query query = query_of(queries, false, rounded);
  ASSERT_EQ(queries->size(), 1U);
  EXPECT_EQ(queries->front().label, true);
  EXPECT_THAT(queries->front().lines, testing::ElementsAre(2, 3, 5, 6, 7, 9, 10, 11));
  EXPECT_EQ(rounded, 0U);
  EXPECT_EQ(query.t_max, 1);
  EXPECT_EQ(query.patches[0].shape, Shape::point());
  EXPECT_EQ(query.patches[0].positions[0], Vec3<double>(0.25, 0.25, 1));
  EXPECT_EQ(query.patches[0].velocities[0], Vec3<double>(0, 0, -1.5));
  EXPECT_EQ(query.patches[1].shape, Shape::triangle(1));
  EXPECT_EQ(query.patches[1].positions[2], Vec3<double>(1, 0, 0));
}

/// All of `from` in a text, or all lines of it, by `to`.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(QueryCsv, ALeadingZeroIsNoOctalNumber) {
  std::string rows;
  for (int i = 0; i < 8; ++i) rows += "010,01,-08,010,00,09,1\n";
  std::uint64_t rounded = 0;
  const Query query = query_of(read(rows, CsvLayout::kEdgeEdge), true, rounded);
  EXPECT_EQ(query.patches[0].positions[0], Vec3<double>(10, -0.8, 0));
}

TEST(QueryCsv, ReadsWhateverEndsAndBeginsALine) {
  const std::string rows = kVertexFaceRows;
  for (const std::string& text :
       {replaced(rows, "\n", "\r\n"), replaced(rows, "\n", " \t\n"), rows + "\n",
        "\xEF\xBB\xBF" + rows, "\xEF\xBB\xBF# a comment\n" + rows, replaced(rows, ",", " ,\t"),
        replaced(rows, "\n", "\n  # 1,2,3\n"), replaced(rows, "\n", "\n\n \n")}) {
    const auto queries = read(text, CsvLayout::kVertexFace);
    ASSERT_TRUE(queries) << queries.error().message() << "\n" << text;
    ASSERT_EQ(queries->size(), 1U) << text;
    EXPECT_EQ(queries->front().label, true);
    EXPECT_EQ(queries->front().start[0][0], Vec3<Rational>(Rational(1, 4), Rational(1, 4), 1));
  }
  const auto truncated =
      read(rows + "\n" + rows.substr(0, rows.size() / 2), CsvLayout::kVertexFace);
  ASSERT_FALSE(truncated);
  EXPECT_THAT(truncated.error().message(), testing::ContainsRegex("q.csv:1[0-9]: "));
}

TEST(QueryCsv, WritesWhatItReads) {
  for (const CsvLayout layout : kAllCsvLayouts) {
    Query query{{MovingPatch<double>{csv_shapes(layout)[0], {}, {}},
                 MovingPatch<double>{csv_shapes(layout)[1], {}, {}}},
                1};
    double x = 0;
    for (MovingPatch<double>& patch : query.patches) {
      for (int i = 0; i < patch.shape.control_count(); ++i) {
        x += 0.125;
        patch.positions.push_back({x, -x * 0x1p-600, 0x1p900});
        patch.velocities.push_back({-x, 0, 0x1p901});
      }
    }
    EXPECT_EQ(csv_layout_of(query), layout);
    std::uint64_t rounded = 0;
    auto rows = to_csv_query(query, "", false, rounded);
    ASSERT_TRUE(rows) << rows.error().message();
    rows->label = false;
    const auto back = read(to_csv(*rows) + to_csv(*rows), layout);
    ASSERT_TRUE(back) << back.error().message();
    ASSERT_EQ(back->size(), 2U);
    EXPECT_EQ(back->back().label, false);
    EXPECT_EQ(*to_query(back->back(), false, rounded), query) << name_of(layout);
    std::swap(query.patches[0], query.patches[1]);
    EXPECT_EQ(csv_layout_of(query), layout);
    EXPECT_EQ(rounded, 0U);
  }
}

TEST(QueryCsv, RoundsOnlyWhenTold) {
  std::string thirds = kVertexFaceRows;
  thirds.replace(thirds.find("1,4, 1,4"), 3, "1,3");
  const auto queries = read(thirds, CsvLayout::kVertexFace);
  ASSERT_TRUE(queries) << queries.error().message();
  std::uint64_t rounded = 0;
  const auto refused = to_query(queries->front(), false, rounded);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("q.csv:2: x = 1/3 is not a double"));
  EXPECT_THAT(refused.error().message(), HasSubstr("--round"));
  ASSERT_TRUE(to_query(queries->front(), true, rounded));
  EXPECT_EQ(rounded, 1U);
}

TEST(QueryCsv, KeepsEndsWhoseWayIsNoDouble) {
  std::string text = kVertexFaceRows;
  text.replace(text.find("1,4,1,4,-1,2"), 12, "1,4,1,1152921504606846976,-1,2");
  const auto queries = read(text, CsvLayout::kVertexFace);
  std::uint64_t rounded = 0;
  const Query query = query_of(queries, false, rounded);
  EXPECT_EQ(rounded, 0U);
  EXPECT_FALSE(with_velocities(query));
  EXPECT_EQ(query.patches[0].ends[0][1], 0x1p-60);
  for (size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(exact_patch<Rational>(query.patches[s]), queries->front().patches()[s]);
  }
  // And back, to the bit.
  const auto rows = to_csv_query(query, "q", false, rounded);
  ASSERT_TRUE(rows) << rows.error().message();
  EXPECT_EQ(rows->end, queries->front().end);
}

TEST(QueryCsv, RoundsToTheNearestEvenOfTwo) {
  std::string text = kVertexFaceRows;
  // 1 + 3·2^-53 lies between 1 + 2^-52 and 1 + 2^-51; it does not move.
  const std::string half = "9007199254740995,9007199254740992";
  text.replace(text.find("1,4, 1,4"), 3, half);
  text.replace(text.find("1,4,1,4,-1,2"), 3, half);
  std::uint64_t rounded = 0;
  const Query query = query_of(read(text, CsvLayout::kVertexFace), true, rounded);
  EXPECT_EQ(query.patches[0].positions[0][0], 1 + 0x1p-51);
  EXPECT_EQ(query.patches[0].velocities[0][0], 0);
  EXPECT_EQ(rounded, 2U);
}

TEST(QueryCsv, TakesTruthsFromAListBeside) {
  std::string text;
  for (int i = 0; i < 16; ++i) text += "0,1,0,1,0,1\n";
  const auto queries = read(text, CsvLayout::kEdgeEdge, "[true, 0]");
  ASSERT_TRUE(queries) << queries.error().message();
  ASSERT_EQ(queries->size(), 2U);
  EXPECT_EQ((*queries)[0].label, true);
  EXPECT_EQ((*queries)[1].label, false);
  EXPECT_EQ(read(text, CsvLayout::kEdgeEdge)->front().label, std::nullopt);
  for (const char* wrong : {"[true]", "[true, false, false]", "[true, 2]", "{}", "[true"}) {
    EXPECT_FALSE(read(text, CsvLayout::kEdgeEdge, wrong)) << wrong;
  }
}

struct Spoilt {
  const char* from;
  const char* to;
  const char* message;
};

TEST(QueryCsv, NamesFileRowColumnAndValue) {
  const std::vector<Spoilt> all = {
      {"1,4, 1,4", "1,4, 1,0", "q.csv:2: column 4 (yd): \"0\" is not > 0"},
      {"1,4, 1,4", "1,4, 1,-4", "q.csv:2: column 4 (yd): \"-4\" is not > 0"},
      {"1,4, 1,4", "1.5,4, 1,4", "q.csv:2: column 1 (xn): \"1.5\" is not a whole number"},
      {"1,4, 1,4", "1,4, 1/2,4", "q.csv:2: column 3 (yn): \"1/2\" is not a whole number"},
      {"1,4, 1,4", ",4, 1,4", "q.csv:2: column 1 (xn): \"\" is not a whole number"},
      {"1,4, 1,4", "1,4, 1", "q.csv:3: column 7 (truth): differs"},
      {"1,4, 1,4, 1,1, 1", "1,4, 1,4, 1", "q.csv:2: 5 columns, not 6 or 7"},
      {"1,1, 1\n", "1,1, 2\n", "q.csv:2: column 7 (truth): \"2\" is neither 0 nor 1"},
      {"1,1, 1\n", "1,1, 0\n", "q.csv:3: column 7 (truth): differs from that of the query's row"},
      {"\n1,1,0,1,0,1,1", "", "ends after row 6 of the 8 of its last vertex-face query"},
      {kVertexFaceRows, "# nothing\n", "q.csv: holds no query"},
  };
  for (const Spoilt& spoilt : all) {
    std::string text = kVertexFaceRows;
    for (size_t at = 0; (at = text.find(spoilt.from, at)) != std::string::npos;) {
      text.replace(at, std::string(spoilt.from).size(), spoilt.to);
      at += std::string(spoilt.to).size();
      if (spoilt.from[0] != '\n') break;
    }
    const auto queries = read(text, CsvLayout::kVertexFace);
    ASSERT_FALSE(queries) << spoilt.message;
    EXPECT_THAT(queries.error().message(), HasSubstr(spoilt.message));
  }
}

/// Rows of a vertex-face query, the z of which has the denominators b + 1, b + 2, …
std::string rows_over(const Integer& base) {
  std::string rows;
  for (int i = 1; i <= 8; ++i) rows += "0,1,0,1,1," + Integer(base + i).get_str() + "\n";
  return rows;
}

TEST(QueryCsv, RefusesALongCommonDenominator) {
  Integer base;
  mpz_ui_pow_ui(base.get_mpz_t(), 10, 110);
  EXPECT_TRUE(read(rows_over(base), CsvLayout::kVertexFace));
  mpz_ui_pow_ui(base.get_mpz_t(), 10, 140);
  const auto refused = read("# a comment\n" + rows_over(base), CsvLayout::kVertexFace);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(),
              HasSubstr("q.csv:2: the numbers of this query have a common denominator of more than "
                        "1000 digits, the most that is read"));
  // Doubles of any size have a common one.
  Integer most;
  mpz_ui_pow_ui(most.get_mpz_t(), 2, 1074);
  std::string rows;
  for (int i = 1; i <= 8; ++i) {
    rows += fmt::format("0,1,{}1,{},1,{}\n", std::string(300, '9'), most.get_str(), 1U << i);
  }
  EXPECT_TRUE(read(rows, CsvLayout::kVertexFace));
}

TEST(QueryCsv, ReadsNumeratorsOfAsManyDigitsAsRationals) {
  const auto rows = [](size_t digits) {
    return rows_over(1) + "0,1,0,1,-" + std::string(digits, '7') + ",1\n";
  };
  const auto longest = read(rows(kMaxRationalDigits), CsvLayout::kVertexFace);
  EXPECT_THAT(longest.error().message(), HasSubstr("ends after row 1"));  // the row is read
  const auto longer = read(rows(kMaxRationalDigits + 1), CsvLayout::kVertexFace);
  EXPECT_THAT(
      longer.error().message(),
      HasSubstr("q.csv:9: column 5 (zn): \"-777777777777777777777777777777777777777777777777"
                "77777777777…\" has 5001 digits; at most 5000 are read"));
}

TEST(QueryCsv, KnowsLayoutsByTheirPaths) {
  EXPECT_EQ(csv_layout_of_path("a/edge-edge/data_0_0.csv"), CsvLayout::kEdgeEdge);
  EXPECT_EQ(csv_layout_of_path("vertex-face-3.csv"), CsvLayout::kVertexFace);
  EXPECT_EQ(csv_layout_of_path("queries/12vf.csv"), CsvLayout::kVertexFace);
  EXPECT_EQ(csv_layout_of_path("queries/12ee.csv"), CsvLayout::kEdgeEdge);
  EXPECT_EQ(csv_layout_of_path("curved/x.csv"), CsvLayout::kCurved);
  EXPECT_EQ(csv_layout_of_path("a/data_0_0.csv"), std::nullopt);
}

}  // namespace
}  // namespace ccdfuzz
