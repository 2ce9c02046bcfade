#include "properties/property.hpp"

#include <exception>

namespace ccdfuzz {

Check run(const Property& property, Draw& choices) {
  try {
    return property.check(choices);
  } catch (const Discarded& why) {
    return Check::discarded(why.what());
  } catch (const std::exception& error) {
    return Check::fails(error);
  }
}

}  // namespace ccdfuzz
