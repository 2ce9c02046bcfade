#include "fuzz/mutator/case_bytes.hpp"

#include <bit>
#include <cmath>

#include "case/mesh.hpp"
#include "fuzz/mutator/repair.hpp"

namespace ccdfuzz {

namespace {

class ByteWriter {
 public:
  void byte(int x) { bytes_.push_back(static_cast<std::uint8_t>(x)); }
  void real(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int i = 0; i < 64; i += 8) bytes_.push_back(static_cast<std::uint8_t>(bits >> i));
  }
  /// False if x is no double.
  bool exact(const Dyadic& x) {
    const std::optional<double> value = x.to_double_exactly();
    real(value.value_or(0));
    return value.has_value();
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Gives zeros after the end; ended() tells.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  int byte() {
    if (left_.empty()) {
      ended_ = true;
      return 0;
    }
    const int x = left_.front();
    left_ = left_.subspan(1);
    return x;
  }
  double real() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; i += 8) bits |= static_cast<std::uint64_t>(byte()) << i;
    return std::bit_cast<double>(bits);
  }
  bool ended() const { return ended_; }

 private:
  std::span<const std::uint8_t> left_;
  bool ended_ = false;
};

/// Behind the kinds of shapes, flags: the patch has ends; of the first, the query has a separation;
/// the patch has weights; the patch has a trim.
constexpr int kKinds = 4, kHasEnds = kKinds, kHasSeparation = 2 * kKinds, kHasWeights = 4 * kKinds,
              kHasTrim = 8 * kKinds;

/// The contents of the bytes: a valid query, and numbers that may be those of a contact.
struct CaseParts {
  Query query;
  double t = 0;
  std::array<Uv<double>, 2> uv;
};

std::optional<CaseParts> parts_of(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  in.byte();  // the method
  CaseParts parts;
  std::array<bool, 2> has_ends{}, has_trim{};
  bool has_separation = false;
  for (MovingPatch<double>& patch : parts.query.patches) {
    const int kind = in.byte();
    patch.shape.kind = static_cast<ShapeKind>(kind % kKinds);
    const bool is_first = &patch == &parts.query.patches[0];
    has_ends[is_first ? 0 : 1] = (kind & kHasEnds) != 0;
    has_trim[is_first ? 0 : 1] = (kind & kHasTrim) != 0;
    has_separation = is_first ? (kind & kHasSeparation) != 0 : has_separation;
    patch.shape.n = in.byte();
    patch.shape.m = in.byte();
    if (!patch.shape.valid()) return std::nullopt;
    if ((kind & kHasWeights) != 0) {
      patch.weights.resize(static_cast<size_t>(patch.shape.control_count()));
    }
  }
  parts.query.t_max = in.real();
  if (has_separation) parts.query.separation = in.real();
  parts.t = in.real();
  for (Uv<double>& uv : parts.uv) {
    for (double& x : uv) x = in.real();
  }
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = parts.query.patches[s];
    const auto count = static_cast<size_t>(patch.shape.control_count());
    patch.positions.resize(count);
    (has_ends[s] ? patch.ends : patch.velocities).resize(count);
    for_each_coordinate(patch, [&](double& x) { x = in.real(); });
    for (double& w : patch.weights) w = in.real();
    if (has_trim[s]) patch.trim.resize(static_cast<size_t>(in.byte()));
    for (auto& loop : patch.trim) {
      loop.resize(static_cast<size_t>(in.byte()));
      for (Uv<double>& vertex : loop) {
        for (double& x : vertex) x = in.real();
      }
    }
  }
  if (in.ended() || !validate(parts.query, "query")) return std::nullopt;
  return parts;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> to_bytes(const Contact& q, std::uint8_t method) {
  if (has_turns(q.query) || has_mesh(q.query)) return std::nullopt;
  ByteWriter out;
  out.byte(method);
  for (const MovingPatch<double>& patch : q.query.patches) {
    const bool separates = &patch == &q.query.patches[0] && q.query.separation > 0;
    out.byte(static_cast<int>(patch.shape.kind) | (patch.has_ends() ? kHasEnds : 0) |
             (separates ? kHasSeparation : 0) | (patch.weights.empty() ? 0 : kHasWeights) |
             (patch.trim.empty() ? 0 : kHasTrim));
    out.byte(patch.shape.n);
    out.byte(patch.shape.m);
  }
  out.real(q.query.t_max);
  if (q.query.separation > 0) out.real(q.query.separation);
  bool exact = out.exact(q.t);
  for (const Uv<Dyadic>& uv : q.uv) {
    for (const Dyadic& x : uv) exact = out.exact(x) && exact;
  }
  if (!exact) return std::nullopt;
  for (const MovingPatch<double>& patch : q.query.patches) {
    for_each_coordinate(patch, [&](double x) { out.real(x); });
    for (const double w : patch.weights) out.real(w);
    if (patch.trim.empty()) continue;
    constexpr size_t kMost = 255;
    exact = exact && patch.trim.size() <= kMost;
    out.byte(static_cast<int>(patch.trim.size()));
    for (const auto& loop : patch.trim) {
      exact = exact && loop.size() <= kMost;
      out.byte(static_cast<int>(loop.size()));
      for (const auto& [u, v] : loop) out.real(u), out.real(v);
    }
  }
  if (!exact) return std::nullopt;
  return out.take();
}

std::uint8_t method_number(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? 0 : bytes.front();
}

std::optional<Contact> contact_of_bytes(std::span<const std::uint8_t> bytes, QueryRange range) {
  std::optional<CaseParts> parts = parts_of(bytes);
  const bool is_plain = parts && !has_ends(parts->query) && parts->query.separation == 0 &&
                        !is_trimmed(parts->query) && parts->query.patches[0].weights.empty() &&
                        parts->query.patches[1].weights.empty();
  if (range == QueryRange::kPlain && !is_plain) return std::nullopt;
  if (!parts || !(parts->t >= 0 && parts->t <= parts->query.t_max)) return std::nullopt;
  Contact q;
  q.query = std::move(parts->query);
  q.t = Dyadic::exact(parts->t);
  for (size_t s = 0; s < 2; ++s) {
    for (size_t k = 0; k < 2; ++k) {
      if (!std::isfinite(parts->uv[s][k])) return std::nullopt;
      q.uv[s][k] = Dyadic::exact(parts->uv[s][k]);
    }
    if (!q.query.patches[s].shape.contains(q.uv[s])) return std::nullopt;
  }
  Draw draw{Random(bytes.size())};  // any way that is exact will do, and always the same
  if (!repair(q, draw)) return std::nullopt;
  return q;
}

std::optional<Query> query_of(std::span<const std::uint8_t> bytes) {
  std::optional<CaseParts> parts = parts_of(bytes);
  if (!parts) return std::nullopt;
  return std::move(parts->query);
}

std::vector<Case> cases_of(std::span<const std::uint8_t> bytes) {
  std::vector<Case> cases;
  const auto query = query_of(bytes);
  if (!query) return cases;
  const auto whole = contact_of_bytes(bytes, QueryRange::kAll);
  if (!whole || whole->query != *query) {
    cases.emplace_back();
    cases.back().query = *query;
  }
  if (whole) cases.push_back(case_of(*whole));
  return cases;
}

}  // namespace ccdfuzz
