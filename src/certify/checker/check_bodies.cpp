#include "certify/checker/check_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "case/scale.hpp"
#include "certify/checker/abbreviated.hpp"
#include "certify/checker/check_turning.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kWitness = "truth.witness";
constexpr const char* kBodyClear = "truth.certificate.clear";

Rational reach_of(const Query& query) {
  return exact(query.separation) + exact(query.patches[0].radius) + exact(query.patches[1].radius);
}

/// Charges for `operations` with numbers of so many words besides those of a few doubles.
void charge_for(std::uint64_t operations, std::uint64_t words, Work& work) {
  constexpr std::uint64_t kDoubles = 72;  // words of four doubles as fractions
  work.charge(operations * fraction_work(words + kDoubles));
}

/// The radius of a ball about the point that the weights make, which is in the hull; in the plane
/// z = 0, of a disc. The first four points of a weight > 0 that span a volume (three, an area) are
/// the corners of a simplex. A way d from the point changes the weight of a corner by at most |d|
/// over its height above the face that is opposite.
Rational radius_within(const MovingPatch<double>& hull, const std::vector<Rational>& weights,
                       bool in_plane, Work& work) {
  constexpr std::uint64_t kOperations = 64;
  const size_t count = in_plane ? 3 : 4;
  Points<Rational> corners;
  std::vector<Rational> of_corners;
  const auto way = [&](size_t to, size_t from) {
    return Vec3<Rational>(corners[to % count] - corners[from % count]);
  };
  const auto is_spanned = [&] {
    if (corners.size() == 1) return true;
    if (corners.size() == 2) return way(1, 0) != Vec3<Rational>(0, 0, 0);
    const Vec3<Rational> normal = cross(way(1, 0), way(2, 0));
    if (corners.size() == 3) return normal != Vec3<Rational>(0, 0, 0);
    return normal.dot(way(3, 0)) != 0;
  };
  for (size_t i = 0; i < weights.size() && corners.size() < count; ++i) {
    if (weights[i] <= 0) continue;
    charge_for(kOperations, 0, work);
    corners.push_back(exact(hull.positions[i]));
    of_corners.push_back(weights[i]);
    if (!is_spanned()) corners.pop_back(), of_corners.pop_back();
  }
  if (corners.size() < count) return 0;
  const Vec3<Rational> up(0, 0, 1);
  Rational least_squared = -1;
  for (size_t i = 0; i < count; ++i) {
    charge_for(kOperations, words_of(of_corners[i]), work);
    const Vec3<Rational> normal = cross(way(i + 2, i + 1), in_plane ? up : way(i + 3, i + 1));
    const Rational part = of_corners[i] * normal.dot(way(i, i + 1));
    const Rational squared = part * part / normal.dot(normal);
    if (least_squared < 0 || squared < least_squared) least_squared = squared;
  }
  return least_squared / root_above(least_squared, work);
}

/// The point of a hull at time t that the weights make.
Result<MovedPoint> point_of(const MovingPatch<double>& hull, const Rational& t,
                            const std::vector<Rational>& weights, Work& work) {
  const auto refuse = [](std::string what) {
    return input_error(fmt::format("{}.weights", kWitness), std::move(what));
  };
  if (weights.size() != hull.positions.size()) {
    return refuse(fmt::format("{} of them for {}", weights.size(), to_text(hull.shape)));
  }
  Rational sum = 0;
  Vec3<Rational> point = {0, 0, 0};
  for (size_t i = 0; i < weights.size(); ++i) {
    constexpr std::uint64_t kOperations = 8;
    std::uint64_t words = words_of(weights[i]) + words_of(sum);
    for (int k = 0; k < 3; ++k) words += words_of(point[k]);
    charge_for(kOperations, words, work);
    if (weights[i] < 0) return refuse(fmt::format("{} is negative", abbreviated(weights[i])));
    sum += weights[i];
    for (int k = 0; k < 3; ++k) point[k] += weights[i] * exact(hull.positions[i][k]);
  }
  if (sum != 1) return refuse(fmt::format("their sum is {}, not 1", abbreviated(sum)));
  return moved_point(hull, point, t, work);
}

/// The corners of a face, as points of a hull.
Points<double> corners_of(const MovingPatch<double>& mesh, const Face& face) {
  Points<double> corners;
  for (const int corner : face) corners.push_back(mesh.positions[static_cast<size_t>(corner)]);
  return corners;
}

/// Whether a face of one body counts against the other: one-sided it does only if that moves
/// against its normal.
bool is_there(const MovingPatch<double>& mesh, const Face& face, const Vec3<double>& other_velocity,
              Work& work) {
  if (!mesh.one_sided) return true;
  constexpr std::uint64_t kOperations = 32;
  charge_for(kOperations, 0, work);
  const Points<double> corners = corners_of(mesh, face);
  const auto side = [&](size_t corner) {
    return Vec3<Rational>(exact(corners[corner]) - exact(corners[0]));
  };
  const Vec3<Rational> way = exact(other_velocity) - exact(mesh.velocities[0]);
  const Rational height = dot(cross(side(1), side(2)), way);
  return height < 0;
}

/// Whether the weights > 0 are all of one face that counts, or the body has no faces.
bool are_of_a_face(const MovingPatch<double>& body, const std::vector<Rational>& weights,
                   const Vec3<double>& other_velocity, Work& work) {
  return body.faces.empty() || std::ranges::any_of(body.faces, [&](const Face& face) {
           for (size_t i = 0; i < weights.size(); ++i) {
             if (weights[i] > 0 && !std::ranges::count(face, static_cast<int>(i))) return false;
           }
           return is_there(body, face, other_velocity, work);
         });
}

Result<void> check_contact_within(const Query& query, const Witness& witness, Work& work) {
  if (witness.t < 0) {
    return input_error(fmt::format("{}.t", kWitness), "{} is negative", abbreviated(witness.t));
  }
  if (has_turns(query) && witness.t > 1) {
    return input_error(fmt::format("{}.t", kWitness), "{} is past 1, where {}",
                       abbreviated(witness.t), end_of_motion(query));
  }
  CCDFUZZ_TRY(const auto first, point_of(query.patches[0], witness.t, witness.weights[0], work));
  CCDFUZZ_TRY(const auto second, point_of(query.patches[1], witness.t, witness.weights[1], work));
  for (const size_t s : {size_t{0}, size_t{1}}) {
    const Vec3<double>& velocity = query.patches[1 - s].velocities[0];
    if (are_of_a_face(query.patches[s], witness.weights[s], velocity, work)) continue;
    return input_error(fmt::format("{}.weights", kWitness), "are of no one face that is there");
  }
  Rational squared = 0;
  for (int k = 0; k < 3; ++k) {
    const Rational way = second.point[k] - first.point[k];
    charge_for(2, 2 * words_of(way), work);
    squared += way * way;
  }
  Rational reach = reach_of(query);
  if (has_turns(query)) {
    reach -= first.error + second.error;
    const bool in_plane = is_in_plane(query);
    for (size_t s = 0; s < 2; ++s) {
      reach += radius_within(query.patches[s], witness.weights[s], in_plane, work);
    }
  }
  if (reach < 0) {
    return input_error(fmt::format("{}.weights", kWitness),
                       "are not seen to touch: the error of a turn exceeds the reach and both "
                       "radii inside");
  }
  if (squared <= reach * reach) return {};
  return input_error(fmt::format("{}.weights", kWitness),
                     "the points are farther apart than {}: {} squared", abbreviated(reach),
                     abbreviated(squared));
}

/// Certificate K of the hulls of such points in place of the bodies'.
Result<void> check_direction(const Query& query, const Points<double>& first,
                             const Points<double>& second, const BodyClearance& clearance,
                             Work& work) {
  const auto refuse = [](std::string what) { return input_error(kBodyClear, std::move(what)); };
  const auto& [until, normal, closed] = clearance;
  if (has_turns(query)) return refuse("one direction proves nothing of bodies that turn");
  if (until < 0) return refuse(fmt::format("until: {} is negative", abbreviated(until)));
  const auto& [a, b] = query.patches;
  constexpr std::uint64_t kOperations = 8;
  charge_for(kOperations * (first.size() + second.size() + 4),
             words_of(normal[0]) + words_of(normal[1]) + words_of(normal[2]) + words_of(until),
             work);
  const auto height = [&](const Vec3<double>& p) { return dot(normal, exact(p)); };
  Rational highest = height(first[0]), lowest = height(second[0]);
  for (const Vec3<double>& p : first) highest = std::max(highest, height(p));
  for (const Vec3<double>& p : second) lowest = std::min(lowest, height(p));
  const auto rate = Rational(height(b.velocities[0]) - height(a.velocities[0]));
  const Rational reach = reach_of(query), kept = reach * reach * dot(normal, normal);
  for (const bool at_end : {false, true}) {
    const Rational gap = lowest - highest + (at_end ? Rational(until * rate) : Rational(0));
    const Rational squared = gap * gap;
    const bool holds = at_end && !closed ? gap >= 0 && squared >= kept : gap > 0 && squared > kept;
    if (holds) continue;
    return refuse(fmt::format("the normal does not keep the bodies apart at t = {}",
                              at_end ? abbreviated(until) : "0"));
  }
  return {};
}

/// Certificate F: certificate K of each face that counts, in their order.
Result<void> check_faces(const Query& query, const MeshClearance& clearance, Work& work) {
  const auto refuse = [](std::string what) { return input_error(kBodyClear, std::move(what)); };
  const size_t side = query.patches[0].faces.empty() ? 1 : 0;
  const MovingPatch<double>&mesh = query.patches[side], &other = query.patches[1 - side];
  if (mesh.faces.empty()) return refuse("directions of faces prove nothing where there is no mesh");
  if (clearance.until < 0) {
    return refuse(fmt::format("until: {} is negative", abbreviated(clearance.until)));
  }
  size_t next = 0;
  for (const Face& face : mesh.faces) {
    if (!is_there(mesh, face, other.velocities[0], work)) continue;
    if (next == clearance.normals.size()) return refuse("a face that is there has no normal");
    const Points<double> corners = corners_of(mesh, face);
    const BodyClearance apart{clearance.until, clearance.normals[next++], clearance.closed};
    const auto& [first, second] =
        side == 0 ? std::tie(corners, other.positions) : std::tie(other.positions, corners);
    CCDFUZZ_TRY_VOID(check_direction(query, first, second, apart, work));
  }
  if (next == clearance.normals.size()) return {};
  return refuse(fmt::format("number of normals: {}; of faces that are there: {}",
                            clearance.normals.size(), next));
}

}  // namespace

Result<void> check_body_contact(const Query& query, const Witness& witness,
                                std::uint64_t most_work) {
  return within_work(kWitness, most_work, check_contact_within, query, witness);
}

Result<void> check_body_clearance(const Query& query, const BodyClearance& clearance) {
  return within_work(kBodyClear, kMostWork, [&](Work& work) {
    const auto& [a, b] = query.patches;
    return check_direction(query, a.positions, b.positions, clearance, work);
  });
}

Result<void> check_mesh_clearance(const Query& query, const MeshClearance& clearance) {
  return within_work(kBodyClear, kMostWork, check_faces, query, clearance);
}

}  // namespace ccdfuzz
