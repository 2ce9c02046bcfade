#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// A case with its truth and without its origin, or why it was thrown away.
using Attempted = tl::expected<Case, Discard>;
/// One attempt at a case of the options. Requires valid options.
using Attempt = Attempted(const GeneratorOptions& options, Draw& draw);

/// eps_T, as GeneratorOptions say.
Dyadic eps_t(const GeneratorOptions& options);

/// shaped/shaped_case.cpp: two patches of any shapes.
Attempt shaped_case;

}  // namespace ccdfuzz
