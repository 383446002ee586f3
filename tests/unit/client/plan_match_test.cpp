#include "client/plan_match.h"

#include <gtest/gtest.h>

#include "tests/unit/planning/verifier_scenes.h"

namespace accord {
namespace {

class PlanMatch : public testing::Test {
 protected:
  const std::shared_ptr<Scene> scene_ = hall();
  Plan plan_ = hall_plan(*scene_);
};

TEST_F(PlanMatch, IsSilentAboutThePlanOfItsScene) {
  EXPECT_EQ(other_scene(*scene_, plan_), std::nullopt);
  EXPECT_EQ(other_robots(*scene_, plan_), std::nullopt);
}

TEST_F(PlanMatch, NamesBothScenes) {
  plan_.scene = "yard";
  EXPECT_EQ(other_scene(*scene_, plan_), "the plan was made for scene \"yard\"; this is \"hall\"");
}

TEST_F(PlanMatch, NamesARobotThatThePlanLeavesOut) {
  plan_.robots.pop_back();
  EXPECT_EQ(other_robots(*scene_, plan_), "it has no robot \"below\"");
  plan_.robots.clear();
  EXPECT_EQ(other_robots(*scene_, plan_), "it has no robot \"left\"");
}

TEST_F(PlanMatch, NamesARobotThatTheSceneDoesNotKnow) {
  plan_.robots.push_back(plan_.robots[0]);
  plan_.robots.back().name = "ghost";
  EXPECT_EQ(other_robots(*scene_, plan_), "the scene has no robot \"ghost\"");
}

TEST_F(PlanMatch, NamesARobotOfAnotherKind) {
  plan_.robots[1].trajectory = path({{0, {1, 2, 3}}});
  EXPECT_EQ(other_robots(*scene_, plan_),
            "it moves robot \"below\" in 3 numbers; the scene has 2 degrees of freedom for it");
}

TEST_F(PlanMatch, AsksNoPathsOfAPlanThatIsNotSolved) {
  plan_.status = PlanStatus::kTimeout;
  plan_.robots.clear();
  EXPECT_EQ(other_robots(*scene_, plan_), std::nullopt);
}

}  // namespace
}  // namespace accord
