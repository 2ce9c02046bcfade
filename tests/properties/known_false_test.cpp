// The claims that are known to be false, each with the simplest counterexample that shrinking
// found: stored choices, not seeds. One that passes is an alert: a claim was repaired, or a draw
// changed and the choices mean something else; `ccdfuzz check PROPERTY` finds and shrinks it anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "properties/registry.hpp"

namespace ccdfuzz {
namespace {

struct KnownFalse {
  std::string_view property, choices;
};

constexpr std::array kKnownFalse = {
    KnownFalse{"tdibm.envelope", "000100000000010200000000000010000100010001"},
    KnownFalse{"tdibm.separation", "000102000000000000010000000000000001"},
    KnownFalse{"tdibm-e-literal.separation",
               "000a00000000010500000000000000000000010001000018001b0000010000000000000000000700000"
               "00000000000010000010000000000000000000119000000000000000000000001"},
    KnownFalse{"tdibm.no_false_negative",
               "0000000000000000000000000000000000000000020100000000000500000001"},
    KnownFalse{"tdibm-e.no_false_negative_underflow",
               "05000100000000000000000000000000000000000000000000000000000002000000000200000000000"
               "00000000309"},
    KnownFalse{"tdibm-e-literal.no_false_negative",
               "00000001000000000004000000000000000000000002020100000000000000000000000000000000000"
               "00000000000000000000000000100000000000000000000000000000100000000000000000000000000"
               "00060101010000000000010100000000000001000000000000000001000000000000000100000000000"
               "000000000070000000003"},
    KnownFalse{"paper.rounding_as_printed", "00"},
    KnownFalse{"paper.rounding_anywhere", "010000000000000001"},
    KnownFalse{"paper.theorem_4_1_underflow", "0101000000000000000000000001000000000002"},
    KnownFalse{"paper.nextafter_is_smallest", "0300001629030000266ebc30bc4d1325"},
    KnownFalse{"paper.eps_Psi_min_as_printed",
               "00000000010000030100000000000000000000000101000000000103000600000000000000000100000"
               "0010000000101"},
    KnownFalse{"tdibm-e.conservative_decisions_underflow", "000000000000000200020001"},
    KnownFalse{"paper.Delta_phi_as_printed",
               "2000003f000001012b000000000a0001000500000000000000000000000000000000000000000000000"
               "000010015"},
    KnownFalse{
        "tdibm-e.convex_chain_raised",
        "000b00000000000400000000000000000000000000000000000000000108000000000000000000000000000000"
        "0000000000000000000000000000000000000000000000000000000000000006050606000603"},
    KnownFalse{"tdibm-e-literal.convex_chain", "0001000000000002000200000001"},
    KnownFalse{"paper.overlap_as_printed", "0101"},
    KnownFalse{"paper.pull_apart_path", "020508"},
    KnownFalse{"paper.every_dyadic_is_a_double", "fd0703"},
    KnownFalse{"trad.monotone_in_t_max",
               "0000000000000000000000000000000000000003010300000204000000000002050b000000000000000"
               "000000000001d000000000000000000000c000000020a09"},
    KnownFalse{"tdibm.trace",
               "00000000000000000000040000000000000000000000000000000000000001000000000000010001"},
    KnownFalse{"tdibm-e.trace_underflow",
               "05000100000000000000000000000000000000000000000000000000000002000000000200000000000"
               "00000000309"},
    KnownFalse{"tdibm-e-literal.trace",
               "00000001000000000004000000000000000000000002020100000000000000000000000000000000000"
               "00000000000000000000000000100000000000000000000000000000100000000000000000000000000"
               "00060101010000000000010100000000000001000000000000000001000000000000000100000000000"
               "000000000070000000003"},
    KnownFalse{"tdibm-e.mirror",
               "01000000000303010304000000000000000704030000030102000204000107000000000000000000000"
               "00000000000000000000000081b00000000000000000000002f00000000000000000000000000000000"
               "00000000000000000000000000000000000001010000000000000100000000000000000100000000000"
               "00000000001000000000000010100000000000000000000061100000000000000000101020004000000"
               "0104000402000002"},
    KnownFalse{"methods.monotone_in_t_max",
               "06000000000000020000000000000000000000000003030100020401050000000000000001000000000"
               "00000050000000000000000000000000000000000000000000200020201000003000201000000000000"
               "00001100000001000200000101"},
    KnownFalse{"tdibm-e.swap",
               "00000400040401010002040000010000000300060e020100010000070200000806011f051f000002000"
               "000090401070c2902033707151021002200020601"},
};

TEST(KnownFalse, EachHasItsCounterexample) {
  for (const auto& [name, hex] : kKnownFalse) {
    const auto property = property_named(name);
    ASSERT_TRUE(property) << name;
    EXPECT_EQ(property->expected, Expectation::kFails) << name;
    const auto bytes = parse_hex_bytes(hex);
    ASSERT_TRUE(bytes) << name;
    ByteChoices choices(*bytes);
    EXPECT_EQ(run(*property, choices).status, Check::Status::kFails) << name;
  }
}

TEST(KnownFalse, NoneIsLeftOut) {
  for (const Property& p : properties()) {
    if (p.expected != Expectation::kFails) continue;
    EXPECT_TRUE(std::ranges::any_of(kKnownFalse, [&](const auto& k) {
      return k.property == p.name;
    })) << p.name;
  }
}

}  // namespace
}  // namespace ccdfuzz
