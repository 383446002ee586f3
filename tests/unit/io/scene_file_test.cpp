// What sound scenes mean. What unsound ones are told: tests/invalid.
#include "common/io/scene_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "common/io/limits.h"

namespace accord {
namespace {

constexpr std::string_view kPlanar = R"(accord: scene/1
name: planar
environment:
  bounds: [[-5, -4], [5, 4]]
  obstacles:
    - {box: [1, 2, 1], at: [0, 0, 0.5]}
    - {polygon: [[3, 2], [3, 3], [4, 2]], name: wedge}
models:
  agv: {disk: 0.3, speed: 1.5}
  cart: {footprint: [[-.4,-.3],[-.4,.3],[.4,.3],[.4,-.3]], speed: 1, turn: 2}
robots:
  - {name: a, model: agv, start: [-3, 0], goal: [3, 0]}
  - {name: 7, model: cart, start: [-3, 2, 100], goal: [3, -2, -1e1]}
)";

std::shared_ptr<const Scene> scene_of(std::string_view text) {
  const SceneResult result = parse_scene(text, "s.yaml", ACCORD_SOURCE_DIR "/scenes");
  for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
  return result.scene;
}

TEST(SceneFile, HasDefaults) {
  const auto scene = scene_of(kPlanar);
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->timestep, 0.1);
  EXPECT_EQ(scene->clearance, 0);
  EXPECT_TRUE(scene->planar);
  EXPECT_EQ(scene->obstacles[0].name, "obstacle 0 (box)");
  EXPECT_EQ(scene->obstacles[1].name, "wedge");
}

TEST(SceneFile, TurnsPolygonsCounterClockwise) {
  const auto scene = scene_of(kPlanar);
  ASSERT_NE(scene, nullptr);
  const auto& wedge = std::get<Polygon>(scene->obstacles[1].shape).vertices;
  EXPECT_EQ(wedge, (std::vector<Vec2>{{4, 2}, {3, 3}, {3, 2}}));
}

TEST(SceneFile, GivesMobileRobotsTheirDegreesOfFreedom) {
  const auto scene = scene_of(kPlanar);
  ASSERT_NE(scene, nullptr);
  const RobotModel& disk = *scene->robots[0].model;
  EXPECT_EQ(disk.kind, RobotKind::kDisk);
  EXPECT_EQ(disk.speed, 1.5);
  ASSERT_EQ(disk.dof(), 2U);
  EXPECT_EQ(disk.dofs[1].velocity, 1.5);
  EXPECT_EQ(disk.dofs[1].upper, std::numeric_limits<double>::infinity());
  const Robot& cart = scene->robots[1];
  EXPECT_EQ(cart.name, "7");
  ASSERT_EQ(cart.model->dof(), 3U);
  EXPECT_EQ(cart.model->dofs[2].name, "heading");
  EXPECT_EQ(cart.model->dofs[2].velocity, 2);
  EXPECT_TRUE(cart.model->dofs[2].wraps);
  EXPECT_EQ(cart.start, (Configuration{-3, 2, 100}));
  EXPECT_EQ(cart.goal, (Configuration{3, -2, -10}));
}

TEST(SceneFile, SharesModels) {
  const auto scene = scene_of(R"(accord: scene/1
models: {arm: {urdf: arm6.urdf}}
robots:
  - {name: a, model: arm, start: [0, 0.5, 1, 0, 0, 0], goal: [1, 0.5, 1, 0, 0, 0]}
  - {name: b, model: arm, at: [3, 0, 1], rpy: [0, 0, 1],
     start: [0, 0.5, 1, 0, 0, 0], goal: [1, 0.5, 1, 0, 0, 0]}
)");
  ASSERT_NE(scene, nullptr);
  EXPECT_FALSE(scene->planar);
  EXPECT_FALSE(scene->bounds);
  EXPECT_EQ(scene->name, "s");
  EXPECT_EQ(scene->robots[0].model, scene->robots[1].model);
  EXPECT_EQ(scene->robots[0].model->name, "arm");
  EXPECT_EQ(scene->robots[1].base.translation(), Vec3(3, 0, 1));
}

TEST(SceneFile, IsAlsoReadAsJson) {
  EXPECT_NE(scene_of(R"({"accord": "scene/1", "environment": {"bounds": [[0, 0], [9, 9]]},
    "models": {"m": {"disk": 0.5, "speed": 1}},
    "robots": [{"name": "a", "model": "m", "start": [1, 1], "goal": [8, 8]}]})"),
            nullptr);
}

TEST(SceneFile, MayNameNoFilesWithoutAFolder) {
  const SceneResult result = parse_scene(R"(accord: scene/1
models: {arm: {urdf: arm6.urdf}}
robots: [{name: a, model: arm, start: [0], goal: [1]}]
)",
                                         "request 7", "");
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(
      to_string(result.faults[0]),
      "request 7:2: models.arm.urdf: a scene that is not a file itself cannot name other files");
}

TEST(SceneFile, ReportsFilesThatCannotBeRead) {
  const auto words = [](const std::string& path) {
    const SceneResult result = load_scene(path);
    return result.faults.empty() ? "" : to_string(result.faults[0]);
  };
  EXPECT_EQ(words("/nowhere/s.yaml"),
            "/nowhere/s.yaml: cannot open \"/nowhere/s.yaml\": no such file");
  EXPECT_EQ(words("/tmp"), "/tmp: cannot open \"/tmp\": it is a folder");
  EXPECT_EQ(words("/dev/zero"), "/dev/zero: cannot open \"/dev/zero\": it is not a regular file");
}

TEST(SceneFile, SaysHowLargeFilesMayBe) {
  const SceneResult result = parse_scene(std::string(limits::kSceneBytes + 1, ' '), "s.yaml", "");
  ASSERT_EQ(result.faults.size(), 1U);
  EXPECT_EQ(to_string(result.faults[0]), "s.yaml: the scene is too large; expected at most 4 MiB");
}

TEST(SceneFile, AcceptsStartsExactlyAsFarApartAsRobotsNeed) {
  const auto faults = [](double gap) {
    const std::string y = std::to_string(0.6 + gap);
    return parse_scene(
               "accord: scene/1\nclearance: 0\nenvironment: {bounds: [[-5, -5], [5, 5]]}\n"
               "models: {m: {disk: 0.3, speed: 1}}\nrobots:\n"
               "  - {name: a, model: m, start: [0, 0], goal: [3, 0]}\n"
               "  - {name: b, model: m, start: [0, " +
                   y + "], goal: [3, 2]}\n",
               "s", "")
        .faults.size();
  };
  EXPECT_EQ(faults(1e-5), 0U);
  EXPECT_EQ(faults(1e-6), 1U);
  EXPECT_EQ(faults(0), 1U);
}

}  // namespace
}  // namespace accord
