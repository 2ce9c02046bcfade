#include <fmt/format.h>

#include <bit>
#include <cfenv>
#include <limits>

#include "base/double_parts.hpp"
#include "base/fp_guard.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "certify/checker/check_box.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_linear.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_witness.hpp"
#include "certify/oracle/build_tree.hpp"
#include "certify/oracle/oracle.hpp"
#include "files/case_json.hpp"
#include "generators/draw_contact.hpp"
#include "generators/similar.hpp"
#include "io/json_real.hpp"
#include "io/json_write.hpp"
#include "method/method.hpp"
#include "numeric/next_double.hpp"
#include "numeric/products.hpp"
#include "properties/answers.hpp"
#include "properties/draw_linear.hpp"
#include "properties/no_false_negative.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr double kLeastDouble = std::numeric_limits<double>::denorm_min();

/// A floating-point environment that a host program may leave to our thread.
struct FpEnvironment {
  const char* name;
  FpGuard::Word control;
  int rounding;  ///< as in <cfenv>, for what else there is (x87, which glibc's strtod obeys)
};

#if defined(__SSE2_MATH__)
// MXCSR. Bits 7 to 12 mask exceptions: invalid (7), division by zero (9), overflow (10).
constexpr FpGuard::Word kDefault = 0x1f80, kFlushResults = 0x8000, kFlushOperands = 0x40,
                        kDown = 0x2000, kUp = 0x4000, kTowardZero = 0x6000, kNoTraps = 0x680,
                        kTrapping = kDefault & ~kNoTraps;
#elif defined(__aarch64__)
// FPCR. FZ (24) flushes both; most machines cannot trap.
constexpr FpGuard::Word kDefault = 0, kFlushResults = 1U << 24, kFlushOperands = 1U << 24,
                        kUp = 1U << 22, kDown = 2U << 22, kTowardZero = 3U << 22, kTrapping = 0;
#endif

/// Flushing of results, of operands and of both, each rounding mode, traps of invalid operations,
/// divisions by zero and overflows, and all that at once.
constexpr std::array<FpEnvironment, 9> kEnvironments = {{
    {"to nearest", kDefault, FE_TONEAREST},
    {"results flushed", kDefault | kFlushResults, FE_TONEAREST},
    {"operands flushed", kDefault | kFlushOperands, FE_TONEAREST},
    {"both flushed", kDefault | kFlushResults | kFlushOperands, FE_TONEAREST},
    {"upward", kDefault | kUp, FE_UPWARD},
    {"downward", kDefault | kDown, FE_DOWNWARD},
    {"toward zero", kDefault | kTowardZero, FE_TOWARDZERO},
    {"trapping", kTrapping, FE_TONEAREST},
    {"trapping, both flushed, upward", kTrapping | kFlushResults | kFlushOperands | kUp, FE_UPWARD},
}};

/// Puts the calling thread into an environment for as long as it lives.
class InFpEnvironment {
 public:
  explicit InFpEnvironment(const FpEnvironment& environment) {
    std::fegetenv(&callers_);
    std::fesetround(environment.rounding);
    FpGuard::write(environment.control);
  }
  ~InFpEnvironment() { std::fesetenv(&callers_); }
  InFpEnvironment(const InFpEnvironment&) = delete;
  InFpEnvironment& operator=(const InFpEnvironment&) = delete;

 private:
  std::fenv_t callers_;
};

/// The control word of the calling thread, without the flags of exceptions past.
FpGuard::Word fp_control() {
  return FpGuard::read() & FpGuard::kControl;
}

std::string bits(double x) {
  return fmt::format("{:x} ", std::bit_cast<std::uint64_t>(x));
}
/// What an optional or a Result holds, if anything.
template <class Drawn>
requires requires(const Drawn& x) {
  x.has_value();
}
std::string bits(const Drawn& x) {
  return x.has_value() ? bits(*x) : "none ";
}

void check_guard(Draw& d) {
  for (const FpEnvironment& environment : kEnvironments) {
    show(d, "environment", environment.name);
    const InFpEnvironment in(environment);
    {
      const FpGuard guard;
      volatile double least_normal = std::numeric_limits<double>::min(), one = 1;
      CLAIM(FpGuard::holds());
      CLAIM(least_normal / 2 != 0);
      CLAIM(one + 0x1.8p-53 == 1 + 0x1p-52);
      CLAIM(one + 0x1p-54 == 1);
    }
    show(d, "left", fp_control());
    CLAIM(fp_control() == environment.control);
  }
}

/// text() is as the thread is, and in every environment, which it leaves as it was. It must not
/// format doubles, but their bits.
template <class Text>
void claim_same_in_environments(Draw& d, const Text& text) {
  const std::string expected = show(d, "expected", text());
  for (const FpEnvironment& environment : kEnvironments) {
    show(d, "environment", environment.name);
    std::string got;
    FpGuard::Word left = 0;
    {
      const InFpEnvironment in(environment);
      got = text();
      left = fp_control();
    }
    show(d, "got", got);
    CLAIM(got == expected);
    CLAIM(left == environment.control);
  }
}

/// Any double, every other time a subnormal one.
double draw_tiny_or_any(Draw& choices) {
  const double x = choices.finite_double();
  constexpr std::uint64_t kNoExponent = 0x800f'ffff'ffff'ffff;
  return choices.coin() ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & kNoExponent) : x;
}

void check_exact_numbers(Draw& d) {
  const double x = draw_tiny_or_any(d), y = draw_tiny_or_any(d);
  const Rational off = Rational(1, 3) * power_of_two(d.integer(-1100, 10));
  const Rational q = d.coin() ? Rational(exact(x) + off) : exact(x);
  const std::int64_t exponent = d.integer(-340, 22);
  const std::string decimal = fmt::format("{}e{}", d.integer(-999'999'999, 999'999'999), exponent);
  claim_same_in_environments(d, [&] {
    const DoubleParts parts = parts_of(x);
    const Dyadic dyadic = Dyadic::exact(x);
    const std::string shortest = json_number(x), hex = to_hex(x);
    std::string out = fmt::format("{} {} {} {} ", parts.mantissa, parts.exponent, to_text(exact(x)),
                                  to_text(dyadic.rational()));
    out += bits(double_of(parts.mantissa, parts.exponent)) + bits(dyadic.to_double_exactly());
    out += bits(round_down(q)) + bits(round_up(q)) + bits(to_double_exactly(q));
    out += bits(next_up(x)) + bits(next_down(x));
    out += compare(x, y) < 0 ? "less " : compare(x, y) > 0 ? "greater " : "equal ";
    out += shortest + " " + hex + " ";
    out += bits(parse_real({JsonKind::kNumber, shortest, {}, {}}));
    out += bits(parse_real({JsonKind::kNumber, decimal, {}, {}}));
    out += bits(parse_real({JsonKind::kString, hex, {}, {}}));
    return out;
  });
}

/// A contact, most often among subnormal numbers, or a linear query; then, perhaps, one patch moved
/// by as little as a number can be.
Case draw_tiny_case(Draw& choices) {
  constexpr ContactRange kSubnormal{-1066, -1010, 2};
  Case drawn;
  if (const std::uint64_t kind = choices.choose(3); kind < 3) {
    drawn = supposed(draw_contact(choices, kind < 2 ? kSubnormal : ContactRange()));
  } else {
    drawn.query = supposed(draw_linear(choices));
    const int exponent = choices.integer(-1060, 0);
    drawn.query = similar(drawn.query, {.space = exponent}).value_or(drawn.query);
    drawn.truth.witness = Witness{exact(drawn.query.t_max) / 2, {}};
  }
  if (choices.coin()) {
    const auto axis = static_cast<int>(choices.choose(2));
    const Dyadic step(Integer(1), choices.integer(-1074, -1040));
    for (Vec3<double>& p : drawn.query.patches[choices.choose(1)].positions) {
      p[axis] = (Dyadic::exact(p[axis]) + step).to_double_exactly().value_or(p[axis]);
    }
  }
  drawn.truth.collides = true;
  return drawn;
}

/// Certificates of either kind about a case, hardly ever right ones.
struct WildClaims {
  MovingPlane plane;
  ContactBox box;
  ContactRoot root;
  LinearClearance linear;
  MissTree tree;
};

WildClaims draw_wild_claims(Draw& choices, const Case& about) {
  const Rational& t = about.truth.witness->t;
  WildClaims out;
  out.plane.until = t;
  for (Rational& x : out.plane.normal) x = choices.integer(-1, 1);
  const Vec3<double>& p = about.query.patches[choices.choose(1)].positions.front();
  out.plane.offset = dot(out.plane.normal, exact(p));
  out.box.centre = {0.25, 0.25, 0.25, 0.25, round_down(t)};
  out.box.varied = {0, 1, ContactBox::kTime};
  out.box.radius = {0x1p-4, 0x1p-4, choices.coin() ? 0x1p-4 : kLeastDouble};
  for (std::size_t i = 0; i < 3; ++i) out.box.inverse[i][i] = draw_tiny_or_any(choices);
  out.root = {{Integer(-t.get_num()), t.get_den()}, t / 2, Rational(t + power_of_two(-4))};
  out.linear = {choices.choose(15) == 15 ? t : Rational(t / 2), choices.coin()};
  out.tree = build_miss_tree(about.query, t / 2, 40).value_or(MissTree{});
  return out;
}

/// A proof up to a contact takes a second where numbers have a thousand bits. A limit is a
/// statement, too.
constexpr std::uint64_t kLittleWork = kMostWork / 64;

/// All that the checker and the judge say.
std::string judgement(const Case& value, const WildClaims& claims) {
  const Query& query = value.query;
  std::string out;
  const auto add = [&out](const char* what, bool holds) {
    out += fmt::format("{}{} ", holds ? "" : "no ", what);
  };
  add("truth", check_truth(value).has_value());
  add("contact", check_contact(query, *value.truth.witness).has_value());
  add("witness", check_witness(query, *value.truth.witness).has_value());
  add("plane", check_plane(query, claims.plane).has_value());
  add("box", check_box(query, claims.box).has_value());
  add("root", check_contact_root(query, claims.root).has_value());
  add("linear", check_linear_clearance(query, claims.linear, kLittleWork).has_value());
  add("tree", check_clearance(query, claims.tree).has_value());
  const CheckedCase known = checked_contact(value);
  for (const double toi : {0.0, -kLeastDouble, kLeastDouble, query.t_max, next_up(query.t_max)}) {
    Answer hit = Answer::hit(toi);
    hit.uv[0] = {-kLeastDouble, 0};
    AnswerTerms terms;
    out += fmt::format("{} ", name_of(judge(known, hit, terms)));
    terms.space_tolerance = terms.early_tolerance = kLeastDouble;
    out += fmt::format("{} ", name_of(judge(known, hit, terms)));
  }
  for (const double t_max : {0.0, kLeastDouble, query.t_max}) {
    const CheckedCase up_to = known.with_t_max(t_max);
    add("collides", up_to.value().truth.collides.value_or(false));
    const Answer too_late = Answer::hit(next_up(t_max));
    out += fmt::format("{} ", name_of(judge(up_to, too_late)));
  }
  Query before_zero = query;
  before_zero.t_max = -kLeastDouble;
  add("valid", is_valid(before_zero));
  const std::string json = to_json(value);
  const auto read = parse_case(json, "");
  add("read back", read && to_json(*read) == json);
  return out + json;
}

std::string bits(const Answer& answer) {
  std::string out = fmt::format("{} {}", static_cast<int>(answer.verdict), bits(answer.toi));
  for (const Uv<double>& uv : answer.uv) out += bits(uv[0]) + bits(uv[1]);
  return out + fmt::format("{} {} {}", answer.pops, answer.bytes, answer.note);
}

std::string bits(const Trace& trace) {
  std::string out = fmt::format("{} {} {} {} {}", trace.lost, trace.pairs, trace.lost_pairs,
                                trace.false_claims, trace.levels);
  if (trace.margin)
    out += fmt::format(" {} {}", trace.margin->ulps, bits(trace.margin->by.times.lo));
  if (trace.slack) out += " " + bits(trace.slack->value);
  return out;
}

/// A method's answer to a case, without the time that it took.
std::string said_by(const std::string& spec, const Case& value) {
  const SearchOptions options{.precision = 0x1p-7, .max_pops = 24};
  const Witness& witness = *value.truth.witness;
  std::string out;
  if (spec == "oracle") {
    const Decision decision = decide(value.query, {.max_pops = 24, .max_tree_nodes = 200});
    Case decided = value;
    decided.truth = decision.truth;
    return to_json(decided);
  }
  out = bits(answer_of(spec, value.query, options));
  if (check_witness(value.query, witness)) {
    out += ", " + bits((*make_method(spec))->trace(value.query, witness, {.precision = 0x1p-5}));
  }
  if (spec == "tdibm-rational") {
    out += proves_clear(value.query, witness.t, {.pops = 24}) ? ", clear" : ", not clear";
  }
  return out;
}

void check_methods(Draw& d) {
  const std::vector<MethodInfo>& methods = registered_methods();
  const std::string spec = show(d, "method", spec_of(methods[d.choose(methods.size() - 1)]));
  const Case drawn = show(d, "case", draw_tiny_case(d));
  claim_same_in_environments(d, [&] { return said_by(spec, drawn); });
}

void check_contact_stays(Draw& d) {
  const char* const spec = d.coin() ? "tdibm-c" : "tdibm-rational";
  const FpEnvironment& environment = kEnvironments[d.choose(kEnvironments.size() - 1)];
  constexpr ContactRange kSubnormal{-1066, -1010, 2}, kAnywhere{-1000, 900, 3};
  const Case drawn = supposed(draw_contact(d, d.coin() ? kAnywhere : kSubnormal));
  show(d, "environment", environment.name);
  const InFpEnvironment in(environment);
  claim_no_false_negative(spec, drawn, {.precision = 0x1p-4, .max_pops = 60}, d);
  claim_kept(spec, drawn, d, 0x1p-5);
}

}  // namespace

std::vector<Property> any_environment_claims() {
  constexpr auto kSource = "src/base/fp_guard.hpp";
  return {
      {"fp_guard.sound_and_restored",
       "Within a guard the environment is sound, and on leaving it is the caller's again", kSource,
       check_guard},
      {"double.exact_in_any_environment",
       "Conversions between doubles, exact numbers and texts do not depend on the floating-point "
       "environment",
       "src/base/double_parts.hpp", check_exact_numbers},
      {"checker.same_in_any_environment",
       "The checker and the judge say the same in every floating-point environment", kSource,
       [](Draw& d) {
         const Case drawn = draw_tiny_case(d);
         const WildClaims claims = draw_wild_claims(d, drawn);
         claim_same_in_environments(d, [&] { return judgement(drawn, claims); });
       }},
      {"methods.same_in_any_environment",
       "Answers, traces and certificates are the same bits in every floating-point environment",
       kSource, check_methods},
      {"methods.no_false_negative_in_any_environment",
       "tdibm-c and tdibm-rational lose no contact, in a trace or a query, and none is late, in "
       "any floating-point environment",
       kSource, check_contact_stays},
  };
}

}  // namespace ccdfuzz
