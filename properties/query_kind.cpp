#include "properties/query_kind.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bezier/bernstein.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "files/case_json.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/taken_query.hpp"
#include "numeric/products.hpp"
#include "properties/against_oracle.hpp"
#include "properties/answers.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

bool is_contact(const Query& query, const Witness& witness) {
  if (witness.t < 0 || witness.t > exact(query.t_max)) return false;
  std::array<Vec3<Rational>, 2> points;
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    if (!patch.shape.contains(witness.uv[s])) return false;
    if (!patch.trim.empty() && !is_in_region(patch.trim, witness.uv[s])) return false;
    points[s] = point_of(patch, witness.uv[s], witness.t);
  }
  const Vec3<Rational> way = points[0] - points[1];
  return dot(way, way) <= exact(query.separation) * exact(query.separation);
}

/// What fuzzers make of the bytes of a contact, if it has any.
void claim_bytes_mean(const Case& known) {
  const auto contact = contact_of(known);
  const auto bytes = contact ? to_bytes(*contact) : std::nullopt;
  if (!bytes) return;
  const bool is_whole = is_in_regions(known);
  CLAIM(is_in_trims(*contact) == is_whole);
  CLAIM(query_of(*bytes) == known.query);
  const auto read = contact_of_bytes(*bytes, QueryRange::kAll);
  CLAIM(read.has_value() == is_whole);
  CLAIM(!read || read->query == known.query);
  CLAIM(!contact_of_bytes(*bytes));
}

/// Who does not take the kind refuses it.
void claim_refused(const Query& query, bool Features::*feature) {
  Features others = kPatchFeatures;
  others.*feature = false;
  CLAIM(TakenQuery(query, others).query() == nullptr);
  for (const MethodInfo& info : registered_methods()) {
    if (info.features.*feature) continue;
    CLAIM(answer_of(spec_of(info), query, kQuickSearch).verdict == Verdict::kRefused);
  }
}

/// A case of its families in one draw of four, else its own draw.
Case draw_of(Draw& d, const QueryKind& kind) {
  if (d.choose(3) != 3) return kind.draw(d);
  GeneratorOptions options;
  options.family = d.pick(kind.families);
  options.contact = d.pick(kContactClasses);
  options.proof_pops = 1000;
  suppose(is_made(options.family, options.contact, options.kind));
  return generate(options, d).value;
}

void check_meaning(Draw& d, const QueryKind& kind) {
  const Case known = show(d, "contact", draw_of(d, kind));
  const auto read = parse_case(to_json(known, JsonLayout::kOneLine), "drawn");
  CLAIM(read && read->query == known.query);
  claim_bytes_mean(known);
  claim_refused(known.query, kind.feature);
  claim_judged_by_meaning(d, known);
}

}  // namespace

Vec3<Rational> point_of(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                        const Rational& t) {
  const std::vector<Rational> basis = bernstein_weights<Rational>(patch.shape, uv);
  const Rational rest = patch.has_ends() ? Rational(1 - t) : Rational(1);
  Rational sum = 0;
  Vec3<Rational> point(0, 0, 0);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const Rational w =
        patch.weights.empty() ? basis[i] : Rational(basis[i] * exact(patch.weights[i]));
    sum += w;
    const Vec3<Rational> start = exact(patch.positions[i]), move = exact(patch.moves()[i]);
    point += (start * rest + move * t) * w;
  }
  return point / sum;
}

void claim_judged_by_meaning(Draw& d, Case known) {
  Query& query = known.query;
  Witness& witness = *known.truth.witness;
  const std::size_t side = d.choose(1);
  const int steps = d.integer(-4, 4);
  const Rational off = steps * power_of_two(d.pick(std::array{-6, -20}));
  switch (query.separation > 0 && d.coin() ? 5 : d.choose(5)) {
    case 0:
      break;
    case 1:
      witness.t += off;
      break;
    case 2:
      witness.uv[side][d.choose(1)] += off;
      break;
    case 3:
      query.t_max = draw_double_near(d, witness.t);
      break;
    case 4: {
      const auto axis = static_cast<int>(d.choose(2));
      const double sign = d.coin() ? 1.0 : -1.0;
      const double by = std::ldexp(sign, d.integer(-16, 8));
      for (Vec3<double>& p : query.patches[side].positions) p[axis] += by;
      break;
    }
    default:
      query.separation = std::nextafter(query.separation, d.coin() ? HUGE_VAL : 0);
  }
  suppose(is_valid(query));
  show(d, "judged", known);
  CLAIM(check_truth(known).has_value() == is_contact(query, witness));
  CLAIM(check_witness(query, witness).has_value() == is_contact(query, witness));
}

void add_claims_of(std::vector<Property>& claims, const QueryKind& kind) {
  claims.push_back(
      {kind.subject + ".meaning",
       fmt::format("A contact {} means the same to generator, checker, files and fuzzers, and "
                   "methods that take none refuse it",
                   kind.of),
       "src/case/query.hpp", [=](Draw& d) { check_meaning(d, kind); }});
  claims.push_back(
      {kind.subject + ".decision_is_proven",
       fmt::format("The checker accepts what the oracle says of a contact {}", kind.of),
       "src/certify/oracle/oracle.hpp", [=](Draw& d) {
         Case drawn = draw_of(d, kind);
         const bool may_end_before = d.choose(3) == 3;
         if (may_end_before) drawn.query.t_max *= 0.5;
         show(d, "contact", drawn);
         constexpr std::uint64_t kFewPops = 300;
         const auto collides = decide_briefly(drawn.query, kFewPops).truth.collides;
         CLAIM(may_end_before || collides != false || !is_in_regions(drawn));
       }});
  const auto draw = [=](Draw& d) {
    Case known = draw_of(d, kind);
    suppose(is_in_regions(known));
    return known;
  };
  for (const std::string& method : miss_nothing()) {
    const MethodInfo info = method_info(method).value();
    if (!(info.features.*kind.feature)) continue;
    const auto source = kind.sources.find(method);
    add_contact_claims(claims, method, "_" + kind.kind, kind.of,
                       source == kind.sources.end() ? info.source : source->second, draw);
  }
}

}  // namespace ccdfuzz
