#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "case/case_files.hpp"

namespace ccdfuzz {

/// The engines that examples/engines has adapters of.
enum class Engine : std::uint8_t { kRapier, kJolt, kPhysx, kHavok, kFcl, kBullet };
inline constexpr std::array kEngines = {Engine::kRapier, Engine::kJolt, Engine::kPhysx,
                                        Engine::kHavok,  Engine::kFcl,  Engine::kBullet};
/// "rapier", …
std::string_view name_of(Engine engine);

/// A complete test file that asks the engine itself the query of a case, as its adapter does, and
/// fails where the engine misses the proven contact, or is late for it, or reports one where none
/// is proven. It needs nothing of ccdfuzz: for engines of npm it is a module for Node, for others
/// a GoogleTest. Requires a checked case. Errors: the case is of other shapes than the engine has,
/// or neither a contact within t_max nor its absence is proven; naming the case.
Result<std::string> engine_test(const NamedCase& named, Engine engine);

}  // namespace ccdfuzz
