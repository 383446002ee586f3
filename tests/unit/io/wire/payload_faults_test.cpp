// What is wrong with a payload is said in a sentence that names the field.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "accord.pb.h"
#include "common/io/limits.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/request_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "tests/unit/io/wire/wire_samples.h"

namespace accord {
namespace {

using namespace wire_samples;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Message>
struct Case {
  std::string name;
  std::function<void(Message&)> spoil;
  std::string fault;
};

std::string fault_of_scene(const std::string& example,
                           const std::function<void(payload::Scene&)>& spoil) {
  const auto scene = example.empty() ? small_scene() : load_example(example);
  const Bytes bytes = encode_scene(*scene);
  payload::Scene message;
  EXPECT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
  spoil(message);
  const auto decoded = decode_scene(serialize_payload(message));
  return decoded ? "" : decoded.error();
}

TEST(PayloadFault, OfASceneNamesTheField) {
  using payload::Scene;
  const std::vector<Case<Scene>> cases{
      {"timestep", [](Scene& s) { s.set_timestep(0); },
       "timestep: expected 1e-06 to 1000 s, not 0"},
      {"nan", [](Scene& s) { s.set_clearance(kNan); },
       "clearance: expected 0 to 100000 m, not nan"},
      {"bounds", [](Scene& s) { s.mutable_bounds()->RemoveLast(); },
       "bounds: expected 6 numbers, not 5"},
      {"no bounds", [](Scene& s) { s.clear_bounds(); }, "bounds: planar scenes have some"},
      {"swapped", [](Scene& s) { s.set_bounds(0, 9); },
       "bounds: the first corner must be less than the second"},
      {"no robots", [](Scene& s) { s.clear_robots(); }, "robots: expected 1 to 10000, not 0"},
      {"model", [](Scene& s) { s.mutable_robots(2)->set_model(2); },
       "robots[2].model: there is no model 2; there are 2, from 0"},
      {"name", [](Scene& s) { s.mutable_robots(1)->set_name("a"); },
       "robots[1].name: another robot has it"},
      {"no name", [](Scene& s) { s.mutable_robots(1)->clear_name(); },
       "robots[1].name: expected a name of 1 to 200 bytes, not 0"},
      {"dimensions", [](Scene& s) { s.mutable_robots(0)->add_start(1); },
       "robots[0].start: expected 2 numbers, not 3"},
      {"infinite goal", [](Scene& s) { s.mutable_robots(0)->set_goal(1, kInfinity); },
       "robots[0].goal[1]: expected -100000 to 100000 m, not inf"},
      {"base", [](Scene& s) { s.mutable_robots(0)->set_base(3, 1); },
       "robots[0].base: only arms have a base to place"},
      {"mirror", [](Scene& s) { s.mutable_obstacles(0)->set_pose(0, -1); },
       "obstacles[0].pose: its first three columns must be a rotation"},
      {"size", [](Scene& s) { s.mutable_obstacles(1)->mutable_shape()->set_sphere(-1); },
       "obstacles[1].shape.sphere: expected 1e-05 to 100000 m, not -1"},
      {"no shape", [](Scene& s) { s.mutable_obstacles(1)->clear_shape(); },
       "obstacles[1].shape: expected a shape"},
      {"out of plane", [](Scene& s) { s.mutable_obstacles(1)->set_pose(11, 1); },
       "obstacles[1]: does not meet the plane z = 0"},
      {"mesh", [](Scene& s) { s.mutable_obstacles(1)->mutable_shape()->set_mesh(0); },
       "obstacles[1].shape: meshes are for spatial scenes"},
      {"clockwise",
       [](Scene& s) {
         auto& p = *s.mutable_obstacles(2)->mutable_shape()->mutable_polygon()->mutable_value();
         p.SwapElements(0, 2);
         p.SwapElements(1, 3);
       },
       "obstacles[2].shape.polygon: expected counter-clockwise"},
      {"kind", [](Scene& s) { s.mutable_models(0)->set_kind(payload::Model::Kind(7)); },
       "models[0].kind: there is no kind 7; there are 4, from 0"},
      {"ball", [](Scene& s) { s.mutable_models(0)->set_kind(payload::Model::BALL); },
       "models[0].kind: discs and footprints are for planar scenes, balls for others"},
      {"speed", [](Scene& s) { s.mutable_models(0)->set_speed(kInfinity); },
       "models[0].speed: expected 1e-06 to 100000, not inf"},
      {"limits", [](Scene& s) { s.mutable_models(0)->mutable_dofs(1)->set_lower(0); },
       "models[0].dofs[1]: expected no limits"},
  };
  for (const auto& one : cases) EXPECT_EQ(fault_of_scene("", one.spoil), one.fault) << one.name;
}

TEST(PayloadFault, OfAnArmNamesTheField) {
  using payload::Scene;
  const std::vector<Case<Scene>> cases{
      {"cycle",
       [](Scene& s) {
         auto& joints = *s.mutable_models(0)->mutable_joints();
         joints.SwapElements(0, joints.size() - 1);
       },
       "models[0].joints[0]: expected a tree of links, parents before children"},
      {"link", [](Scene& s) { s.mutable_models(0)->mutable_joints(0)->set_child(99); },
       "models[0].joints[0].child: there is no link 99; there are "},
      {"axis", [](Scene& s) { s.mutable_models(0)->mutable_joints(0)->set_axis(0, 1.5); },
       "models[0].joints[0].axis: expected a direction of length 1, not "},
      {"dof",
       [](Scene& s) {
         for (auto& joint : *s.mutable_models(0)->mutable_joints()) {
           if (joint.dof() > 0) joint.set_dof(1);
         }
       },
       "models[0].joints[1].dof: another joint moves it"},
      {"body", [](Scene& s) { s.mutable_models(0)->mutable_bodies(0)->set_link(1000); },
       "models[0].bodies[0].link: there is no link 1000; there are "},
      {"neighbours", [](Scene& s) { s.mutable_models(0)->clear_may_touch(); },
       "models[0].may_touch: expected all neighbours"},
      {"odd", [](Scene& s) { s.mutable_models(0)->mutable_may_touch()->RemoveLast(); },
       "models[0].may_touch: expected pairs of links"},
      {"beyond limit",
       [](Scene& s) { s.mutable_robots(0)->set_start(0, s.models(0).dofs(0).upper() + 1); },
       "robots[0].start[0]: expected "},
  };
  for (const auto& one : cases) {
    const std::string fault = fault_of_scene("panda-four.yaml", one.spoil);
    EXPECT_TRUE(fault.starts_with(one.fault)) << one.name << ": " << fault;
  }
}

TEST(PayloadFault, OfAMeshNamesTheField) {
  using payload::Scene;
  const std::vector<Case<Scene>> cases{
      {"vertex", [](Scene& s) { s.mutable_meshes(0)->set_triangles(4, 1'000'000); },
       "meshes[0].triangles[4]: there is no vertex 1000000; there are "},
      {"flat",
       [](Scene& s) {
         auto& mesh = *s.mutable_meshes(0);
         mesh.set_triangles(0, mesh.triangles(1));
       },
       "meshes[0].triangles[0]: a triangle without an area"},
      {"corners", [](Scene& s) { s.mutable_meshes(0)->add_triangles(0); },
       "meshes[0].triangles: expected three corners each"},
      {"nan", [](Scene& s) { s.mutable_meshes(0)->set_vertices(1, kNan); },
       "meshes[0].vertices[1]: expected -100000 to 100000 m, not nan"},
  };
  for (const auto& one : cases) {
    const std::string fault = fault_of_scene("rack-drones.yaml", one.spoil);
    EXPECT_TRUE(fault.starts_with(one.fault)) << one.name << ": " << fault;
  }
}

TEST(PayloadFault, OfAFieldFromAnotherVersionSaysSo) {
  const auto scene = small_scene();
  Bytes bytes = encode_scene(*scene);
  bytes.insert(bytes.end(), {0x78, 1});  // field 15, a number
  const auto decoded = decode_scene(bytes);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), "Scene has no field 15 in this version of Accord");
}

TEST(PayloadFault, OfASubproblemNamesTheField) {
  const auto scene = load_example("mixed-floor.yaml");
  RandomStream random(21);
  Subproblem sound;
  while (sound.tasks.size() < 2 || sound.outsiders.size() < 2 || sound.tasks[0].guide.size() < 2) {
    sound = random_subproblem(random, *scene);
  }
  const std::vector<Case<Subproblem>> cases{
      {"from", [](Subproblem& s) { s.from = -1; }, "from: expected 0 to 1e+09 s, not -1"},
      {"horizon", [](Subproblem& s) { s.horizon = kNan; }, "horizon: expected "},
      {"no task", [](Subproblem& s) { s.tasks.clear(); }, "tasks: expected 1 to "},
      {"order", [](Subproblem& s) { std::swap(s.tasks[0], s.tasks[1]); },
       "tasks[1].robot: expected robots in ascending order"},
      {"robot", [](Subproblem& s) { s.tasks.back().robot.value = 5000; }, "tasks["},
      {"both", [](Subproblem& s) { s.outsiders[0].robot = s.tasks[0].robot; },
       "outsiders[0].robot: the robot has a task"},
      {"start", [](Subproblem& s) { s.tasks[0].start.pop_back(); }, "tasks[0].start: expected "},
      {"region", [](Subproblem& s) { std::swap(s.tasks[0].region.lower, s.tasks[0].region.upper); },
       "tasks[0].upper[0]: expected "},
      {"wide", [](Subproblem& s) { s.tasks[0].region.upper[0] += 1; },
       "tasks[0].upper[0]: expected "},
      {"no guide", [](Subproblem& s) { s.tasks[0].guide = {}; }, "tasks[0].guide: expected a path"},
      {"level", [](Subproblem& s) { s.tasks[0].roadmap_level = 5; },
       "tasks[0].roadmap_levels: expected 0 to 5, not 6"},
      {"limit", [](Subproblem& s) { s.limits.composite_nodes = 2'000'000'000; },
       "limits.composite_nodes: expected 0 to 1000000000, not 2000000000"},
  };
  for (const auto& one : cases) {
    Subproblem spoilt = sound;
    one.spoil(spoilt);
    const auto decoded = decode_subproblem(encode_subproblem(spoilt), *scene);
    ASSERT_FALSE(decoded) << one.name;
    EXPECT_TRUE(decoded.error().starts_with(one.fault)) << one.name << ": " << decoded.error();
  }
}

TEST(PayloadFault, OfARequestNamesTheField) {
  PlanRequest sound;
  sound.id = "fleet-7:order.12";
  sound.attachments = {{"arm6.urdf", "<robot/>"}, {"meshes/rack.stl", ""}};
  sound.queries = {{"a", Configuration{1, 2}, {}}, {"b", {}, Configuration{3, 4}}};
  sound.solvers = {"prioritized-query", "composite-prm"};
  ASSERT_TRUE(decode_request(encode_request(sound)));
  using Request = PlanRequest;
  const std::vector<Case<Request>> cases{
      {"no id", [](Request& r) { r.id.clear(); },
       "id: expected 1 to 128 letters, digits, '-', '_', '.' and ':', not \"\""},
      {"path", [](Request& r) { r.id = "../a"; }, "id: expected "},
      {"long id", [](Request& r) { r.id = std::string(129, 'a'); }, "id: expected "},
      {"scene", [](Request& r) { r.scene_text.resize(limits::kSceneBytes + 1); },
       "scene_text: expected 0 to 4194304 bytes, not 4194305"},
      {"scene name", [](Request& r) { r.scene_name = "a\n"; },
       "scene_name: expected UTF-8 without control characters, not \"a\\x0A\""},
      {"attachment", [](Request& r) { r.attachments[1].name.clear(); },
       "attachments[1].name: expected a name of 1 to 200 bytes, not 0"},
      {"attachments",
       [](Request& r) {
         r.attachments.resize(1001, {"a", ""});
       },
       "attachments: expected 0 to 1000, not 1001"},
      {"large", [](Request& r) { r.attachments[0].content.resize(limits::kAttachmentBytes + 1); },
       "attachments: expected 0 to 67108864 bytes together, not 67108865"},
      {"robot", [](Request& r) { r.queries[1].robot.clear(); },
       "queries[1].robot: expected a name of 1 to 200 bytes, not 0"},
      {"no numbers", [](Request& r) { r.queries[0].start = Configuration{}; },
       "queries[0].start: expected 1 to 200 numbers, not 0"},
      {"nan", [](Request& r) { (*r.queries[1].goal)[1] = kNan; },
       "queries[1].goal[1]: expected -1e+07 to 1e+07, not nan"},
      {"queries",
       [](Request& r) {
         r.queries.resize(10'001, {"a", {}, {}});
       },
       "queries: expected 0 to 10000, not 10001"},
      {"method", [](Request& r) { r.method.clear(); },
       "method: expected a name of 1 to 64 bytes, not 0"},
      {"solver", [](Request& r) { r.solvers[1] = "\xff"; }, "solvers[1]: expected UTF-8 "},
      {"solvers", [](Request& r) { r.solvers.resize(17, "a"); },
       "solvers: expected 0 to 16 names, not 17"},
      {"deadline", [](Request& r) { r.deadline = -1; }, "deadline: expected 0 to 1e+07 s, not -1"},
      {"never", [](Request& r) { r.deadline = kInfinity; },
       "deadline: expected 0 to 1e+07 s, not inf"},
      {"too large", [](Request& r) { r.attachments[0].content.resize(limits::kRequestBytes); },
       "a request of "},
  };
  for (const auto& one : cases) {
    Request spoilt = sound;
    one.spoil(spoilt);
    const auto decoded = decode_request(encode_request(spoilt));
    ASSERT_FALSE(decoded) << one.name;
    EXPECT_TRUE(decoded.error().starts_with(one.fault)) << one.name << ": " << decoded.error();
  }
}

TEST(PayloadFault, OfTimesThatDoNotIncreaseNamesTheWaypoint) {
  const auto scene = small_scene();
  RandomStream random(1);
  const Bytes bytes = encode_subproblem(random_subproblem(random, *scene));
  payload::Subproblem message;
  ASSERT_TRUE(message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())));
  auto& guide = *message.mutable_tasks(0)->mutable_guide();
  guide.add_times(guide.times(guide.times_size() - 1));
  for (std::uint32_t k = 0; k < guide.dof(); ++k) guide.add_configurations(0);
  const auto decoded = decode_subproblem(serialize_payload(message), *scene);
  ASSERT_FALSE(decoded);
  const std::string last = std::to_string(guide.times_size() - 1);
  EXPECT_TRUE(decoded.error().starts_with("tasks[0].guide.times[" + last + "]: expected later"))
      << decoded.error();
}

}  // namespace
}  // namespace accord
