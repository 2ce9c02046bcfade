#include "query/case_json.hpp"

#include "query/random_case.hpp"

namespace ccdfuzz {
namespace {

RC_GTEST_PROP(CaseJson, RoundTripsEveryCaseBitByBit, ()) {
  const Case c = any_case();
  for (const JsonLayout layout : {JsonLayout::kOneLine, JsonLayout::kReadable}) {
    const std::string text = to_json(c, layout);
    const auto back = parse_case(text, "c.json");
    if (!back) RC_FAIL(back.error().message() + "\n" + text);
    RC_ASSERT(same_bits(back->query, c.query));
    // The text of an extra key may be written another way, but once read it stays.
    Case same = c;
    same.origin.more = back->origin.more;
    RC_ASSERT(*back == same);
    RC_ASSERT(to_json(*back, layout) == to_json(*parse_case(to_json(*back), "c.json"), layout));
  }
}

RC_GTEST_PROP(CaseJson, IsOneLine, ()) {
  RC_ASSERT(to_json(any_case()).find('\n') == std::string::npos);
}

}  // namespace
}  // namespace ccdfuzz
