// Each scene in this folder has one kind of fault, which its name says, and says itself what must
// be reported of it, all of it and nothing else:
//
//     # expect: 6: robots[0].speeed: unknown key in a robot; did you mean "speed"?
//     # expect: files/mimic.urdf:9: joint[elbow].mimic: ...
//
// The first form is about the scene's own lines. What the scenes name lies in files/.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "common/io/scene_file.h"

namespace accord {
namespace {

const std::string kFolder = ACCORD_SOURCE_DIR "/tests/invalid/";

std::vector<std::string> invalid_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> expectations(const std::string& path) {
  constexpr std::string_view kMark = "# expect: ";
  std::vector<std::string> out;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(kMark)) out.push_back(line.substr(kMark.size()));
  }
  return out;
}

std::string without_all(std::string text, const std::string& part) {
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part)) {
    text.erase(at, part.size());
  }
  return text;
}

// As the expectations have it: no folder, no name of the scene itself.
std::vector<std::string> reports(const std::vector<Diagnostic>& faults, const std::string& name) {
  std::vector<std::string> out;
  for (const Diagnostic& fault : faults) {
    std::string text = without_all(to_string(fault), kFolder);
    const std::string own = name + ".yaml:";
    if (text.starts_with(own)) text = text.substr(own.size() + (text[own.size()] == ' ' ? 1 : 0));
    out.push_back(text);
  }
  return out;
}

class InvalidScene : public testing::TestWithParam<std::string> {};

TEST_P(InvalidScene, IsReportedInFull) {
  const std::string path = kFolder + GetParam() + ".yaml";
  const std::vector<std::string> expected = expectations(path);
  ASSERT_FALSE(expected.empty()) << path << " does not say what to expect";
  const SceneResult result = load_scene(path);
  EXPECT_EQ(result.scene, nullptr);
  EXPECT_EQ(reports(result.faults, GetParam()), expected);
}

INSTANTIATE_TEST_SUITE_P(All, InvalidScene, testing::ValuesIn(invalid_scenes()),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(InvalidScenes, CoverAtLeastFiftyFaults) {
  EXPECT_GE(invalid_scenes().size(), 50U);
}

}  // namespace
}  // namespace accord
