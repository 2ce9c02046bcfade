#include "properties/case_file.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

std::vector<Property> case_reader_claims() {
  return {
      {"case_file.any_bytes",
       "The reader refuses any text with a reason, or reads a case that it writes and reads again",
       "the case format",
       [](Draw& d) {
         constexpr std::size_t kLongest = 1 << 16;
         const std::string text = d.text(kLongest);
         show(d, "text", AsHex{text});
         claim_reader_takes(text);
       }},
  };
}

}  // namespace ccdfuzz
