#include "properties/case_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "files/case_json.hpp"
#include "generators/draw_contact.hpp"
#include "generators/draw_patch.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr std::array kLayouts = {JsonLayout::kOneLine, JsonLayout::kReadable};

/// Any finite numbers at all, in any two shapes.
Case draw_any_case(Draw& choices) {
  Case drawn;
  drawn.query = draw_any_query(choices);
  if (choices.coin()) drawn.origin.seed = choices.choose(~std::uint64_t{0});
  if (choices.coin()) drawn.origin.note = "\"\\\n\x01\xc3\xa4/ ";
  const Outcome expected = choices.pick(kAllOutcomes);
  if (choices.coin()) drawn.expect["tdibm-h:1e-12"] = expected;
  return drawn;
}

Case draw_case(Draw& choices) {
  if (choices.coin()) return draw_any_case(choices);
  const Result<Case> contact = draw_contact(choices, {});
  return contact ? *contact : draw_any_case(choices);
}

/// Texts that tend to confuse readers.
constexpr std::array<std::string_view, 22> kTokens = {"\"",
                                                      "{",
                                                      "}",
                                                      "[",
                                                      "]",
                                                      ",",
                                                      ":",
                                                      "null",
                                                      "1e999",
                                                      "-0",
                                                      "-1",
                                                      "\\u0",
                                                      "NaN",
                                                      "true",
                                                      "\"1/0\"",
                                                      "0x1p-1080",
                                                      "\"0x1.8p1\"",
                                                      "1e-400",
                                                      "\"t_max\":0,",
                                                      "\xff",
                                                      "[[[[[[[[",
                                                      "99999999999999999999"};

/// The next number from there on is another one, or what almost is one.
void spoil_number(Draw& choices, std::string& text, std::size_t at) {
  constexpr std::array<std::string_view, 8> kNumbers = {
      "0", "-0", "1e999", "-1e999", "1e-400", "1e308", "9007199254740993", "\"0x1.8p1\""};
  constexpr const char* kDigits = "0123456789.eE+-";
  const std::size_t first = std::min(text.find_first_of("0123456789", at), text.size());
  const std::size_t end = std::min(text.find_first_not_of(kDigits, first), text.size());
  text.replace(first, end - first, choices.pick(kNumbers));
}

void spoil_text(Draw& choices, std::string& text) {
  const std::size_t at = choices.choose(text.size());
  switch (choices.choose(4)) {
    case 0:
      text.insert(at, choices.pick(kTokens));
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
      {"case_file.round_trip", "A case that is written and read is the same case",
       "the case format",
       [](Draw& d) {
         const Case value = draw_case(d);
         for (const JsonLayout layout : kLayouts) {
           const std::string written = to_json(value, layout);
           show(d, "written", written);
           CLAIM(parse_case(written, "written").value() == value);
         }
       }},
      {"case_file.mutants",
       "The reader refuses what is almost a case file with a reason, or reads a case that it "
       "writes "
       "and reads again",
       "the case format",
       [](Draw& d) {
         const std::uint64_t mutations = d.choose(4);
         const auto layout = d.pick(kLayouts);
         std::string text = to_json(draw_case(d), layout);
         for (std::uint64_t i = 0; i < mutations; ++i) spoil_text(d, text);
         show(d, "text", AsHex{text});
         claim_reader_takes(text);
       }},
  };
}

}  // namespace ccdfuzz
