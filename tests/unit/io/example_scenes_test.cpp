// Every example scene is sound: the README, the benchmarks and the system tests stand on them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "common/io/scene_file.h"

namespace accord {
namespace {

// ROS maps end in .yaml too; scenes say what they are.
bool is_scene(const std::filesystem::path& path) {
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("accord:")) return true;
  }
  return false;
}

std::vector<std::string> example_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ACCORD_SOURCE_DIR "/scenes")) {
    const auto& path = entry.path();
    if (path.extension() == ".yaml" && is_scene(path)) names.push_back(path.filename().string());
  }
  std::ranges::sort(names);
  return names;
}

class ExampleScene : public testing::TestWithParam<std::string> {};

TEST_P(ExampleScene, LoadsWithoutFaults) {
  const SceneResult result = load_scene(ACCORD_SOURCE_DIR "/scenes/" + GetParam());
  for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
  ASSERT_NE(result.scene, nullptr);
  EXPECT_EQ(result.scene->name + ".yaml", GetParam());
  EXPECT_FALSE(result.scene->robots.empty());
}

INSTANTIATE_TEST_SUITE_P(All, ExampleScene, testing::ValuesIn(example_scenes()),
                         [](const auto& param_info) {
                           std::string name =
                               param_info.param.substr(0, param_info.param.size() - 5);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace accord
