// What a fleet manager sends along with a scene is all that a service needs of it.
#include "client/fleet/request_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/io/request_scene.h"
#include "common/io/scene_file.h"
#include "common/io/wire/scene_codec.h"
#include "common/planning/method_names.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

const fs::path kScenes = ACCORD_SOURCE_DIR "/scenes";

std::vector<std::string> names_of(const PlanRequest& request) {
  std::vector<std::string> names;
  for (const auto& [name, content] : request.attachments) names.push_back(name);
  return names;
}

// As a service reads it that has nothing but the request.
tl::expected<std::shared_ptr<const Scene>, RequestFault> read_by_service(PlanRequest request) {
  request.id = "order-1";
  RequestLimits limits;
  limits.methods = method_names();
  limits.solvers = local_solver_names();
  return load_request(request, {}, limits);
}

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

TEST(RequestFile, BringsEveryExampleSceneToTheServiceToTheBit) {
  std::size_t scenes = 0;
  for (const auto& entry : fs::directory_iterator(kScenes)) {
    if (entry.path().extension() != ".yaml") continue;
    ++scenes;
    const auto expected = load_scene(entry.path()).scene;
    ASSERT_NE(expected, nullptr) << entry.path();
    const RequestFile file = request_for_scene(entry.path());
    ASSERT_NE(file.scene, nullptr) << entry.path();
    EXPECT_TRUE(file.faults.empty());
    const auto read = read_by_service(file.request);
    ASSERT_TRUE(read) << entry.path() << ": " << read.error().field << ": " << read.error().text;
    EXPECT_EQ(encode_scene(**read), encode_scene(*expected)) << entry.path();
    EXPECT_EQ(encode_scene(*file.scene), encode_scene(*expected)) << entry.path();
  }
  EXPECT_GT(scenes, 40U);
}

TEST(RequestFile, AttachesEachFileOnceByTheNameThatTheSceneUses) {
  EXPECT_THAT(names_of(request_for_scene(kScenes / "peer-inlet.yaml").request),
              UnorderedElementsAre());
  EXPECT_THAT(names_of(request_for_scene(kScenes / "low-manipulator-04.yaml").request),
              ::testing::Each(::testing::EndsWith(".urdf")));
}

// A robot's description, its meshes and a map with its image, each in a folder of its own.
TEST(RequestFile, AttachesWhatFilesNameInTurn) {
  const testing::ScratchFolder folder;
  write(folder.path() / "robots/tool.stl",
        "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\nvertex 0 0.1 0\n"
        "endloop\nendfacet\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\nvertex 0.1 0 0\n"
        "vertex 0 0 0.1\nendloop\nendfacet\nendsolid t\n");
  write(folder.path() / "robots/arm.urdf",
        "<robot name='arm'><link name='base'/><link name='tool'><collision><geometry>"
        "<mesh filename='tool.stl'/></geometry></collision></link>"
        "<joint name='turn' type='revolute'><parent link='base'/><child link='tool'/>"
        "<axis xyz='0 0 1'/><limit lower='-1' upper='1' velocity='1'/></joint></robot>");
  const fs::path scene = folder.path() / "cell.yaml";
  write(scene,
        "accord: scene/1\nname: cell\nmodels: {arm: {urdf: robots/arm.urdf}}\n"
        "robots: [{name: a, model: arm, start: [0], goal: [0.5]}]\n");
  const RequestFile file = request_for_scene(scene);
  ASSERT_NE(file.scene, nullptr) << to_string(file.faults.front());
  EXPECT_THAT(names_of(file.request), UnorderedElementsAre("robots/arm.urdf", "robots/tool.stl"));
  const auto read = read_by_service(file.request);
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(encode_scene(**read), encode_scene(*load_scene(scene).scene));
}

TEST(RequestFile, CallsASceneWithoutANameAsItsFileIs) {
  const testing::ScratchFolder folder;
  const std::string text =
      "accord: scene/1\nenvironment: {bounds: [[-5, -5], [5, 5]]}\nmodels: {agv: {disk: 0.3, "
      "speed: 1}}\n"
      "robots: [{name: a, model: agv, start: [0, 0], goal: [1, 0]}]\n";
  for (const auto& [file, name] :
       {std::pair{"hall 4.v2.yaml", "hall 4.v2"}, std::pair{"\x01.yaml", "scene"}}) {
    const fs::path scene = folder.path() / file;
    write(scene, text);
    EXPECT_EQ(load_scene(scene).scene->name, name);
    const auto read = read_by_service(request_for_scene(scene).request);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ((*read)->name, name);
  }
}

TEST(RequestFile, IsTheSameFromTheScenesOwnFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(kScenes);
  const RequestFile here = request_for_scene("ros-floor.yaml");
  fs::current_path(before);
  const RequestFile there = request_for_scene(kScenes / "ros-floor.yaml");
  EXPECT_FALSE(here.request.attachments.empty());
  EXPECT_EQ(here.request, there.request);
}

TEST(RequestFile, SaysWhatIsWrongBeforeAnythingIsSent) {
  const testing::ScratchFolder folder;
  EXPECT_FALSE(request_for_scene(folder.path() / "none.yaml").faults.empty());
  const fs::path scene = folder.path() / "cell.yaml";
  write(scene,
        "accord: scene/1\nmodels: {arm: {urdf: arm.urdf}}\n"
        "robots: [{name: a, model: arm, start: [0], goal: [0.5]}]\n");
  const RequestFile file = request_for_scene(scene);
  EXPECT_EQ(file.scene, nullptr);
  ASSERT_FALSE(file.faults.empty());
  EXPECT_THAT(to_string(file.faults.front()), HasSubstr("arm.urdf"));
}

}  // namespace
}  // namespace accord
