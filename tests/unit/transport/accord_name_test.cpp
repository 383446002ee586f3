#include <gtest/gtest.h>

#include "common/transport/dds/fleet/topics.h"
#include "common/transport/dds/peer_name.h"
#include "common/transport/survey/domain_survey.h"

namespace accord {
namespace {

TEST(AccordName, IsReadFromWhatOurProcessesSayOfThemselves) {
  const dds::PeerName worker{"plant-7", 3, Role::kWorker, {0xfeULL}};
  EXPECT_EQ(accord_name_in(dds::to_user_data(worker)),
            (AccordName{AccordName::Role::kWorker, "plant-7", 3, 0xfe}));
  EXPECT_EQ(accord_name_in(dds::fleet_user_data("plant-7", dds::kServiceRole)),
            (AccordName{AccordName::Role::kService, "plant-7", 1, 0}));
  EXPECT_EQ(accord_name_in(dds::fleet_user_data("plant-7", dds::kClientRole)),
            (AccordName{AccordName::Role::kClient, "plant-7", 1, 0}));
}

TEST(AccordName, IsNotReadIntoWhatOthersSay) {
  for (const char* text : {"", "accord", "accord/a/1", "other/a/1/worker/1", "accord/a/x/worker/1",
                           "accord/a/1/worker", "accord/a/1/boss/1", "accord/a b/1/worker/1",
                           "accord-fleet/a/1/worker", "accord-fleet//1/service"}) {
    EXPECT_FALSE(accord_name_in(text)) << text;
  }
}

}  // namespace
}  // namespace accord
