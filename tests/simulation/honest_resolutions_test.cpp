// What honest workers return is never refused: every resolution of every scene of scenes/.
//
// ACCORD_SEEDS: how many seeds of each scene; 1 unless told. What the checks cost, next to what
// solving did, is a property of each test in the XML report (--gtest_output=xml).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "client/engine/local_crew.h"
#include "coordinator/arc.h"
#include "coordinator/foreman.h"
#include "coordinator/whole_problem.h"
#include "tests/support/checked_workforce.h"
#include "tests/support/planned_paths.h"

namespace accord {
namespace {

std::uint64_t seeds() {
  const char* told = std::getenv("ACCORD_SEEDS");
  return told != nullptr ? std::strtoull(told, nullptr, 10) : 1;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ACCORD_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

template <class MethodType>
void expect_no_faults(const std::string& scene_name, const std::vector<std::string>& solvers,
                      std::uint64_t seed) {
  const auto scene = testing::example_scene(scene_name);
  ASSERT_NE(scene, nullptr);
  const CollisionWorld planning(scene, kPlanningMargin), detection(scene, kDetectionMargin);
  const std::atomic<bool> stop{false};
  Foreman workforce(std::make_unique<LocalCrew>(planning, 1), solvers);
  testing::CheckedWorkforce checked(scene, workforce);
  MethodType method(planning, detection, seed, checked, stop, {});
  EXPECT_EQ(method.run().status, PlanStatus::kSolved);
  EXPECT_THAT(checked.faults, ::testing::IsEmpty()) << scene_name << ", seed " << seed;
  EXPECT_GT(checked.solved, 0U);
  const double checks = std::chrono::duration<double>(checked.spent_on_checks).count();
  const double solving = std::chrono::duration<double>(checked.spent_on_solving).count();
  ::testing::Test::RecordProperty("resolutions", std::to_string(checked.solved));
  ::testing::Test::RecordProperty("seconds_of_checks", std::to_string(checks));
  ::testing::Test::RecordProperty("seconds_of_solving", std::to_string(solving));
}

class HonestResolutions : public ::testing::TestWithParam<std::string> {};

TEST_P(HonestResolutions, AreNotRefused) {
  for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
    expect_no_faults<Arc>(GetParam(), default_solver_names(), seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, HonestResolutions, ::testing::ValuesIn(scene_names()),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(HonestResolutionsOfOtherSolvers, AreNotRefused) {
  for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
    for (const char* scene : {"high-mobile", "low-manipulator-04", "adaptive-mobile"}) {
      expect_no_faults<Arc>(scene, {"prioritized-query", "composite-rrt-connect"}, seed);
    }
    expect_no_faults<Arc>("high-mobile", {"composite-prm"}, seed);
    for (const char* solver : {"decoupled-prm", "composite-prm", "composite-rrt-connect"}) {
      expect_no_faults<WholeProblem>("peer-inlet", {solver}, seed);
    }
    for (const char* scene : {"adaptive-manipulator", "ur5e-pair"}) {
      expect_no_faults<WholeProblem>(scene, {"cbs-mp"}, seed);
    }
  }
}

}  // namespace
}  // namespace accord
