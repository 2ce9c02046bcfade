#include "campaign_options.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

const std::vector<PlantedFault> kFewFaults = {{"a.fault", "what", "a.hpp", false, "x", "y", ""}};

TEST(CampaignOptions, NameTheirFaultsUnlessAllAreWatched) {
  std::vector<PlantedFault> faults = {kFewFaults[0], kFewFaults[0]};
  faults[1].name = "b.fault";
  CampaignOptions options;
  EXPECT_EQ(asked_faults(options, faults).size(), 2);
  options.faults = {"b.fault", "none"};
  ASSERT_EQ(asked_faults(options, faults).size(), 1);
  EXPECT_EQ(asked_faults(options, faults)[0].name, "b.fault");
  EXPECT_FALSE(is_asked(options, "a.fault"));
  options.faults = {"none"};
  EXPECT_TRUE(asked_faults(options, faults).empty());
  options.faults = {"watched"};
  EXPECT_EQ(asked_faults(options, faults).size(), 2);
}

}  // namespace
}  // namespace ccdfuzz
