// What maps of either format mean in the world.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "common/io/scene_file.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

constexpr std::string_view kMap = "type octile\nheight 2\nwidth 3\nmap\n@.G\nT.S\n";

class MapFiles : public ::testing::Test {
 protected:
  MapFiles() {
    write("m.map", kMap);
    write("m.pgm", "P2\n3 2\n255\n0 254 254\n205 254 100\n");
  }

  void write(const std::string& name, std::string_view text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  // The scene with one map obstacle, and a robot far away.
  std::shared_ptr<const Scene> scene(const std::string& obstacle, bool spatial = false) {
    const std::string text = std::string("accord: scene/1\nenvironment:\n  bounds: ") +
                             (spatial ? "[[-50, -50, 0], [50, 50, 9]]" : "[[-50, -50], [50, 50]]") +
                             "\n  obstacles:\n    - " + obstacle + "\nmodels:\n  m: {" +
                             (spatial ? "ball" : "disk") +
                             ": 0.1, speed: 1}\nrobots:\n  - {name: a, model: m, start: [-40, 0" +
                             (spatial ? ", 1], goal: [-41, 0, 1]}" : "], goal: [-41, 0]}");
    const SceneResult result = parse_scene(text, "s.yaml", folder_);
    for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
    return result.scene;
  }

  const testing::ScratchFolder scratch_;
  const std::filesystem::path& folder_ = scratch_.path();
};

const Box& box(const Obstacle& obstacle) {
  return std::get<Box>(obstacle.shape);
}

TEST_F(MapFiles, LieWithTheirLowerLeftCornerAtAt) {
  const auto s = scene("{map: m.map, cell: 0.5, at: [10, 20]}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 2U);  // the left column, and the right lower cell
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(10.25, 20.5, 0)));
  EXPECT_TRUE(box(s->obstacles[0]).size.head<2>().isApprox(Vec2(0.5, 1)));
  EXPECT_TRUE(s->obstacles[1].pose.translation().isApprox(Vec3(11.25, 20.25, 0)));
}

TEST_F(MapFiles, TurnAboutTheirCorner) {
  const auto s = scene("{map: m.map, cell: 1, at: [10, 20], rpy: [0, 0, 1.5707963267948966]}");
  ASSERT_TRUE(s);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(9, 20.5, 0)));
}

TEST_F(MapFiles, RiseToTheirHeightInSpatialScenes) {
  const auto s = scene("{map: m.map, cell: 1, height: 3, at: [10, 20, 1]}", true);
  ASSERT_TRUE(s);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(10.5, 21, 2.5)));
  EXPECT_TRUE(box(s->obstacles[0]).size.isApprox(Vec3(1, 2, 3)));
}

TEST_F(MapFiles, FillTheHeightOfTheBoundsWithoutAHeightOfTheirOwn) {
  const auto s = scene("{map: m.map, at: [10, 20, 1]}", true);  // bounds from z = 0 to 9
  ASSERT_TRUE(s);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(10.5, 21, 4.5)));
  EXPECT_TRUE(box(s->obstacles[0]).size.isApprox(Vec3(1, 2, 9)));
}

TEST_F(MapFiles, FillTheBoundsAlongTheirOwnAxisWhereTheyAreTilted) {
  // A quarter of a roll: the map's z is -y of the world, along which the bounds are 100 m.
  const auto s = scene("{map: m.map, at: [10, 20, 1], rpy: [1.5707963267948966, 0, 0]}", true);
  ASSERT_TRUE(s);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(10.5, 0, 2)));
  EXPECT_TRUE(box(s->obstacles[0]).size.isApprox(Vec3(1, 2, 100)));
}

TEST_F(MapFiles, OfRosInSpatialScenesNeedNoHeightEither) {
  write("r.yaml", "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\n");
  const auto s = scene("{map: r.yaml, at: [10, 20, 1]}", true);
  ASSERT_TRUE(s);
  EXPECT_TRUE(box(s->obstacles[0]).size.isApprox(Vec3(0.5, 1, 9)));
}

TEST_F(MapFiles, OfRosBlockUnknownCells) {
  write("r.yaml",
        "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto s = scene("{map: r.yaml, at: [10, 20]}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 2U);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(11.25, 22.5, 0)));  // black, unknown
  EXPECT_TRUE(s->obstacles[1].pose.translation().isApprox(Vec3(12.25, 22.25, 0)));  // grey
}

TEST_F(MapFiles, OfRosBlockUnknownCellsBelowTheFreeThreshold) {
  // As nav2 saves maps: with a threshold that alone would make 205 free.
  write("r.yaml",
        "image: m.pgm\nmode: trinary\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  const auto s = scene("{map: r.yaml, at: [10, 20]}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 2U);
  EXPECT_TRUE(box(s->obstacles[0]).size.head<2>().isApprox(Vec2(0.5, 1)));  // black, unknown
}

TEST_F(MapFiles, OfRosBlockUnknownCellsOfAnyWhite) {
  write("m.pgm", "P2\n3 1\n65535\n65535 52685 65535\n");  // 205 * 257
  write("r.yaml", "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.25\n");
  const auto s = scene("{map: r.yaml}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 1U);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(1.5, 0.5, 0)));
}

TEST_F(MapFiles, OfRosBlockUnknownCellsOfNegatedImages) {
  write("m.pgm", "P2\n3 1\n255\n0 50 0\n");
  write("r.yaml", "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 1\nfree_thresh: 0.25\n");
  const auto s = scene("{map: r.yaml}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 1U);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(1.5, 0.5, 0)));
}

TEST_F(MapFiles, OfRosInModeScaleHaveNoUnknownCells) {
  write("m.pgm", "P2\n3 1\n255\n0 205 254\n");
  write("r.yaml",
        "image: m.pgm\nmode: scale\nresolution: 1\norigin: [0, 0, 0]\nfree_thresh: 0.25\n");
  const auto s = scene("{map: r.yaml}");
  ASSERT_TRUE(s);
  ASSERT_EQ(s->obstacles.size(), 1U);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(0.5, 0.5, 0)));
}

TEST_F(MapFiles, OfRosCanBeNegatedAndTurned) {
  write("r.yaml",
        "image: m.pgm\nresolution: 1\norigin: [0, 0, 1.5707963267948966]\nnegate: 1\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto s = scene("{map: r.yaml, at: [10, 20]}");
  ASSERT_TRUE(s);
  // Only the upper left cell is free; the lower row is one block, which turns to stand upright.
  ASSERT_EQ(s->obstacles.size(), 2U);
  EXPECT_TRUE(s->obstacles[0].pose.translation().isApprox(Vec3(9.5, 21.5, 0)));
  EXPECT_TRUE(box(s->obstacles[0]).size.head<2>().isApprox(Vec2(3, 1)));
}

}  // namespace
}  // namespace accord
