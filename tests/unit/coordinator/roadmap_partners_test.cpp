#include "coordinator/dispatch/roadmap_partners.h"

#include <gtest/gtest.h>

#include "common/model/roadmap_places.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

Pose at(double x, double y, double z = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(x, y, z);
  return pose;
}

RoadmapPartners partners_in(const std::shared_ptr<const Scene>& scene) {
  const CollisionWorld world(scene, 0);
  return roadmap_partners(world, roadmap_places(*scene));
}

TEST(RoadmapPartners, AreThoseWhoseWaysHaveMostInCommon) {
  const auto arm = testing::planar_arm_model({1, 0.8});
  const auto scene = testing::SceneBuilder(-9, -9, 9, 9)
                         .robot(arm, {0.8, 0}, {-0.8, 0}, at(0, 0))
                         .robot(arm, {0.8, 0}, {-0.8, 0}, at(0, 1.4))
                         .robot(arm, {0.8, 0}, {-0.8, 0}, at(0, 2.0))
                         .robot(arm, {0.8, 0}, {-0.8, 0}, at(7, 0))
                         .build();
  EXPECT_EQ(partners_in(scene), (RoadmapPartners{1, 2, 1, 3}));
}

TEST(RoadmapPartners, AreOfPlacesThatRobotsMayShare) {
  const auto scene = testing::SceneBuilder(-9, -9, 9, 9)
                         .disk(0.5, {-5, 0}, {5, 0})
                         .robot(testing::planar_arm_model({1, 0.8}), {0.8, 0}, {-0.8, 0})
                         .build();
  EXPECT_EQ(partners_in(scene), (RoadmapPartners{1, 0}));
}

}  // namespace
}  // namespace accord
