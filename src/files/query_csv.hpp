#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/enum_names.hpp"
#include "case/case.hpp"
#include "io/line_reader.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// What the rows of a query CSV stand for. In each, all start points come first, then all end
/// points in the same order:
///   edge-edge    8 rows: both ends of edge 1, both ends of edge 2
///   vertex-face  8 rows: the vertex, the three corners of the face
///   curved       24 rows: the 6 control points of two quadratic triangles, each in Shape's order
enum class CsvLayout { kEdgeEdge, kVertexFace, kCurved };

constexpr std::array<std::string_view, 3> names_of(CsvLayout) {
  return {"edge-edge", "vertex-face", "curved"};
}
inline constexpr auto kAllCsvLayouts = all_of(CsvLayout{});

/// The shapes of both patches.
std::array<Shape, 2> csv_shapes(CsvLayout layout);

/// The layout that a path tells: a folder or file with the layout's name in it. As in other public
/// sets, a file name that ends in "ee.csv" or "vf.csv" tells it, too.
std::optional<CsvLayout> csv_layout_of_path(const std::string& path);

/// The layout in which a query may be written: edge-edge two curves of degree 1, vertex-face a
/// point and a triangle of degree 1, curved two triangles of degree 2.
std::optional<CsvLayout> csv_layout_of(const Query& query);

/// A query as a file gives it, exactly: its control points go from `start` at t = 0 to `end` at
/// t = 1. A vertex or edge 1 is patch 1.
struct CsvQuery {
  CsvLayout layout = CsvLayout::kEdgeEdge;
  std::string path;
  std::vector<size_t> lines;  ///< the line of each row
  std::array<std::vector<Vec3<Rational>>, 2> start, end;
  std::optional<bool> label;  ///< what the file says: there is a contact

  /// "path:line" of the first row.
  std::string id() const;
  /// Its exact motion over t in [0, 1].
  std::array<MovingPatch<Rational>, 2> patches() const;
};

/// How query CSVs are read.
struct CsvOptions {
  std::optional<CsvLayout> layout = {};  ///< for all files; absent: what the path of each tells
  std::string truths = {};               ///< a JSON list of truths; empty: there is none
  bool round = true;                     ///< numbers that are no doubles; otherwise refuse them
  bool round_ways = false;  ///< take the velocities nearest to ways that are no doubles
  bool any_name = false;    ///< whatever its path ends in, a file is one
};

/// Reads a query CSV one query after the other. A row is xn,xd,yn,yd,zn,zd, numerators and
/// denominators of any size, and then the query's truth, 0 or 1. Without truths in the rows, a file
/// of its own may have a JSON list of them. Blanks around values, blank lines and lines that begin
/// with # are skipped.
class CsvReader {
 public:
  /// Errors: as InputBytes::open; neither the options nor the path tell the layout; no list of
  /// truths.
  static Result<CsvReader> open(const std::string& path, const CsvOptions& options = {});

  /// The next query; nothing at the end. Errors name file, row, column and value: no number; a
  /// denominator ≤ 0; a wrong number of columns; a file without a query, or that ends within one.
  /// Or truths differ within a query, or are more or fewer than queries.
  Result<std::optional<CsvQuery>> next();

  /// Bytes of the file read so far.
  std::uint64_t position() const { return lines_.position(); }

 private:
  explicit CsvReader(LineReader lines) : lines_(std::move(lines)) {}
  Result<Vec3<Rational>> point_of(const std::vector<std::string>& fields) const;
  Result<std::optional<bool>> label_of(const std::vector<std::string>& fields) const;
  Result<std::vector<std::string>> next_row();
  Result<void> check_end(size_t row, size_t rows) const;

  LineReader lines_;
  CsvLayout layout_ = CsvLayout::kEdgeEdge;
  std::optional<std::vector<bool>> truths_;
  std::string truths_path_;
  size_t given_ = 0;  ///< queries
};

/// The query in doubles, t_max = 1. Positions are the start points. The patches have velocities, if
/// all ways to the end points are doubles, and floats where all points are. Otherwise they have
/// ends. A number of the file that is no double is refused, or with `round` becomes the nearest one
/// and is counted in `rounded`. Errors, naming file, row, column and value: such a number; one past
/// the range of doubles in any case.
Result<Query> to_query(const CsvQuery& from, bool round, std::uint64_t& rounded);

/// The query (to_query) as a case without a truth, with velocities if ways are to be rounded. What
/// the file says is origin.more["label"], 0 or 1, and how many numbers are not those of the file
/// origin.more["rounded"], if any. A linear query has its class, EE or VF, and the kind
/// kLinearKind. index: of the query in its file. Errors: as to_query.
Result<Case> to_case(const CsvQuery& from, const CsvOptions& options, std::uint64_t index);
inline constexpr std::string_view kLinearKind = "linear";

/// The rows of a query, the vertex or edge 1 first; its end points are those at t_max. Rounds as
/// to_query. Requires csv_layout_of(query). Errors: as to_query; `where` names the query.
Result<CsvQuery> to_csv_query(const Query& query, const std::string& where, bool round,
                              std::uint64_t& rounded);

/// The text of its rows. Requires a label.
std::string to_csv(const CsvQuery& query);

}  // namespace ccdfuzz
