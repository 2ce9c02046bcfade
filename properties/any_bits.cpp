#include <bit>
#include <cmath>
#include <limits>

#include "case/judge.hpp"
#include "ccd/search.hpp"
#include "certify/checker/check_case.hpp"
#include "generators/draw_patch.hpp"
#include "method/method.hpp"
#include "properties/answers.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

struct Question {
  Query query;
  SearchOptions options;
};

/// Any method of the registry, or the plain form of one.
std::string any_method(Draw& choices) {
  const std::vector<MethodInfo>& methods = registered_methods();
  const std::size_t place = choices.below(methods.size() + 1);
  return place < methods.size() ? spec_of(methods[place]) : "tdibm-e" + std::string(kUnoptimised);
}

double any_double(Draw& choices) {
  using Limits = std::numeric_limits<double>;
  constexpr std::array kSpecial = {Limits::quiet_NaN(),
                                   -Limits::quiet_NaN(),
                                   Limits::signaling_NaN(),
                                   Limits::infinity(),
                                   -Limits::infinity(),
                                   Limits::max(),
                                   -Limits::denorm_min(),
                                   -0.0,
                                   -1.0,
                                   2.0};
  if (choices.coin()) return std::bit_cast<double>(choices.choose(~std::uint64_t{0}));
  return choices.pick(kSpecial);
}

int any_int(Draw& choices) {
  const auto any = choices.coin() ? choices.integer(std::numeric_limits<int>::min(),
                                                    std::numeric_limits<int>::max())
                                  : choices.integer(-2, kMaxDegree + 2);
  return static_cast<int>(any);
}

/// Any numbers, or small ones, so that a method which looks at them answers soon.
Question draw_valid(Draw& choices) {
  constexpr std::array kMaxDegrees = {1, 2, 1, 2, 1, 2, 1, kMaxDegree};
  Question drawn;
  if (choices.choose(3) == 3) {
    drawn.query = draw_any_query(choices);
  } else {
    drawn.query = draw_query(choices, choices.pick(kMaxDegrees),
                             [](Draw& d) { return d.integer(-8, 8) / 4.0; });
    drawn.query.t_max = choices.integer(0, 8) / 4.0;
  }
  drawn.options.precision = std::ldexp(1.0, -static_cast<int>(choices.choose(60)));
  drawn.options.max_pops = choices.choose(60);
  drawn.options.max_bytes = choices.choose(1 << 20);
  return drawn;
}

/// One field to anything that its type holds.
void spoil(Draw& choices, Question& question) {
  Query& query = question.query;
  MovingPatch<double>& patch = query.patches[choices.choose(1)];
  Points<double>& points = choices.coin() ? patch.velocities : patch.positions;
  switch (const std::uint64_t place = choices.choose(7)) {
    case 0:
      if (!points.empty()) {
        points[choices.choose(points.size() - 1)][static_cast<int>(choices.choose(2))] =
            any_double(choices);
      }
      break;
    case 1:
      points.resize(choices.choose(kMaxControls + 4), Vec3<double>(1, 0, 0));
      break;
    case 2:
      patch.shape.kind = static_cast<ShapeKind>(choices.choose(255));
      break;
    case 3:
      (choices.coin() ? patch.shape.n : patch.shape.m) = any_int(choices);
      break;
    case 4: {  // as many control points as the degrees ask for
      patch.shape.n = choices.integer(-1, kMaxDegree + 2);
      patch.shape.m = choices.integer(-1, kMaxDegree + 2);
      const auto count = static_cast<std::size_t>(std::max(0, patch.shape.control_count()));
      patch.positions.resize(count, Vec3<double>(0, 1, 0));
      patch.velocities.resize(count, Vec3<double>(0, 0, 1));
      break;
    }
    default: {
      SearchOptions& options = question.options;
      *std::array{&query.t_max, &options.precision, &options.max_seconds}[place - 5] =
          any_double(choices);
    }
  }
}

void show_question(Draw& d, const Question& question) {
  show(d, "precision", question.options.precision);
  show(d, "max_seconds", question.options.max_seconds);
  show(d, "t_max", question.query.t_max);
  for (const MovingPatch<double>& patch : question.query.patches) {
    show(d, "kind", static_cast<int>(patch.shape.kind));
    show(d, "degrees", std::array{patch.shape.n, patch.shape.m});
    show(d, "positions", patch.positions);
    show(d, "velocities", patch.velocities);
  }
}

bool is_patch(const MovingPatch<double>& patch) {
  const auto& [kind, n, m] = patch.shape;
  const bool has_n = kind != ShapeKind::kPoint, has_m = kind == ShapeKind::kTensor;
  const auto degree_fits = [](int degree, bool has) {
    return has ? 1 <= degree && degree <= 8 : degree == 0;
  };
  if (static_cast<int>(kind) > 3 || !degree_fits(n, has_n) || !degree_fits(m, has_m)) return false;
  const int count = kind == ShapeKind::kTriangle ? (n + 1) * (n + 2) / 2 : (n + 1) * (m + 1);
  for (const Points<double>* points : {&patch.positions, &patch.velocities}) {
    if (points->size() != static_cast<std::size_t>(count)) return false;
    for (const Vec3<double>& p : *points) {
      for (int k = 0; k < 3; ++k) {
        if (!std::isfinite(p[k])) return false;
      }
    }
  }
  return true;
}

/// By the documentation of the fields alone (query.hpp, shape.hpp, search.hpp).
bool is_query(const Query& query) {
  return is_patch(query.patches[0]) && is_patch(query.patches[1]) && std::isfinite(query.t_max) &&
         query.t_max >= 0;
}

bool is_right(const Question& question) {
  const double precision = question.options.precision;
  return is_query(question.query) && precision > 0 && precision <= 1 &&
         !std::isnan(question.options.max_seconds);
}

/// The oracle has no budget for its proofs.
bool is_quick(const std::string& method, const Query& query) {
  constexpr int kFewControls = 6;
  return method != "oracle" ||
         query.patches[0].shape.control_count() + query.patches[1].shape.control_count() <=
             kFewControls;
}

Question draw_question(Draw& choices) {
  Question question = draw_valid(choices);
  for (std::uint64_t left = choices.choose(3); left > 0; --left) spoil(choices, question);
  return question;
}

void check_refusals(Draw& d) {
  const std::string name = show(d, "method", any_method(d));
  const Question question = draw_question(d);
  const bool to_answer = is_right(question);
  suppose(!to_answer || is_quick(name, question.query));
  const Answer answer = answer_of(name, question.query, question.options);
  const Outcome outcome = judge(checked_contact({question.query, {}, {}, {}}), answer);
  show(d, "verdict", answer.verdict);
  show(d, "note", answer.note);
  show(d, "outcome", outcome);
  show_question(d, question);
  if (to_answer) {
    CLAIM(answer.verdict != Verdict::kRefused);
    CLAIM(outcome != Outcome::kError);
    CLAIM(answer.verdict != Verdict::kMiss || !answer.toi);
    for (std::size_t s = 0; s < 2 && answer.verdict == Verdict::kHit && answer.has_uv; ++s) {
      CLAIM(question.query.patches[s].shape.contains(answer.uv[s]));
    }
  } else {
    CLAIM(answer.verdict == Verdict::kRefused);
    CLAIM(outcome == Outcome::kNotAsked);
    CLAIM(!answer.toi);
    CLAIM(!answer.note.empty());
  }
}

void check_validity(Draw& d) {
  const Question question = draw_question(d);
  const double precision = question.options.precision;
  const int depth = show(d, "depth", depth_for(precision));
  const bool is_width = 0 < precision && precision <= 1;
  show_question(d, question);
  CLAIM(is_valid(question.query) == is_query(question.query));
  CLAIM(is_taken(question.query, question.options) == is_right(question));
  CLAIM(depth == Cell::kMaxDepth || (is_width && std::ldexp(1.0, -depth) <= precision));
}

}  // namespace

std::vector<Property> any_bits_claims() {
  return {
      {"methods.refuses_invalid",
       "A method refuses a query and options that are not valid, naming field and value. It "
       "answers "
       "all others, with a toi in [0, t_max] and parameters in their domains",
       "src/method/method.hpp", check_refusals},
      {"query.is_valid",
       "What methods take, and validate accepts, is what the fields are documented to hold; what "
       "is no precision gives the deepest cells",
       "src/case/refusal.hpp", check_validity},
  };
}

}  // namespace ccdfuzz
