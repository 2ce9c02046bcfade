#include "properties/no_false_negative.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/judge.hpp"
#include "case/scale.hpp"
#include "ccd/search.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/oracle.hpp"
#include "fuzz/mutator/moves.hpp"
#include "method/method.hpp"
#include "properties/linear_queries.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

void claim_no_false_negative(const std::string& method, const Case& value,
                             const SearchOptions& options, Draw& draw) {
  suppose(value.truth.witness && value.truth.collides == true);
  const Answer answer = make_method(method).value()->answer(value.query, options);
  const CheckedCase known = checked_contact(value);
  const Outcome outcome = show(draw, "outcome", judge(known, answer));
  show(draw, "method", method);
  show(draw, "precision", options.precision);
  show(draw, "toi", answer.toi);
  show(draw, "contact", value);
  CLAIM(known.collides() == true);
  CLAIM(!is_false_negative(outcome) && outcome != Outcome::kError);
}

DrawCase contacts_in(const ContactRange& range) {
  return [=](Draw& d) { return supposed(draw_contact(d, range)); };
}

Case draw_transformed(Draw& draw) {
  const Case drawn = supposed(draw_contact(draw, kOrdinaryRange));
  if (draw.coin()) return drawn;
  constexpr std::array kMoves = {change_coordinates,  reparametrise,
                                 elevate_degree,      restrict_to_child,
                                 shift_in_null_space, trade_position_for_velocity};
  Contact q = supposed(contact_of(drawn));
  for (int left = draw.integer(1, 4); left > 0; --left) {
    Contact next = q;
    if (!draw.pick(kMoves)(next, draw)) continue;
    if (is_within_scale(next.query, kOrdinaryBits)) q = std::move(next);
  }
  return case_of(q);
}

/// That, or a contact of the tiny or the many-bit range. The time step may be 2^30 times as long as
/// the contact needs.
static Case draw_sized_contact(Draw& draw) {
  const std::uint64_t kind = draw.choose(3);
  if (kind == 3) return supposed(draw_contact(draw, kManyBits));  // about the ends of windows
  Case drawn = kind == 2 ? supposed(draw_contact(draw, kTiny)) : draw_transformed(draw);
  if (draw.coin()) {
    drawn.query.t_max = std::ldexp(drawn.query.t_max, draw.integer(0, 30));
  }
  return drawn;
}

std::function<void(Draw&)> misses_nothing(std::string method, DrawCase draw,
                                          SearchOptions options) {
  return [=](Draw& d) { claim_no_false_negative(method, draw(d), options, d); };
}

std::function<void(Draw&)> keeps_contacts(std::string method, DrawCase draw) {
  return [=](Draw& d) { claim_kept(method, draw(d), d); };
}

void claim_kept(const std::string& method, const Case& value, Draw& draw, double precision) {
  const auto made = make_method(method).value();
  const Trace& trace = made->trace(value.query, *value.truth.witness, {.precision = precision});
  show(draw, "method", method);
  if (trace.lost) {
    show(draw, "level", trace.loss->place.level);
    show(draw, "axis", trace.loss->by.axis);
  }
  show(draw, "contact", value);
  CLAIM(!trace.lost);
  // tdibm-c has no cells of linear patches, unless they are trimmed.
  const bool has_cells = method != "tdibm-c" || !is_decided_linearly(value.query);
  show(draw, "levels", trace.levels);
  CLAIM(!has_cells || trace.levels == depth_for(precision));
}

std::vector<Property> contact_claims(const std::string& method, const std::string& source,
                                     const SearchOptions& of_linear) {
  return {
      {method + ".no_false_negative",
       "No proven contact is missed, and none reported late, also for coordinates about 2^-535, "
       "of many bits, about the ends of windows, early in a long time step, and after changes of "
       "coordinates that keep it",
       source, misses_nothing(method, draw_sized_contact)},
      {method + ".no_false_negative_linear",
       "No contact of a degenerate linear query is missed, and none reported late", source,
       misses_nothing_linear(method, of_linear)},
      {method + ".trace", "No pair of boxes that holds a contact is dropped on the way", source,
       keeps_contacts(method, contacts_in(kElsewhere))},
  };
}

void add_contact_claims(std::vector<Property>& claims, const std::string& method,
                        const std::string& kind, const std::string& of, const std::string& source,
                        const DrawCase& draw, Expectation expected) {
  claims.push_back({method + ".no_false_negative" + kind,
                    fmt::format("No contact {} is missed or late", of), source,
                    misses_nothing(method, draw), expected});
  claims.push_back({method + ".trace" + kind,
                    fmt::format("No pair of boxes that holds a contact {} is dropped", of), source,
                    keeps_contacts(method, draw), expected});
}

}  // namespace ccdfuzz
