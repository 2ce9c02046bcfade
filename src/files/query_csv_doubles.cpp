#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "base/verify.hpp"
#include "bezier/exact_patch.hpp"
#include "case/scale.hpp"
#include "files/query_csv.hpp"

namespace ccdfuzz {

namespace {

/// The double nearest to x, the even one of two; infinite past the range.
double nearest_double(const Rational& x) {
  const double lo = round_down(x), hi = round_up(x);
  if (lo == hi || std::isinf(lo)) return lo;
  if (std::isinf(hi)) return hi;
  const Rational below = x - exact(lo), above = exact(hi) - x;
  if (below != above) return below < above ? lo : hi;
  return std::bit_cast<std::uint64_t>(lo) % 2 == 0 ? lo : hi;
}

std::string shortened(const std::string& number) {
  constexpr size_t kLongest = 60;
  return number.size() > kLongest ? number.substr(0, kLongest) + "…" : number;
}

/// x as a double, or the complaint "what x is not a double".
Result<double> as_double(const Rational& x, bool round, std::uint64_t& rounded,
                         const std::string& where, const std::string& what) {
  if (const auto exactly = to_double_exactly(x)) return *exactly;
  const double nearest = nearest_double(x);
  if (std::isinf(nearest)) {
    return input_error(where, "{} {} is past the range of doubles", what, shortened(to_text(x)));
  }
  if (!round) {
    return input_error(where, "{} {} is not a double; --round takes the nearest", what,
                       shortened(to_text(x)));
  }
  ++rounded;
  return nearest;
}

/// Puts the velocities nearest to the ways in place of ends. Returns how many are others. Ends stay
/// where a way is past the range of doubles.
std::uint64_t round_ways(MovingPatch<double>& patch) {
  Points<double> ways(patch.ends.size());
  std::uint64_t others = 0;
  for (size_t i = 0; i < ways.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Rational way = exact(patch.ends[i][k]) - exact(patch.positions[i][k]);
      ways[i][k] = nearest_double(way);
      if (std::isinf(ways[i][k])) return 0;
      if (exact(ways[i][k]) != way) ++others;
    }
  }
  if (!ways.empty()) {
    patch.velocities = std::move(ways);
    patch.ends.clear();
  }
  return others;
}

}  // namespace

Result<Query> to_query(const CsvQuery& from, bool round, std::uint64_t& rounded) {
  Query query;
  const std::array<Shape, 2> shapes = csv_shapes(from.layout);
  size_t row = 0;
  const size_t half = from.lines.size() / 2;
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    patch.shape = shapes[s];
    for (size_t i = 0; i < from.start[s].size(); ++i, ++row) {
      for (const bool at_end : {false, true}) {
        const Vec3<Rational>& point = (at_end ? from.end : from.start)[s][i];
        const std::string where =
            fmt::format("{}:{}", from.path, from.lines[at_end ? row + half : row]);
        Vec3<double>& number = (at_end ? patch.ends : patch.positions).emplace_back();
        for (int k = 0; k < 3; ++k) {
          const auto x = as_double(point[k], round, rounded, where, fmt::format("{} =", "xyz"[k]));
          if (!x) return tl::unexpected(x.error());
          number[k] = *x;
        }
      }
    }
  }
  query.t_max = 1;
  const auto moving = with_velocities(query);
  // A query of floats stays one: velocities may take more digits than ends.
  return moving && (!is_binary32(query) || is_binary32(*moving)) ? *moving : query;
}

Result<Case> to_case(const CsvQuery& from, const CsvOptions& options, std::uint64_t index) {
  std::uint64_t rounded = 0;
  Case value;
  CCDFUZZ_TRY(value.query, to_query(from, options.round, rounded));
  if (options.round_ways) {
    for (MovingPatch<double>& patch : value.query.patches) rounded += round_ways(patch);
  }
  Origin& origin = value.origin;
  origin.generator = "import";
  origin.index = index;
  if (from.label) origin.more["label"] = *from.label ? "1" : "0";
  if (rounded > 0) origin.more["rounded"] = fmt::format("{}", rounded);
  if (from.layout == CsvLayout::kCurved) return value;
  origin.contact = from.layout == CsvLayout::kEdgeEdge ? "EE" : "VF";
  origin.kind = kLinearKind;
  return value;
}

Result<CsvQuery> to_csv_query(const Query& query, const std::string& where, bool round,
                              std::uint64_t& rounded) {
  const auto layout = csv_layout_of(query);
  CCDFUZZ_VERIFY(layout);
  CsvQuery out;
  out.layout = *layout;
  const bool swapped = query.patches[0].shape != csv_shapes(*layout)[0];
  const Rational t_max = exact(query.t_max);
  for (size_t s = 0; s < 2; ++s) {
    const size_t side = swapped ? 1 - s : s;
    const MovingPatch<double>& patch = query.patches[side];
    const Points<Rational> ends = exact_patch<Rational>(patch).at(t_max);
    for (size_t i = 0; i < ends.size(); ++i) {
      Vec3<Rational> start, end;
      for (int k = 0; k < 3; ++k) {
        const std::string what =
            fmt::format("patches[{}], control point {}: {} at t_max =", side, i, "xyz"[k]);
        CCDFUZZ_TRY(const auto x, as_double(ends[i][k], round, rounded, where, what));
        start[k] = exact(patch.positions[i][k]);
        end[k] = exact(x);
      }
      out.start[s].push_back(start);
      out.end[s].push_back(end);
    }
  }
  return out;
}

std::string to_csv(const CsvQuery& query) {
  CCDFUZZ_VERIFY(query.label.has_value());
  std::string text;
  for (const auto* points : {&query.start, &query.end}) {
    for (const auto& side : *points) {
      for (const Vec3<Rational>& p : side) {
        for (int k = 0; k < 3; ++k) {
          text += fmt::format("{},{},", p[k].get_num().get_str(), p[k].get_den().get_str());
        }
        text += *query.label ? "1\n" : "0\n";
      }
    }
  }
  return text;
}

}  // namespace ccdfuzz
