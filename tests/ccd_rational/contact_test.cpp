#include "ccd/rational/proves_clear.hpp"
#include "generators/rc/rapidcheck.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

RC_GTEST_PROP(Contact, ForbidsAProofOfItsAbsence, ()) {
  const auto contact = *gen::contact({-900, 900, 2});
  RC_ASSERT(!proves_clear(contact.query, contact.t.rational(), {.pops = 1000}));
}

}  // namespace
}  // namespace ccdfuzz
