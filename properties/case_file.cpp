#include "properties/case_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "files/case_json.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "properties/draw_word.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kLayouts = {JsonLayout::kOneLine, JsonLayout::kReadable};

Rational draw_rational(Draw& d) {
  const int p = d.integer(-1'000'000, 1'000'000);
  return Rational(p) / Rational(d.integer(1, 1'000'000));
}

Vec3<Rational> three_of(DrawRational* draw, Draw& d) {
  const Rational x = draw(d), y = draw(d);
  return {x, y, draw(d)};
}

Query draw_any_bodies(Draw& d) {
  Query drawn;
  for (MovingPatch<double>& body : drawn.patches) {
    body.shape = Shape::hull(d.integer(1, 5));
    body.positions.resize(static_cast<std::size_t>(body.shape.control_count()));
    body.velocities.resize(1);
    for_each_coordinate(body, [&](double& x) { x = d.finite_double(); });
    body.radius = std::abs(d.finite_double());
  }
  return drawn;
}

Clearance draw_any_clearance(Draw& d, DrawRational* draw_number) {
  const Rational until = draw_number(d);
  const bool closed = d.coin();
  switch (d.choose(3)) {
    case 0:
      return LinearClearance{until, closed};
    case 1:
      return BodyClearance{until, three_of(draw_number, d), closed};
    case 2:
      return MovingPlane{until, three_of(draw_number, d), draw_number(d)};
    default:
      return MissTree{until, {d.text(20)}};
  }
}

ContactBox draw_any_box(Draw& d) {
  constexpr std::array<std::array<int, 3>, 3> kVaried = {{{0, 1, 2}, {0, 3, 4}, {2, 3, 4}}};
  ContactBox box;
  for (double& x : box.centre) x = d.finite_double();
  for (int& k : box.dependent) k = static_cast<int>(d.choose(2));
  box.varied = d.pick(kVaried);
  for (double& x : box.radius) x = std::max(std::abs(d.finite_double()), 0x1p-1074);
  for (auto& row : box.inverse) {
    for (double& x : row) x = d.finite_double();
  }
  return box;
}

/// Any finite numbers at all, in any two shapes, and anything said of them.
Case draw_any_case(Draw& d) {
  Case drawn;
  drawn.query = d.choose(3) == 3 ? draw_any_bodies(d) : draw_any_query(d);
  if (d.coin()) drawn.truth = draw_any_truth(d, drawn.query, draw_rational);
  Origin& origin = drawn.origin;
  for (std::string* text : {&origin.contact, &origin.kind, &origin.generator, &origin.ccdfuzz,
                            &origin.name, &origin.note}) {
    if (d.coin()) *text = "\"\\\n\x01\xc3\xa4/ ";
  }
  if (d.coin()) origin.seed = d.choose(~std::uint64_t{0});
  if (d.coin()) origin.index = d.choose(~std::uint64_t{0});
  if (d.coin()) origin.more["label"] = "1e-2";
  if (d.coin()) drawn.asked = {0.01, 1 + d.choose(8)};
  const Outcome expected = d.pick(kAllOutcomes);
  const char* const cause = is_failure(expected) ? "left root" : "";
  if (d.coin()) drawn.expect["tdibm-h:1e-12"] = {expected, d.coin() ? cause : ""};
  return drawn;
}

Case draw_case(Draw& choices) {
  if (choices.coin()) return draw_any_case(choices);
  const Result<Case> contact = draw_contact(choices, {});
  return contact ? *contact : draw_any_case(choices);
}

/// Texts that tend to confuse readers.
constexpr const char* kTokens =
    "\" { } [ ] , : null 1e999 -0 -1 \\u0 NaN true \"1/0\" 0x1p-1080 \"0x1.8p1\" 1e-400 "
    "\"t_max\":0, \xff [[[[[[[[ 99999999999999999999";

/// The next number from there on is another one, or what almost is one.
void spoil_number(Draw& choices, std::string& text, std::size_t at) {
  constexpr const char* kNumbers = "0 -0 1e999 -1e999 1e-400 1e308 9007199254740993 \"0x1.8p1\"";
  constexpr const char* kDigits = "0123456789.eE+-";
  const std::size_t first = std::min(text.find_first_of("0123456789", at), text.size());
  const std::size_t end = std::min(text.find_first_not_of(kDigits, first), text.size());
  text.replace(first, end - first, draw_word(choices, kNumbers));
}

void spoil_text(Draw& choices, std::string& text) {
  const std::size_t at = choices.choose(text.size());
  switch (choices.choose(4)) {
    case 0:
      text.insert(at, draw_word(choices, kTokens));
      break;
    case 1: {
      const std::size_t count = choices.choose(40);
      text.erase(at, count);
      break;
    }
    case 2:
      if (at < text.size()) text[at] = static_cast<char>(choices.choose(255));
      break;
    case 3:
      spoil_number(choices, text, at);
      break;
    default: {
      const std::size_t from = choices.choose(text.size());
      const std::string copied = text.substr(from, choices.choose(60));
      text.insert(at, copied);
    }
  }
}

}  // namespace

Truth draw_any_truth(Draw& d, const Query& query, DrawRational* draw_number) {
  Truth truth;
  if (d.coin()) {
    truth.witness = Witness{draw_number(d), {}};
    for (std::size_t s = 0; s < 2; ++s) {
      const auto count = static_cast<std::size_t>(query.patches[s].shape.control_count());
      if (is_of_bodies(query)) {
        truth.witness->weights[s].assign(count, draw_number(d));
      } else {
        truth.witness->uv[s] = {draw_number(d), draw_number(d)};
      }
    }
  }
  if (d.coin()) truth.clear_until = draw_number(d);
  if (d.coin()) truth.contact_box = draw_any_box(d);
  if (d.coin()) {
    ContactRoot root{{}, draw_number(d), draw_number(d)};
    for (std::uint64_t k = d.choose(kMaxRootDegree); k > 0; --k) {
      root.polynomial.push_back(draw_number(d).get_num());
    }
    truth.contact_root = std::move(root);
  }
  if (d.coin()) truth.clearance = draw_any_clearance(d, draw_number);
  if (truth.clearance && d.coin()) truth.proof = proof_word(*truth.clearance);
  if (!truth.proof && d.coin()) truth.proof = "rational-tdibm";
  const bool is_contact = truth.witness || truth.contact_box || truth.contact_root;
  if (is_contact && d.coin()) {
    truth.collides = true;
  } else if (truth.proof && d.coin()) {
    truth.collides = false;
  }
  return truth;
}

void claim_reader_takes(const std::string& text) {
  const Result<Case> first = parse_case(text, "input");
  if (!first) {
    CLAIM(first.error().where.find("input") != std::string::npos);
    CLAIM(!first.error().what.empty());
    return;
  }
  for (const JsonLayout layout : kLayouts) {
    const std::string written = to_json(*first, layout);
    const Result<Case> again = parse_case(written, "written");
    CLAIM(again.has_value());
    CLAIM(*again == *first);
    CLAIM(to_json(*again, layout) == written);
  }
}

std::string draw_spoilt_text(Draw& choices, std::string text) {
  // Once mostly: what is spoilt often is refused for one reason alone.
  const std::uint64_t times = choices.coin() ? 1 : choices.choose(4);
  for (std::uint64_t left = times; left > 0; --left) spoil_text(choices, text);
  return text;
}

std::vector<Property> case_file_claims() {
  return {
      {"case_file.mutants",
       "A case that is written and read is the same case; what is almost a case file is refused "
       "with a reason, or read as a case that is written and read again",
       "the case format",
       [](Draw& d) {
         const Case value = draw_case(d);
         const JsonLayout layout = d.pick(kLayouts);
         const std::string written = show(d, "written", to_json(value, layout));
         const Case read = parse_case(written, "written").value();
         CLAIM(read == value);
         CLAIM(to_json(read, layout) == written);  // −0, too
         CLAIM(layout == JsonLayout::kReadable || written.find('\n') == std::string::npos);
         const std::string text = draw_spoilt_text(d, written);
         show(d, "text", AsHex{text});
         claim_reader_takes(text);
       }},
  };
}

}  // namespace ccdfuzz
