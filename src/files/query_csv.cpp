#include "files/query_csv.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "base/text.hpp"
#include "io/json_tree.hpp"

namespace ccdfuzz {

namespace {

constexpr size_t kLongestCsvLine = 1 << 20;
constexpr size_t kLongestTruthList = 16 << 20;  // three million truths
/// Those of doubles and of their sums and differences have at most 1,074 bits, 324 digits. Exact
/// decisions multiply numbers of that denominator, so that it bounds their time.
constexpr size_t kMostDenominatorDigits = 1000;
constexpr std::array<const char*, 7> kColumns = {"xn", "xd", "yn", "yd", "zn", "zd", "truth"};

/// A value as a message shows it.
std::string shown_text(std::string_view text) {
  constexpr size_t kShown = 60;
  return fmt::format("\"{}{}\"", text.substr(0, kShown), text.size() > kShown ? "…" : "");
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields = texts_between(std::string(line));
  for (std::string& field : fields) field = trimmed(field);
  return fields;
}

/// Errors: the common denominator of the query's numbers is too long, naming its first line.
Result<void> check_denominator(const CsvQuery& query) {
  Integer all = 1;
  for (const auto* points : {&query.start, &query.end}) {
    for (const auto& side : *points) {
      for (const Vec3<Rational>& point : side) {
        for (int k = 0; k < 3; ++k) all = lcm(all, point[k].get_den());
        const size_t digits = mpz_sizeinbase(all.get_mpz_t(), 10);
        if (digits > kMostDenominatorDigits) {
          return input_error(query.id(),
                             "the numbers of this query have a common denominator of "
                             "more than {} digits, the most that is read",
                             kMostDenominatorDigits);
        }
      }
    }
  }
  return {};
}

Result<Integer> parse_integer(std::string_view text) {
  std::string_view digits = text;
  if (digits.starts_with('-')) digits.remove_prefix(1);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) {
    const bool is_word = !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0;
    return input_error("", shown_text(text) + " is not a whole number" +
                               (is_word ? "; a CSV of queries has no row of names" : ""));
  }
  if (digits.size() > kMaxRationalDigits) {
    return input_error("", "{} has {} digits; at most {} are read", shown_text(text), digits.size(),
                       kMaxRationalDigits);
  }
  return Integer(std::string(text), 10);  // without the base, a leading 0 is octal
}

Result<std::vector<bool>> read_truths(const std::string& path) {
  CCDFUZZ_TRY(const auto text, read_text(path, kLongestTruthList));
  CCDFUZZ_TRY(const auto tree, parse_json(text, path));
  if (tree.kind != JsonKind::kArray) return input_error(path, "is not a JSON list of truths");
  std::vector<bool> truths;
  for (size_t i = 0; i < tree.items.size(); ++i) {
    const JsonValue& item = tree.items[i];
    const bool is_truth = item.kind == JsonKind::kBool || item.text == "0" || item.text == "1";
    if (!is_truth) {
      return input_error(fmt::format("{}: [{}]", path, i),
                         shown(item) + " is not a truth (true, false, 0, 1)");
    }
    truths.push_back(item.text == "true" || item.text == "1");
  }
  return truths;
}

}  // namespace

std::array<Shape, 2> csv_shapes(CsvLayout layout) {
  constexpr std::array<std::array<Shape, 2>, kAllCsvLayouts.size()> kShapes = {
      {{Shape::curve(1), Shape::curve(1)},
       {Shape::point(), Shape::triangle(1)},
       {Shape::triangle(2), Shape::triangle(2)}}};
  return kShapes[static_cast<size_t>(layout)];
}

std::optional<CsvLayout> csv_layout_of_path(const std::string& path) {
  const std::filesystem::path p(path);
  for (const std::filesystem::path& part : {p.filename(), p.parent_path().filename()}) {
    for (const CsvLayout layout : kAllCsvLayouts) {
      if (part.string().find(name_of(layout)) != std::string::npos) return layout;
    }
  }
  // Not of "knee.csv".
  const std::string name = " " + p.filename().string();
  const auto ends_in_word = [&](std::string_view word) {
    return name.ends_with(word) &&
           std::isalpha(static_cast<unsigned char>(name[name.size() - word.size() - 1])) == 0;
  };
  if (ends_in_word("ee.csv")) return CsvLayout::kEdgeEdge;
  if (ends_in_word("vf.csv")) return CsvLayout::kVertexFace;
  return std::nullopt;
}

std::optional<CsvLayout> csv_layout_of(const Query& query) {
  const std::array<Shape, 2> shapes = {query.patches[0].shape, query.patches[1].shape};
  for (const CsvLayout layout : kAllCsvLayouts) {
    const std::array<Shape, 2> wanted = csv_shapes(layout);
    if (shapes == wanted || shapes == std::array{wanted[1], wanted[0]}) return layout;
  }
  return std::nullopt;
}

std::string CsvQuery::id() const {
  return fmt::format("{}:{}", path, lines.front());
}

std::array<MovingPatch<Rational>, 2> CsvQuery::patches() const {
  std::array<MovingPatch<Rational>, 2> out;
  const std::array<Shape, 2> shapes = csv_shapes(layout);
  for (size_t s = 0; s < 2; ++s) {
    out[s] = {shapes[s], start[s], end[s]};
    for (size_t i = 0; i < end[s].size(); ++i) {
      for (int k = 0; k < 3; ++k) out[s].velocities[i][k] -= start[s][i][k];
    }
  }
  return out;
}

Result<Vec3<Rational>> CsvReader::point_of(const std::vector<std::string>& fields) const {
  Vec3<Rational> point;
  for (size_t k = 0; k < 3; ++k) {
    std::array<Integer, 2> parts;
    for (size_t i = 0; i < 2; ++i) {
      const size_t column = 2 * k + i;
      const auto refuse = [&](const std::string& why) {
        return input_error(lines_.here(), "column {} ({}): {}", column + 1, kColumns[column], why);
      };
      auto number = parse_integer(fields[column]);
      if (!number) return refuse(number.error().what);
      if (i == 1 && *number <= 0) return refuse(shown_text(fields[column]) + " is not > 0");
      parts[i] = *std::move(number);
    }
    point[static_cast<int>(k)] = Rational(parts[0], parts[1]);
    point[static_cast<int>(k)].canonicalize();
  }
  return point;
}

/// Its truth if there is a column for it.
Result<std::optional<bool>> CsvReader::label_of(const std::vector<std::string>& fields) const {
  if (fields.size() < kColumns.size()) return std::nullopt;
  if (fields.back() == "0" || fields.back() == "1") return fields.back() == "1";
  return input_error(lines_.here(), "column 7 (truth): {} is neither 0 nor 1",
                     shown_text(fields.back()));
}

/// The fields of the next row; none at the end.
Result<std::vector<std::string>> CsvReader::next_row() {
  for (;;) {
    CCDFUZZ_TRY(const auto text, lines_.next());
    if (!text) return std::vector<std::string>();
    std::string_view row = *text;
    // Spreadsheets begin files with a byte order mark.
    if (lines_.line() == 1 && row.starts_with("\xEF\xBB\xBF")) row.remove_prefix(3);
    row = trimmed(row);
    if (row.empty() || row.front() == '#') continue;
    std::vector<std::string> fields = fields_of(row);
    if (fields.size() == 6 || fields.size() == 7) return fields;
    return input_error(lines_.here(), "{} columns, not 6 or 7 (xn,xd,yn,yd,zn,zd,truth)",
                       fields.size());
  }
}

/// Errors: the file may not end before this row of the rows of a query.
Result<void> CsvReader::check_end(size_t row, size_t rows) const {
  if (row > 0) {
    return input_error(lines_.here(), "ends after row {} of the {} of its last {} query", row, rows,
                       name_of(layout_));
  }
  if (given_ == 0) return input_error(lines_.path(), "holds no query");
  if (truths_ && truths_->size() != given_) {
    return input_error(truths_path_, "has {} truths, but {} has {} queries", truths_->size(),
                       lines_.path(), given_);
  }
  return {};
}

Result<std::optional<CsvQuery>> CsvReader::next() {
  const std::array<Shape, 2> shapes = csv_shapes(layout_);
  const std::array counts = {static_cast<size_t>(shapes[0].control_count()),
                             static_cast<size_t>(shapes[1].control_count())};
  const size_t rows = 2 * (counts[0] + counts[1]);
  CsvQuery query;
  query.layout = layout_;
  query.path = lines_.path();
  for (auto* points : {&query.start, &query.end}) {
    for (size_t s = 0; s < 2; ++s) {
      for (size_t i = 0; i < counts[s]; ++i) {
        CCDFUZZ_TRY(const auto fields, next_row());
        if (fields.empty()) {
          CCDFUZZ_TRY_VOID(check_end(query.lines.size(), rows));
          return std::nullopt;
        }
        CCDFUZZ_TRY(auto point, point_of(fields));
        CCDFUZZ_TRY(const auto label, label_of(fields));
        if (!query.lines.empty() && query.label != label) {
          return input_error(lines_.here(),
                             "column 7 (truth): differs from that of the query's row in line " +
                                 std::to_string(query.lines.front()));
        }
        query.label = label;
        query.lines.push_back(lines_.line());
        (*points)[s].push_back(std::move(point));
      }
    }
  }
  if (truths_) {
    if (query.label) {
      return input_error(truths_path_, "has truths, but so has {} in its rows", lines_.path());
    }
    if (given_ >= truths_->size()) {
      return input_error(truths_path_, "has {} truths, but {} has more queries", truths_->size(),
                         lines_.path());
    }
    query.label = (*truths_)[given_];
  }
  CCDFUZZ_TRY_VOID(check_denominator(query));
  ++given_;
  return query;
}

Result<CsvReader> CsvReader::open(const std::string& path, const CsvOptions& options) {
  CCDFUZZ_TRY(auto lines, LineReader::open(path, false, kLongestCsvLine));
  const auto layout = options.layout ? options.layout : csv_layout_of_path(path);
  if (!layout) {
    return input_error(
        path,
        "does not tell its layout: name edge-edge, vertex-face or curved in its name "
        "or its folder's, or `ccdfuzz import --as`");
  }
  CsvReader reader(std::move(lines));
  reader.layout_ = *layout;
  reader.truths_path_ = options.truths;
  if (!options.truths.empty()) {
    CCDFUZZ_TRY(reader.truths_, read_truths(options.truths));
  }
  return reader;
}

}  // namespace ccdfuzz
