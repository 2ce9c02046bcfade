#include "properties/suites.hpp"

namespace ccdfuzz {

std::vector<Property> Suite::thought_to_hold() const {
  std::vector<Property> those = claims;
  std::erase_if(those, [](const Property& p) { return p.expected != Expectation::kHolds; });
  return those;
}

Result<Suite> suite_named(std::string_view name) {
  std::string names;
  for (const Suite& suite : suites()) {
    if (suite.name == name) return suite;
    names += (names.empty() ? "" : ", ") + suite.name;
  }
  return input_error("", "no target \"{}\"; there are: {}", name, names);
}

const std::vector<Property>& properties() {
  static const std::vector<Property> all = [] {
    std::vector<Property> list;
    for (const Suite& suite : suites()) {
      list.insert(list.end(), suite.claims.begin(), suite.claims.end());
    }
    return list;
  }();
  return all;
}

Result<Property> property_named(std::string_view name, const std::vector<Property>& among) {
  // A name that is almost right gets the few to choose from; they would not help another.
  constexpr int kMost = 8;
  const auto subject_of = [](std::string_view text) { return text.substr(0, text.find('.')); };
  std::string alike;
  int count = 0;
  for (const Property& p : among) {
    if (p.name == name) return p;
    const bool is_part = !name.empty() && p.name.find(name) != std::string_view::npos;
    if (!is_part && subject_of(p.name) != subject_of(name)) continue;
    alike += (alike.empty() ? "" : ", ") + p.name;
    ++count;
  }
  const bool is_help = 0 < count && count <= kMost;
  return input_error("", "no property \"{}\"; {}{}", name,
                     is_help ? "there are: " : "the list is: ccdfuzz properties",
                     is_help ? alike : "");
}

}  // namespace ccdfuzz
