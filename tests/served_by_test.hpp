#pragma once

namespace ccdfuzz {

/// What main calls first, if a test has set it: where tests ask children, those are their program
/// (serve_if_asked).
extern void (*served_by_test)(int argc, char** argv);

}  // namespace ccdfuzz
