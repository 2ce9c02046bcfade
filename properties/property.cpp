#include "properties/property.hpp"

#include <new>

#include "base/no_process.hpp"

namespace ccdfuzz {

namespace {

/// The values that the check shows on the same choices once more.
std::string story_of(const Property& property, const ChoiceNumbers& numbers) {
  std::string story;
  Draw again = Draw::from_numbers(numbers);
  again.tell_to(&story);
  try {
    property.check(again);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // NOLINT: the failure that is shown
  }
  return story;
}

}  // namespace

Result<Property> about(Property claim, const std::string& method) {
  if (method.empty()) return claim;
  if (!claim.check_of) {
    return input_error(claim.name, "the claim says itself which methods it is about");
  }
  claim.check = [check = claim.check_of, method](Draw& d) { check(d, method); };
  claim.method = method;
  return claim;
}

std::string title_of(const std::string& property, const std::string& method) {
  return method.empty() ? property : property + " of " + method;
}

Check run(const Property& property, Draw& choices, bool tells) {
  std::string failure;
  try {
    property.check(choices);
    return Check::holds();
  } catch (const Discarded& why) {
    return Check::discarded(why.what());
  } catch (const Refuted& why) {
    failure = why.what();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const NoProcess&) {
    throw;
  } catch (const std::exception& error) {
    failure = std::string("an exception: ") + error.what();
  }
  return Check::fails(tells ? failure + story_of(property, choices.numbers()) : failure);
}

}  // namespace ccdfuzz
