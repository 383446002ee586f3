#include "common/io/urdf.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "common/io/srdf.h"

namespace accord {
namespace {

std::string link(const std::string& name, const std::string& geometry = "<sphere radius='0.1'/>") {
  return "<link name='" + name + "'><collision><geometry>" + geometry +
         "</geometry></collision></link>\n";
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& type = "revolute") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><axis xyz='0 0 2'/>" +
         (type == "fixed" ? "" : "<limit lower='-1' upper='2' velocity='3'/>") + "</joint>\n";
}

RobotModel model_of(const std::string& body) {
  MeshStore meshes;
  Faults faults("a.urdf");
  const auto urdf = parse_urdf("<robot name='a'>\n" + body + "</robot>", "a.urdf", meshes, faults);
  for (const Diagnostic& fault : faults.take()) ADD_FAILURE() << to_string(fault);
  return urdf ? urdf->model : RobotModel{};
}

using Pairs = std::set<std::pair<int, int>>;

TEST(Urdf, OrdersDegreesOfFreedomAsTheDocumentAndJointsParentsFirst) {
  const RobotModel model =
      model_of(link("tip") + link("middle") + link("root") + joint("second", "middle", "tip") +
               joint("first", "root", "middle"));
  ASSERT_EQ(model.dofs.size(), 2U);
  EXPECT_EQ(model.dofs[0].name, "second");
  EXPECT_EQ(model.dofs[1].name, "first");
  EXPECT_EQ(model.links.front(), "root");
  ASSERT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(model.joints[0].name, "first");
  EXPECT_EQ(model.joints[0].dof, 1);
  EXPECT_EQ(model.joints[0].parent, 0);
  EXPECT_EQ(model.joints[1].dof, 0);
  EXPECT_EQ(model.links[static_cast<std::size_t>(model.joints[1].child)], "tip");
  EXPECT_EQ(model.joints[0].axis, Vec3(0, 0, 1));  // normalised
  for (const Body& body : model.bodies) {
    EXPECT_EQ(model.links[static_cast<std::size_t>(body.link)], body.name);
  }
}

TEST(Urdf, ReadsEveryKindOfJoint) {
  const RobotModel model =
      model_of(link("a") + link("b") + link("c") + link("d") + link("e") +
               joint("ab", "a", "b", "continuous") + joint("bc", "b", "c", "prismatic") +
               joint("cd", "c", "d", "fixed") + joint("de", "d", "e", "revolute"));
  ASSERT_EQ(model.dofs.size(), 3U);
  EXPECT_TRUE(model.dofs[0].wraps);
  EXPECT_EQ(model.dofs[0].lower, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(model.joints[1].type, JointType::kPrismatic);
  EXPECT_FALSE(model.dofs[1].wraps);
  EXPECT_EQ(model.dofs[1].lower, -1);
  EXPECT_EQ(model.dofs[1].upper, 2);
  EXPECT_EQ(model.dofs[1].velocity, 3);
  EXPECT_EQ(model.joints[2].dof, -1);
  EXPECT_EQ(model.joints[3].dof, 2);
}

TEST(Urdf, ReadsEveryShape) {
  const RobotModel model =
      model_of(link("a", "<box size='1 2 3'/>") + link("b", "<cylinder radius='1' length='2'/>") +
               link("c", "<capsule radius='1' length='2'/>") + joint("ab", "a", "b") +
               joint("bc", "b", "c"));
  ASSERT_EQ(model.bodies.size(), 3U);
  EXPECT_EQ(std::get<Box>(model.bodies[0].shape).size, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<Cylinder>(model.bodies[1].shape).length, 2);
  EXPECT_EQ(std::get<Capsule>(model.bodies[2].shape).length, 2);
}

TEST(Urdf, PlacesBodiesByRollPitchYaw) {
  const RobotModel model =
      model_of(link("a") +
               "<link name='b'><collision><origin xyz='1 2 3' rpy='0.1 0.2 0.3'/>"
               "<geometry><sphere radius='1'/></geometry></collision></link>" +
               joint("ab", "a", "b"));
  const Pose expected = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Vec3::UnitZ()) *
                        Eigen::AngleAxisd(0.2, Vec3::UnitY()) *
                        Eigen::AngleAxisd(0.1, Vec3::UnitX());
  EXPECT_TRUE(model.bodies[1].pose.isApprox(expected, 1e-14));
}

TEST(Urdf, LetsNeighboursTouchAcrossFixedJoints) {
  // a =fixed= b -moves- c =fixed= d -moves- e
  const RobotModel model = model_of(link("a") + link("b") + link("c") + link("d") + link("e") +
                                    joint("ab", "a", "b", "fixed") + joint("bc", "b", "c") +
                                    joint("cd", "c", "d", "fixed") + joint("de", "d", "e"));
  EXPECT_EQ(model.may_touch,
            (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 4}}));
}

TEST(Urdf, ReportsEveryFaultAtOnce) {
  MeshStore meshes;
  Faults faults("a.urdf");
  EXPECT_FALSE(parse_urdf("<robot name='a'>\n" + link("a", "<box size='1 2'/>") +
                              link("b", "<sphere radius='nan'/>") +
                              joint("ab", "a", "c", "revolut") + "</robot>",
                          "a.urdf", meshes, faults));
  const auto list = faults.take();
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0].line, 2);
  EXPECT_EQ(list[1].line, 3);
  EXPECT_EQ(list[2].line, 4);
  EXPECT_EQ(list[3].line, 4);
}

TEST(Urdf, SaysWhichNumbersItExpects) {
  const auto text = [](const std::string& size) {
    MeshStore meshes;
    Faults faults("a.urdf");
    parse_urdf("<robot name='a'>" + link("a", "<box size='" + size + "'/>") + "</robot>", "a.urdf",
               meshes, faults);
    const auto list = faults.take();
    return list.empty() ? "" : list[0].text;
  };
  EXPECT_EQ(text("1 2 0"), "expected three numbers greater than 0, not \"1 2 0\"");
  EXPECT_EQ(text("1 2 1e9"), "expected three numbers from 1e-05 to 100000 m, not \"1 2 1e9\"");
  EXPECT_EQ(text("1 2 3 4"), "expected three finite numbers, not \"1 2 3 4\"");
  EXPECT_EQ(text("1 2 nan"), "expected three numbers greater than 0, not \"1 2 nan\"");
}

TEST(Urdf, BlamesTheScaleOfAMeshForItsSize) {
  const std::string folder = ACCORD_SOURCE_DIR "/tests/invalid/files/";
  MeshStore meshes;
  Faults faults("a.urdf");
  const auto with = [](const std::string& attributes) {
    return "<mesh filename='" + attributes + "/>";
  };
  EXPECT_FALSE(parse_urdf("<robot name='a'>\n" +
                              link("a", with("tetrahedron.obj' scale='1e-9 1e-9 1e-9'")) +
                              link("b", with("flat.obj'")) + joint("ab", "a", "b") + "</robot>",
                          folder + "a.urdf", meshes, faults));
  const auto list = faults.take();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].line, 2);
  EXPECT_EQ(list[0].key, "link[a].collision[0].geometry.mesh.scale");
  EXPECT_EQ(list[1].line, 3);
  EXPECT_EQ(list[1].key, "link[b].collision[0].geometry.mesh");
  EXPECT_EQ(list[1].text, "\"" + folder + "flat.obj\" has no triangle with an area");
}

TEST(Urdf, PassesOverExtensions) {
  model_of("<material name='m'/><gazebo reference='a'><static>1</static></gazebo>\n" + link("a") +
           link("b") + joint("ab", "a", "b") + "<ros2_control name='x'/>");
}

TEST(Srdf, AddsPairsInEitherOrder) {
  RobotModel model =
      model_of(link("a") + link("b") + link("c") + link("d") + joint("ab", "a", "b") +
               joint("bc", "b", "c") + joint("cd", "c", "d"));
  Faults faults("a.srdf");
  apply_srdf(
      "<robot><group name='g'/><disable_collisions link1='d' link2='a' reason='Never'/></robot>",
      "a.srdf", model, faults);
  EXPECT_EQ(faults.count(), 0U);
  EXPECT_EQ(model.may_touch, (Pairs{{0, 1}, {0, 3}, {1, 2}, {2, 3}}));
}

}  // namespace
}  // namespace accord
