#include "client/render/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Picture, OfASceneAloneHasNoPaths) {
  const std::string svg = draw(*hall(), nullptr);
  EXPECT_THAT(svg, HasSubstr(">hall</text>"));
  EXPECT_THAT(svg, HasSubstr("2 robots"));
  EXPECT_THAT(svg, Not(HasSubstr("stroke-linejoin")));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
}

TEST(Picture, OfAPlanShowsItsCosts) {
  const auto scene = hall();
  const Plan plan = hall_plan(*scene);
  const std::string svg = draw(*scene, &plan);
  EXPECT_THAT(svg, HasSubstr("makespan 8.0 s"));
  EXPECT_THAT(svg, HasSubstr("stroke-linejoin"));
}

TEST(Picture, LeavesOutPathsThatDoNotFitTheScene) {
  const auto scene = hall();
  Plan plan = hall_plan(*scene);
  plan.robots[0].name = "ghost";
  plan.robots[1].trajectory = path({{0, {1, 2, 3}}});
  EXPECT_THAT(draw(*scene, &plan), Not(HasSubstr("stroke-linejoin")));
}

// Where robots change places, starts once hid all goals.
TEST(Picture, ShowsGoalsAboveTheStartsOfOthers) {
  const auto scene = hall();
  scene->robots[0].goal = scene->robots[1].start;
  const std::string svg = draw(*scene, nullptr);
  const std::string outlined = "<g fill=\"none\" stroke=\"#";
  EXPECT_GT(svg.find(outlined), svg.rfind("fill-opacity=\"0.88\"")) << "outlines come last";
}

TEST(Picture, NamesOneOfRobotsThatAreInThePlaceOfOneAnother) {
  auto scene = std::make_shared<Scene>();
  auto ball = std::make_shared<RobotModel>();
  ball->kind = RobotKind::kBall;
  ball->dofs.resize(3);
  ball->links = {"body"};
  ball->bodies.push_back({"body", 0, Sphere{0.5}, Pose::Identity()});
  scene->robots.push_back(robot("low", ball, {0, 0, 1}, {3, 2, 1}));
  scene->robots.push_back(robot("high", ball, {0, 0, 3}, {3, 2, 3}));
  const std::string svg = draw(*scene, nullptr);
  const std::string above = svg.substr(0, svg.find("from above"));
  EXPECT_THAT(above, HasSubstr(">high<"));
  EXPECT_THAT(above, Not(HasSubstr(">low<")));
  EXPECT_THAT(svg, HasSubstr(">low<")) << "from the side they are apart";
}

TEST(Picture, OfASpatialSceneHasTwoViews) {
  auto scene = std::make_shared<Scene>();
  scene->name = "a ball";
  auto ball = std::make_shared<RobotModel>();
  ball->kind = RobotKind::kBall;
  ball->dofs.resize(3);
  ball->links = {"body"};
  ball->bodies.push_back({"body", 0, Sphere{0.5}, Pose::Identity()});
  scene->robots.push_back(robot("b", ball, {0, 0, 1}, {3, 2, 1}));
  const std::string svg = draw(*scene, nullptr);
  EXPECT_THAT(svg, HasSubstr("from above"));
  EXPECT_THAT(svg, HasSubstr("from the side"));
}

TEST(Picture, OfAnEmptySceneIsStillOne) {
  EXPECT_THAT(draw(Scene{}, nullptr), HasSubstr("0 robots"));
}

}  // namespace
}  // namespace accord
