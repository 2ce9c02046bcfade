#include "fuzz/mutator/case_bytes.hpp"

#include <bit>
#include <cmath>

#include "case/mesh.hpp"
#include "fuzz/mutator/repair.hpp"

namespace ccdfuzz {

namespace {

/// Writes numbers.
class ByteWriter {
 public:
  void byte(int x) {
    fits_ = fits_ && 0 <= x && x < 256;
    bytes_.push_back(static_cast<std::uint8_t>(x));
  }
  void real(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int i = 0; i < 64; i += 8) bytes_.push_back(static_cast<std::uint8_t>(bits >> i));
  }
  /// nullopt if something was no byte.
  std::optional<std::vector<std::uint8_t>> take() {
    return fits_ ? std::optional(std::move(bytes_)) : std::nullopt;
  }

 private:
  std::vector<std::uint8_t> bytes_;
  bool fits_ = true;
};

/// Reads numbers: zeros after the end, of which ended() tells.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  void byte(int& x) {
    ended_ = ended_ || left_.empty();
    x = left_.empty() ? 0 : left_.front();
    left_ = left_.subspan(left_.empty() ? 0 : 1);
  }
  void real(double& x) {
    std::uint64_t bits = 0;
    for (int i = 0, next = 0; i < 64; i += 8) {
      byte(next);
      bits |= static_cast<std::uint64_t>(next) << i;
    }
    x = std::bit_cast<double>(bits);
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

int kind_of(const Query& query, size_t side) {
  const MovingPatch<double>& patch = query.patches[side];
  return static_cast<int>(patch.shape.kind) | (patch.has_ends() ? kHasEnds : 0) |
         (side == 0 && query.separation > 0 ? kHasSeparation : 0) |
         (patch.weights.empty() ? 0 : kHasWeights) | (patch.trim.empty() ? 0 : kHasTrim);
}

/// The contents of the bytes: a query, and numbers that may be those of a contact.
struct CaseParts {
  int method = 0;
  Query query;
  double t = 0;
  std::array<Uv<double>, 2> uv;
};

template <class Bytes, class Items>
void pass_size(Bytes& bytes, Items& items) {
  auto size = static_cast<int>(items.size());
  bytes.byte(size);
  items.resize(static_cast<size_t>(size));
}

/// Writes the contents, or reads them. False if a shape is none.
template <class Bytes>
bool pass(Bytes& bytes, CaseParts& parts) {
  auto& [method, query, t, uv] = parts;
  bytes.byte(method);
  std::array<int, 2> kinds = {kind_of(query, 0), kind_of(query, 1)};
  for (size_t s = 0; s < 2; ++s) {
    Shape& shape = query.patches[s].shape;
    bytes.byte(kinds[s]);
    bytes.byte(shape.n);
    bytes.byte(shape.m);
    shape.kind = static_cast<ShapeKind>(kinds[s] % kKinds);
    if (!shape.valid()) return false;
  }
  bytes.real(query.t_max);
  if ((kinds[0] & kHasSeparation) != 0) bytes.real(query.separation);
  bytes.real(t);
  for (Uv<double>& at : uv) {
    for (double& x : at) bytes.real(x);
  }
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[s];
    const auto count = static_cast<size_t>(patch.shape.control_count());
    patch.positions.resize(count);
    ((kinds[s] & kHasEnds) != 0 ? patch.ends : patch.velocities).resize(count);
    patch.weights.resize((kinds[s] & kHasWeights) != 0 ? count : 0);
    for_each_coordinate(patch, [&](double& x) { bytes.real(x); });
    for (double& w : patch.weights) bytes.real(w);
    if ((kinds[s] & kHasTrim) == 0) continue;
    pass_size(bytes, patch.trim);
    for (auto& loop : patch.trim) {
      pass_size(bytes, loop);
      for (Uv<double>& vertex : loop) {
        for (double& x : vertex) bytes.real(x);
      }
    }
  }
  return true;
}

/// Their parts, where these are a valid query.
std::optional<CaseParts> case_parts_of(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  CaseParts parts;
  if (!pass(in, parts) || in.ended() || !is_valid(parts.query)) return std::nullopt;
  return parts;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> to_bytes(const Contact& q, std::uint8_t method) {
  if (has_turns(q.query) || has_mesh(q.query)) return std::nullopt;
  const auto t = q.t.to_double_exactly();
  if (!t) return std::nullopt;
  CaseParts parts{method, q.query, *t, {}};
  for (size_t s = 0; s < 2; ++s) {
    const auto u = q.uv[s][0].to_double_exactly(), v = q.uv[s][1].to_double_exactly();
    if (!u || !v) return std::nullopt;
    parts.uv[s] = {*u, *v};
  }
  ByteWriter out;
  if (!pass(out, parts)) return std::nullopt;
  return out.take();
}

std::uint8_t method_number(std::span<const std::uint8_t> bytes) {
  return bytes.empty() ? 0 : bytes.front();
}

std::optional<Contact> contact_of_bytes(std::span<const std::uint8_t> bytes, QueryRange range) {
  std::optional<CaseParts> parts = case_parts_of(bytes);
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
  std::optional<CaseParts> parts = case_parts_of(bytes);
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
