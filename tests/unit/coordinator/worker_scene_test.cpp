#include "coordinator/dispatch/worker_scene.h"

#include <gtest/gtest.h>

#include "common/io/wire/scene_codec.h"
#include "common/io/wire/scene_hash.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

std::shared_ptr<const Scene> cell(Configuration arm_start, Configuration arm_goal,
                                  Configuration agv_goal) {
  return testing::SceneBuilder(-9, -9, 9, 9)
      .box(3, 3, 4, 4)
      .robot(testing::planar_arm_model({1, 0.8}), std::move(arm_start), std::move(arm_goal))
      .disk(0.5, {-5, 0}, std::move(agv_goal))
      .build();
}

SceneHash hash_for_workers(const Scene& scene) {
  return hash_of(encode_scene(scene_for_workers(scene)));
}

TEST(WorkerScene, IsTheSameForOtherWaysOfArms) {
  const SceneHash hash = hash_for_workers(*cell({0.8, 0}, {-0.8, 0}, {5, 0}));
  EXPECT_EQ(hash_for_workers(*cell({0.2, 1}, {1, -1}, {5, 0})), hash);
  EXPECT_NE(hash_for_workers(*cell({0.8, 0}, {-0.8, 0}, {5, 1})), hash)
      << "mobile robots' roadmaps have ways around where others stand";
}

TEST(WorkerScene, IsOneThatWorkersTake) {
  const auto scene = cell({0.8, 0}, {-0.8, 0}, {5, 0});
  const auto taken = decode_scene(encode_scene(scene_for_workers(*scene)));
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_EQ((*taken)->obstacles.size(), scene->obstacles.size());
  EXPECT_EQ((*taken)->robots[1].goal, scene->robots[1].goal);
}

// Joints whose limits do not hold zero.
TEST(WorkerScene, KeepsArmsWithinTheirLimits) {
  auto model = std::make_shared<RobotModel>(*testing::planar_arm_model({1, 0.8}));
  model->dofs[0].lower = 0.5;
  model->dofs[1].upper = -0.25;
  const auto scene = testing::SceneBuilder(-9, -9, 9, 9).robot(model, {0.6, -1}, {1, -0.5}).build();
  const Scene out = scene_for_workers(*scene);
  EXPECT_EQ(out.robots[0].start, (Configuration{0.5, -0.25}));
  EXPECT_TRUE(decode_scene(encode_scene(out)));
}

}  // namespace
}  // namespace accord
