// What of a request is taken in, and what its sender is told otherwise.
#include "common/io/request_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "common/io/scene_file.h"
#include "common/io/wire/request_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/words.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr std::string_view kScene = R"(accord: scene/1
clearance: 0.1
environment:
  bounds: [[-5, -5], [5, 5]]
  obstacles: [{box: [1, 1], name: rack}]
models:
  agv: {disk: 0.3, speed: 1}
  cart: {footprint: [[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]], speed: 1, turn: 2}
robots:
  - {name: agv1, model: agv, start: [-4, -4], goal: [4, -4]}
  - {name: agv2, model: agv, start: [-4, 4], goal: [4, 4]}
  - {name: cart, model: cart, start: [-4, 0, 0], goal: [4, 0, 1]}
)";

constexpr std::string_view kArmScene = R"(accord: scene/1
models: {arm: {urdf: robots/arm.urdf}}
robots: [{name: a, model: arm, start: [0, 0.5, 1, 0, 0, 0], goal: [1, 0.5, 1, 0, 0, 0]}]
)";

RequestLimits limits_of_service() {
  RequestLimits limits;
  limits.methods = {"arc", "cbs-mp"};
  limits.solvers = {"prioritized-query", "composite-prm"};
  return limits;
}

PlanRequest sound_request() {
  PlanRequest request;
  request.id = "order-1";
  request.scene_text = kScene;
  return request;
}

RequestFault fault_of(const PlanRequest& request, const fs::path& store = {},
                      const RequestLimits& limits = limits_of_service()) {
  const auto loaded = load_request(request, store, limits);
  return loaded ? RequestFault{} : loaded.error();
}

std::string read(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// All files below scenes/, as a careless sender would attach them.
std::vector<PlanRequest::Attachment> all_example_files() {
  const fs::path root = ACCORD_SOURCE_DIR "/scenes";
  std::vector<PlanRequest::Attachment> out;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    out.push_back({fs::relative(entry.path(), root).string(), read(entry.path())});
  }
  return out;
}

// ---- Taken in ----

TEST(RequestScene, IsTheOneOfItsText) {
  const auto loaded = load_request(sound_request(), {}, limits_of_service());
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ((*loaded)->name, "scene");
  EXPECT_EQ((*loaded)->robots.size(), 3U);
  EXPECT_EQ((*loaded)->robots[2].goal, (Configuration{4, 0, 1}));
}

TEST(RequestScene, IsCalledAsTheRequestSaysUnlessItsTextDoes) {
  PlanRequest request = sound_request();
  request.scene_name = "hall 4";
  EXPECT_EQ((*load_request(request, {}, limits_of_service()))->name, "hall 4");
  request.scene_text += "name: hall 5\n";
  EXPECT_EQ((*load_request(request, {}, limits_of_service()))->name, "hall 5");
}

TEST(RequestScene, IsTheSameFromAttachmentsAsFromAFolder) {
  PlanRequest request = sound_request();
  request.attachments = all_example_files();
  std::size_t scenes = 0;
  for (const auto& [name, content] : request.attachments) {
    if (!name.ends_with(".yaml") || content.find("accord: scene/1") == std::string::npos) continue;
    const SceneResult expected = load_scene(fs::path(ACCORD_SOURCE_DIR "/scenes") / name);
    ASSERT_TRUE(expected.scene) << name;
    request.scene_text = content;
    request.scene_name = fs::path(name).stem();
    const auto loaded = load_request(request, {}, limits_of_service());
    ASSERT_TRUE(loaded) << name << ": " << loaded.error().text;
    EXPECT_EQ(encode_scene(**loaded), encode_scene(*expected.scene)) << name;
    ++scenes;
  }
  EXPECT_GT(scenes, 30U);
}

TEST(RequestScene, FindsTheFilesThatItsFilesName) {
  PlanRequest request = sound_request();
  request.scene_text = R"(accord: scene/1
environment:
  bounds: [[-9, -9, -9], [9, 9, 9]]
  obstacles:
    - {mesh: meshes/../meshes/rack.obj, at: [5, 5, 0]}
    - {map: maps/floor.yaml, at: [-9, -9, -9], height: 0.1}
models: {arm: {urdf: ./robots/arm.urdf}}
robots: [{name: a, model: arm, start: [0], goal: [1]}]
)";
  const std::string rack = read(ACCORD_SOURCE_DIR "/scenes/meshes/rack.obj");
  request.attachments = {
      {"./meshes/rack.obj", rack},
      {"maps//floor.yaml", "image: img/floor.pgm\nresolution: 1\norigin: [0, 0, 0]\n"},
      {"maps/img/floor.pgm", "P2 2 1 255 255 0\n"},
      // Meshes: beside the arm, in its package's folder, and above that.
      {"robots/arm.urdf", R"(<robot name="arm">
        <link name="a"><collision><geometry><mesh filename="a.obj"/></geometry></collision></link>
        <link name="b"><collision><origin xyz="0 0 2"/>
          <geometry><mesh filename="package://p/b.obj"/></geometry></collision></link>
        <link name="c"><collision><origin xyz="0 0 4"/>
          <geometry><mesh filename="package://p/meshes/rack.obj"/></geometry></collision></link>
        <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
          <limit lower="-3" upper="3" velocity="1"/></joint>
        <joint name="k" type="fixed"><parent link="b"/><child link="c"/></joint>
      </robot>)"},
      {"robots/arm.srdf", R"(<robot name="arm"><disable_collisions link1="a" link2="c"/></robot>)"},
      {"robots/a.obj", rack},
      {"robots/b.obj", rack}};
  const auto loaded = load_request(request, {}, limits_of_service());
  ASSERT_TRUE(loaded) << loaded.error().field << ": " << loaded.error().text;
  EXPECT_EQ((*loaded)->robots[0].model->bodies.size(), 3U);
  EXPECT_TRUE((*loaded)->robots[0].model->may_touch.contains({0, 2}));
  EXPECT_EQ((*loaded)->obstacles.size(), 2U);
}

TEST(RequestScene, MayBeOneInStore) {
  PlanRequest request = sound_request();
  request.scene_text.clear();
  request.scene_name = "panda-four";
  const auto loaded = load_request(request, ACCORD_SOURCE_DIR "/scenes", limits_of_service());
  ASSERT_TRUE(loaded) << loaded.error().text;
  const auto expected = load_scene(ACCORD_SOURCE_DIR "/scenes/panda-four.yaml").scene;
  EXPECT_EQ(encode_scene(**loaded), encode_scene(*expected));
}

TEST(RequestScene, HasTheQueriesStartsAndGoals) {
  PlanRequest request = sound_request();
  request.queries = {{"cart", {}, Configuration{4, 2, -3}},
                     {"agv1", Configuration{-4, 3}, Configuration{4, 3}},
                     {"agv2", Configuration{-4, -4}, {}}};
  const auto loaded = load_request(request, {}, limits_of_service());
  ASSERT_TRUE(loaded) << loaded.error().field << ": " << loaded.error().text;
  const auto& robots = (*loaded)->robots;
  EXPECT_EQ(robots[0].start, (Configuration{-4, 3}));
  EXPECT_EQ(robots[0].goal, (Configuration{4, 3}));
  EXPECT_EQ(robots[1].start, (Configuration{-4, -4}));  // where agv1 was
  EXPECT_EQ(robots[1].goal, (Configuration{4, 4}));
  EXPECT_EQ(robots[2].start, (Configuration{-4, 0, 0}));
  EXPECT_EQ(robots[2].goal, (Configuration{4, 2, -3}));
  EXPECT_EQ(robots[0].model, robots[1].model);
}

TEST(RequestScene, MayBeAsLargeAsTheJournalTakes) {
  PlanRequest request = sound_request();
  request.scene_text.resize(limits::kSceneBytes - 1, '\n');
  request.attachments.push_back({"a", std::string(limits::kAttachmentBytes, 'x')});
  EXPECT_EQ(fault_of(request), RequestFault{});
  EXPECT_TRUE(decode_request(encode_request(request)));
  // Queries' numbers count, too.
  request.queries.assign(2'700, {"agv1", Configuration(200, 1.0), {}});
  EXPECT_EQ(fault_of(request).reason, Rejection::kTooLarge);
  EXPECT_FALSE(decode_request(encode_request(request)));
}

// ---- Refused ----

struct Case {
  std::string name;
  std::function<void(PlanRequest&)> spoil;
  Rejection reason;
  std::string field;
  std::string text;
};

void expect_faults(const std::vector<Case>& cases, const fs::path& store = {}) {
  for (const Case& one : cases) {
    PlanRequest request = sound_request();
    one.spoil(request);
    const RequestFault fault = fault_of(request, store);
    EXPECT_EQ(to_string(fault.reason), to_string(one.reason)) << one.name;
    EXPECT_EQ(fault.field, one.field) << one.name;
    EXPECT_EQ(fault.text, one.text) << one.name;
  }
}

TEST(RequestFault, IsSoundWhereNothingIsWrong) {
  EXPECT_EQ(fault_of(sound_request()), RequestFault{});
}

TEST(RequestFault, NamesTheId) {
  expect_faults({{"empty", [](PlanRequest& r) { r.id = ""; }, Rejection::kBadId, "id",
                  "expected 1 to 128 letters, digits, '-', '_', '.' and ':', not \"\""},
                 {"space", [](PlanRequest& r) { r.id = "a b"; }, Rejection::kBadId, "id",
                  "expected 1 to 128 letters, digits, '-', '_', '.' and ':', not \"a b\""}});
}

TEST(RequestFault, NamesWhatIsTooLarge) {
  expect_faults(
      {{"text", [](PlanRequest& r) { r.scene_text.resize(limits::kSceneBytes + 1); },
        Rejection::kTooLarge, "scene_text", "expected at most 4194304 bytes, not 4194305"},
       {"files", [](PlanRequest& r) { r.attachments.resize(1001); }, Rejection::kTooLarge,
        "attachments", "expected at most 1000 files, not 1001"},
       {"attached",
        [](PlanRequest& r) {
          r.attachments = {{"a", "x"}, {"b", std::string(limits::kAttachmentBytes, 'x')}};
        },
        Rejection::kTooLarge, "attachments",
        "expected at most 67108864 bytes together, not 67108865"},
       {"queries", [](PlanRequest& r) { r.queries.resize(10'001); }, Rejection::kTooLarge,
        "queries", "expected at most 10000 queries, not 10001"},
       {"solvers", [](PlanRequest& r) { r.solvers.resize(17); }, Rejection::kTooLarge, "solvers",
        "expected at most 16 solvers, not 17"}});
  RequestLimits limits = limits_of_service();
  limits.bytes = 500;
  EXPECT_THAT(fault_of(sound_request(), {}, limits).text,
              StartsWith("expected at most 500 bytes in all, not "));
  limits = limits_of_service();
  limits.robots = 2;
  EXPECT_EQ(fault_of(sound_request(), {}, limits),
            (RequestFault{Rejection::kTooLarge, "scene_text", "expected at most 2 robots, not 3"}));
}

TEST(RequestFault, NamesTheOption) {
  expect_faults({{"method", [](PlanRequest& r) { r.method = "magic"; }, Rejection::kBadOption,
                  "method", "there is no method \"magic\"; expected arc or cbs-mp"},
                 {"solver",
                  [](PlanRequest& r) {
                    r.solvers = {"composite-prm", "arc"};
                  },
                  Rejection::kBadOption, "solvers[1]",
                  "there is no solver \"arc\"; expected prioritized-query or composite-prm"},
                 {"twice",
                  [](PlanRequest& r) {
                    r.solvers = {"composite-prm", "composite-prm"};
                  },
                  Rejection::kBadOption, "solvers[1]", "\"composite-prm\" is there twice"},
                 {"past", [](PlanRequest& r) { r.deadline = -1; }, Rejection::kBadOption,
                  "deadline", "expected a number from 0 to 1e+07 s, not -1"},
                 {"nan", [](PlanRequest& r) { r.deadline = kNan; }, Rejection::kBadOption,
                  "deadline", "expected a number from 0 to 1e+07 s, not nan"},
                 {"late", [](PlanRequest& r) { r.deadline = 2e7; }, Rejection::kBadOption,
                  "deadline", "expected a number from 0 to 1e+07 s, not 2e+07"}});
}

TEST(RequestFault, NamesTheSourceOfTheScene) {
  const auto store = [](const std::string& name) {
    return [name](PlanRequest& r) {
      r.scene_text.clear();
      r.scene_name = name;
    };
  };
  expect_faults(
      {{"none", store(""), Rejection::kBadScene, "scene_text",
        "expected a scene's text, or else the name of one in store"},
       {"no name", [](PlanRequest& r) { r.scene_name = "a\tb"; }, Rejection::kBadScene,
        "scene_name",
        "expected a name of at most 200 bytes without control characters, not \"a\\x09b\""},
       {"no store", store("depot"), Rejection::kUnknownScene, "scene_name",
        "this service has no scenes in store; send the scene's text"}});
  const std::string expected =
      "expected 1 to 200 letters, digits, '-', '_' and '.', not beginning with '.', not ";
  testing::ScratchFolder folder;
  std::ofstream(folder.path() / "secret.yaml") << "secret";
  fs::create_directory(folder.path() / "store");
  fs::create_directory(folder.path() / "store" / "folder.yaml");
  expect_faults({{"climbing", store("../secret"), Rejection::kUnknownScene, "scene_name",
                  expected + "\"../secret\""},
                 {"absolute", store("/etc/passwd"), Rejection::kUnknownScene, "scene_name",
                  expected + "\"/etc/passwd\""},
                 {"unknown", store("depot"), Rejection::kUnknownScene, "scene_name",
                  "there is no scene \"depot\" in store"},
                 {"folder", store("folder"), Rejection::kUnknownScene, "scene_name",
                  "there is no scene \"folder\" in store"},
                 {"with files",
                  [&](PlanRequest& r) {
                    store("depot")(r);
                    r.attachments = {{"a", ""}};
                  },
                  Rejection::kBadScene, "attachments",
                  "a scene in store has files of its own; expected none"}},
                folder.path() / "store");
}

TEST(RequestFault, OfASceneInStoreDoesNotSayWhereTheStoreIs) {
  testing::ScratchFolder folder;
  std::ofstream(folder.path() / "depot.yaml") << "accord: scene/2\n";
  PlanRequest request = sound_request();
  request.scene_text.clear();
  request.scene_name = "depot";
  EXPECT_EQ(fault_of(request, folder.path()),
            (RequestFault{Rejection::kBadScene, "depot.yaml:1: accord",
                          "expected scene/1, not \"scene/2\""}));
}

TEST(RequestFault, NamesTheAttachment) {
  const auto named = [](const std::string& name) {
    return [name](PlanRequest& r) { r.attachments = {{"a.stl", ""}, {name, ""}}; };
  };
  const std::string below = "expected a path below the scene's folder, without \"..\", not ";
  const auto kBad = Rejection::kBadScene;
  const std::string field = "attachments[1].name";
  expect_faults(
      {{"empty", named(""), kBad, field, "expected a name of 1 to 200 bytes, not \"\""},
       {"absolute", named("/a.stl"), kBad, field, below + "\"/a.stl\""},
       {"climbing", named("b/../../a.stl"), kBad, field, below + "\"b/../../a.stl\""},
       {"inside", named("b/../c.stl"), kBad, field, below + "\"b/../c.stl\""},
       {"url", named("http://a/b.stl"), kBad, field, below + "\"http://a/b.stl\""},
       {"folder", named("b/"), kBad, field, "expected the name of a file, not \"b/\""},
       {"dot", named("."), kBad, field, "expected the name of a file, not \".\""},
       {"control", named("a\nb"), kBad, field,
        "expected UTF-8 without control characters, not \"a\\x0Ab\""},
       {"twice", named("a.stl"), kBad, field, "\"a.stl\" is the name of attachments[0] already"},
       {"twice in other words", named(".//a.stl"), kBad, field,
        "\"a.stl\" is the name of attachments[0] already"}});
}

TEST(RequestFault, SaysWhichFileIsNotAttached) {
  PlanRequest request = sound_request();
  request.scene_text = kArmScene;
  EXPECT_EQ(fault_of(request), (RequestFault{Rejection::kBadScene, "scene:2: models.arm.urdf",
                                             "\"robots/arm.urdf\" is not attached"}));
  request.attachments = {{"robots/arn.urdf", ""}};
  EXPECT_EQ(fault_of(request).text,
            "\"robots/arm.urdf\" is not attached; did you mean \"robots/arn.urdf\"?");
  request.scene_text.replace(request.scene_text.find("robots/arm"), 10, "../arm");
  EXPECT_EQ(fault_of(request).text, "\"../arm.urdf\" is not attached");
  request.scene_text.replace(request.scene_text.find("../arm.urdf"), 11, "/etc/passwd");
  EXPECT_THAT(fault_of(request).text, HasSubstr("not the absolute \"/etc/passwd\""));
}

TEST(RequestFault, StandsInTheAttachmentThatHasIt) {
  PlanRequest request = sound_request();
  request.scene_text = kArmScene;
  request.attachments = {{"robots/arm.urdf", "<robot name='a'>\n<link name='b'/>\n</robot>"}};
  const RequestFault fault = fault_of(request);
  EXPECT_EQ(fault.reason, Rejection::kBadScene);
  EXPECT_EQ(fault.field, "robots/arm.urdf:1: robot");
  EXPECT_THAT(fault.text, StartsWith("no movable joint"));
}

TEST(RequestFault, NamesTheLineOfTheScene) {
  PlanRequest request = sound_request();
  const std::size_t at = request.scene_text.find("goal: [4, -4]");
  request.scene_text.replace(at, 13, "goal: [0, 0.9]");
  EXPECT_EQ(fault_of(request),
            (RequestFault{Rejection::kBadScene, "scene:10: robots[0].goal",
                          "disk \"agv1\" would be 0.1 m from obstacle \"rack\", within the "
                          "clearance of 0.1 m; move the goal or shrink the robot"}));
}

TEST(RequestFault, NamesTheQuery) {
  const auto queries = [](std::vector<PlanRequest::Query> list) {
    return [list](PlanRequest& r) { r.queries = list; };
  };
  const auto kBad = Rejection::kBadQuery;
  expect_faults(
      {{"unknown", queries({{"agv3", Configuration{0, 3}, {}}}), kBad, "queries[0].robot",
        "unknown robot \"agv3\"; did you mean \"agv1\"?"},
       {"twice", queries({{"cart", {}, Configuration{4, 1, 0}}, {"cart", {}, Configuration{}}}),
        kBad, "queries[1].robot", "\"cart\" has queries[0] already"},
       {"neither", queries({{"cart", {}, {}}}), kBad, "queries[0]",
        "expected a start, a goal, or both"},
       {"size", queries({{"agv1", Configuration{0, 3, 0}, {}}}), kBad, "queries[0].start",
        "expected [x, y], not 3 numbers"},
       {"none", queries({{"cart", {}, Configuration{}}}), kBad, "queries[0].goal",
        "expected [x, y, heading], not 0 numbers"},
       {"nan", queries({{"agv1", {}, Configuration{0, kNan}}}), kBad, "queries[0].goal[1]",
        "expected a number from -100000 to 100000 m, not nan"},
       {"angle", queries({{"cart", {}, Configuration{0, 3, 1e9}}}), kBad, "queries[0].goal[2]",
        "expected a number from -10000 to 10000 rad, not 1e+09"},
       {"bounds", queries({{"agv1", {}, Configuration{4.9, 0}}}), kBad, "queries[0].goal",
        "disk \"agv1\" would leave the bounds by 0.2 m; move the goal or shrink the robot"},
       {"obstacle", queries({{"agv1", Configuration{0, 0.5}, {}}}), kBad, "queries[0].start",
        "disk \"agv1\" would overlap obstacle \"rack\" by 0.3 m; move the start or shrink the "
        "robot"}});
}

TEST(RequestFault, BlamesTheQueryAndNotTheRobotThatStandsThere) {
  // agv2 is the later one, but it is agv1 that has been moved.
  PlanRequest request = sound_request();
  request.queries = {{"cart", {}, Configuration{4, 1, 0}}, {"agv1", Configuration{-4, 3.5}, {}}};
  EXPECT_EQ(fault_of(request),
            (RequestFault{Rejection::kBadQuery, "queries[1].start",
                          "disk \"agv1\" would overlap disk \"agv2\" at its start by 0.1 m; move "
                          "the start or shrink the robot"}));
  // Both have been moved.
  request.queries = {{"agv2", Configuration{0, 3}, {}}, {"agv1", Configuration{0, 3.5}, {}}};
  EXPECT_EQ(fault_of(request).field, "queries[0].start");
}

TEST(RequestFault, NamesTheJointOfAQuery) {
  PlanRequest request = sound_request();
  request.scene_text.clear();
  request.scene_name = "panda-four";
  const auto scene = load_scene(ACCORD_SOURCE_DIR "/scenes/panda-four.yaml").scene;
  Configuration q = scene->robots[1].start;
  q[2] = 9;
  request.queries = {{scene->robots[1].name, q, {}}};
  const RequestFault fault = fault_of(request, ACCORD_SOURCE_DIR "/scenes");
  EXPECT_EQ(fault.field, "queries[0].start[2]");
  EXPECT_THAT(fault.text, HasSubstr(" at 9 is above its upper limit of "));
}

// ---- Said in bounds ----

TEST(RequestFault, ShowsTheFirstFiveAndCountsTheOthers) {
  PlanRequest request = sound_request();
  for (int i = 0; i < 8; ++i) request.queries.push_back({"x" + std::to_string(i), {}, {}});
  EXPECT_EQ(fault_of(request).text,
            "unknown robot \"x0\"; also queries[1].robot: unknown robot \"x1\"; also "
            "queries[2].robot: unknown robot \"x2\"; also queries[3].robot: unknown robot \"x3\"; "
            "also queries[4].robot: unknown robot \"x4\"; and 3 more faults");
  request.queries.resize(6);
  EXPECT_THAT(fault_of(request).text, EndsWith("\"x4\"; and 1 more fault"));
}

TEST(RequestFault, IsNeverLongerThanItMayBe) {
  const std::string long_text(2'000, 'x');
  const std::string umlauts = [] {
    std::string out;
    for (int i = 0; i < 1'000; ++i) out += "\xc3\xa4";
    return out;
  }();
  for (const std::string& text : {long_text, umlauts, umlauts + "\xff", std::string(2'000, '\x01'),
                                  std::string(899, 'x') + "\xc3\xa4", "x" + umlauts}) {
    for (const std::size_t count : {1U, 2U, 9U}) {
      const RequestFault fault = request_fault(
          Rejection::kBadScene, std::vector<Diagnostic>(count, {text, 3, text, text}));
      EXPECT_LE(fault.text.size(), limits::kFaultTextBytes);
      EXPECT_LE(fault.field.size(), limits::kFaultFieldBytes);
      EXPECT_GT(fault.text.size(), 800U);
      EXPECT_EQ(first_unprintable(fault.text), std::string::npos);
      EXPECT_EQ(first_unprintable(fault.field), std::string::npos);
      if (count > 1) {
        EXPECT_THAT(fault.text, HasSubstr(" more fault"));
      }
    }
  }
}

TEST(RequestFault, OfTenThousandUnknownRobotsIsFoundSoon) {
  PlanRequest request = sound_request();
  request.scene_text.clear();
  request.scene_name = "fleet-1000";
  for (int i = 0; i < 10'000; ++i) {
    request.queries.push_back({"robot-number-" + std::to_string(i), Configuration{0, 0}, {}});
  }
  const RequestFault fault = fault_of(request, ACCORD_SOURCE_DIR "/scenes");
  EXPECT_EQ(fault.field, "queries[0].robot");
  EXPECT_THAT(fault.text, EndsWith("; and 196 more faults"));
}

}  // namespace
}  // namespace accord
