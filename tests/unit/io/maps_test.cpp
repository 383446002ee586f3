// What the two map formats mean, cell by cell and in the world.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "common/io/limits.h"
#include "common/io/movingai_map.h"
#include "common/io/pgm.h"
#include "common/io/ros_map.h"
#include "common/io/scene_file.h"

namespace accord {
namespace {

constexpr std::string_view kMap = "type octile\nheight 2\nwidth 3\nmap\n@.G\nT.S\n";

TEST(MovingAiMap, HasItsLastLineAtTheBottom) {
  Faults faults("m");
  const auto grid = parse_movingai_map(kMap, "m", faults);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->blocked, (std::vector<std::uint8_t>{1, 0, 1, 1, 0, 0}));
}

TEST(MovingAiMap, ReportsAllBrokenRows) {
  Faults faults("m");
  EXPECT_FALSE(parse_movingai_map("type octile\nheight 3\nwidth 2\nmap\n.\n..\n.x\n", "m", faults));
  const auto list = faults.take();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].line, 5);
  EXPECT_EQ(list[1].line, 7);
}

std::vector<std::string> faults_of_map(std::string_view text) {
  Faults faults("m");
  EXPECT_FALSE(parse_movingai_map(text, "m", faults));
  std::vector<std::string> list;
  for (const Diagnostic& fault : faults.take()) list.push_back(to_string(fault));
  return list;
}

TEST(MovingAiMap, ReportsAllBrokenLinesOfItsHeader) {
  EXPECT_EQ(
      faults_of_map("type hexagonal\nheight high\nwidth 0\nmaps\n"),
      (std::vector<std::string>{"m:1: type: expected \"octile\", not \"hexagonal\"",
                                "m:2: height: expected a number of cells from 1 to 16384, not "
                                "\"high\"",
                                "m:3: width: expected a number of cells from 1 to 16384, not \"0\"",
                                "m:4: map: expected the line \"map\", not \"maps\""}));
}

TEST(MovingAiMap, MissesOneLineOfItsHeaderOnce) {
  EXPECT_EQ(
      faults_of_map("type octile\nwidth 3\nmap\n...\n"),
      (std::vector<std::string>{"m:2: height: expected the line \"height\", not \"width 3\""}));
  EXPECT_EQ(faults_of_map("type octile\nheight 3\n"),
            (std::vector<std::string>{
                "m:2: width: the file ends before the header does; expected the line \"width\""}));
  EXPECT_EQ(faults_of_map(""),
            (std::vector<std::string>{
                "m:1: type: the file ends before the header does; expected the line \"type\""}));
}

TEST(MovingAiMap, ListsBrokenRowsUpToALimit) {
  std::string text = "type octile\nheight 1000\nwidth 2\nmap\n";
  for (std::size_t i = 0; i < 1000; ++i) text += "x\n";
  const auto list = faults_of_map(text);
  ASSERT_EQ(list.size(), limits::kLineFaults + 1);
  EXPECT_EQ(list.back(), "m:24: no more than 20 faults of a file are listed");
}

void nobody(std::string_view text) {
  ADD_FAILURE() << text;
}

TEST(Pgm, TextAndBinarySayTheSame) {
  Faults faults("p");
  const auto text =
      parse_pgm("P2 # c\n3 # width\n2\n255\n0 1 2\n253 254 255\n", "p", nobody, faults);
  const auto binary =
      parse_pgm(std::string("P5\n# c\n3 2\n255\n") + std::string("\0\1\2\xFD\xFE\xFF", 6), "p",
                nobody, faults);
  ASSERT_TRUE(text && binary);
  EXPECT_EQ(text->values, binary->values);
  EXPECT_EQ(text->width, 3U);
}

TEST(Pgm, ReadsTwoBytesAValueAboveMaximum255) {
  Faults faults("p");
  const auto map = parse_pgm(std::string("P5 2 1 1000\n") + std::string("\x03\xE8\0\x07", 4), "p",
                             nobody, faults);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->values, (std::vector<std::uint16_t>{1000, 7}));
}

TEST(Pgm, RefusesWhatIsCutOffWithoutTakingMemoryForIt) {
  Faults faults("p");
  std::vector<std::string> blamed;
  const Blame blame = [&](std::string_view text) { blamed.emplace_back(text); };
  EXPECT_FALSE(parse_pgm("P5 4000 4000 255\n...", "p", blame, faults));
  EXPECT_EQ(blamed, (std::vector<std::string>{"\"p\" ends after 3 of 16000000 cells"}));
  EXPECT_FALSE(parse_pgm("P2 4000 4000 255\n1 2 3", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("P2 4294967297 1 255\n1", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("P2 2 1 255\n-1 256", "p", nobody, faults));
  EXPECT_FALSE(parse_pgm("", "p", nobody, faults));
  EXPECT_EQ(faults.count(), 4U);
}

TEST(Pgm, RefusesCellsBrighterThanWhite) {
  Faults faults("p");
  std::vector<std::string> blamed;
  const Blame blame = [&](std::string_view text) { blamed.emplace_back(text); };
  EXPECT_FALSE(parse_pgm("P5 2 1 50\n!~", "p", blame, faults));
  EXPECT_EQ(blamed,
            (std::vector<std::string>{"the cell 1 of \"p\" is 126; expected at most white, 50"}));
}

class MapFiles : public testing::Test {
 protected:
  MapFiles() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    write("m.map", kMap);
    write("m.pgm", "P2\n3 2\n255\n0 254 254\n205 254 100\n");
  }
  ~MapFiles() override { std::filesystem::remove_all(folder_); }

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

  std::filesystem::path folder_;
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
