#include "properties/property.hpp"

#include <exception>

namespace ccdfuzz {

Check run(const Property& property, ChoiceSource& choices) {
  try {
    return property.check(choices);
  } catch (const std::exception& error) {
    return Check::fails(error);
  }
}

}  // namespace ccdfuzz
