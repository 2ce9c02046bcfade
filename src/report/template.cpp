#include "report/template.hpp"

// The assembler takes the file in as it is, which costs no time; a C++ literal of its size would.
asm(R"(
  .section .rodata
  .global ccdfuzz_report_template_begin
  .global ccdfuzz_report_template_end
ccdfuzz_report_template_begin:
  .incbin ")" CCDFUZZ_REPORT_TEMPLATE R"("
ccdfuzz_report_template_end:
  .previous
)");

extern "C" const char ccdfuzz_report_template_begin[], ccdfuzz_report_template_end[];

namespace ccdfuzz {

std::string_view report_template() {
  return {ccdfuzz_report_template_begin,
          static_cast<size_t>(ccdfuzz_report_template_end - ccdfuzz_report_template_begin)};
}

}  // namespace ccdfuzz
