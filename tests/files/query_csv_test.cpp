#include "files/query_csv.hpp"
#include "bezier/exact_patch.hpp"

#include <gmock/gmock.h>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

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
Result<std::vector<CsvQuery>> read(const std::string& text, CsvLayout layout) {
  const ScratchFolder folder;
  const std::string path = folder / "q.csv";
  write_text(path, text);
  auto reader = CsvReader::open(path, {.layout = layout});
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

TEST(QueryCsv, RoundsWaysToVelocitiesWhereAsked) {
  std::string text = kVertexFaceRows;
  text.replace(text.find("1,4,1,4,-1,2"), 12, "1,4,1,1152921504606846976,-1,2");
  const auto queries = read(text, CsvLayout::kVertexFace);
  const CsvQuery& rows = queries->front();
  EXPECT_TRUE(has_ends(to_case(rows, {}, 0)->query));
  const auto value = to_case(rows, {.round_ways = true}, 0);
  EXPECT_FALSE(has_ends(value->query));
  // From 1/4 to 2^-60.
  EXPECT_EQ(value->query.patches[0].velocities[0][1], -0.25);
  EXPECT_EQ(value->origin.more.at("rounded"), "1");
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

}  // namespace
}  // namespace ccdfuzz
