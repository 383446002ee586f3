#include "common/transport/dds/peer_name.h"

#include <gtest/gtest.h>

namespace accord::dds {
namespace {

TEST(PeerName, ComesBackFromUserData) {
  const PeerName name{"plant-7", 3, Role::kCoordinator, {0xfedcba9876543210ULL}};
  EXPECT_EQ(to_user_data(name), "accord/plant-7/3/coordinator/fedcba9876543210");
  const auto parsed = parse_user_data(to_user_data(name));
  ASSERT_TRUE(parsed);
  EXPECT_EQ(parsed->cluster, name.cluster);
  EXPECT_EQ(parsed->protocol, name.protocol);
  EXPECT_EQ(parsed->role, name.role);
  EXPECT_EQ(parsed->id, name.id);
}

TEST(PeerName, IsNotReadIntoWhatOthersSay) {
  for (const char* text :
       {"", "accord", "accord/", "other/a/1/worker/1", "accord/a/1/boss/1", "accord/a/x/worker/1",
        "accord/a/1/worker/", "accord/a/1/worker/0", "accord/a/1/worker/11112222333344445",
        "accord/a/1/worker/1/", "accord/a/99999999999/worker/1"}) {
    EXPECT_FALSE(parse_user_data(text)) << text;
  }
}

}  // namespace
}  // namespace accord::dds
