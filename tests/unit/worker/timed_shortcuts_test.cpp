#include "worker/timed_shortcuts.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

// A disc that goes over the end of a thin wall, which it all but touches on both sides, waits
// behind it, and goes on to the right. Very fast, so that many cuts begin right behind the corner.
class TimedShortcuts : public ::testing::Test {
 protected:
  static constexpr double kWait = 0.01;  // s

  TimedShortcuts()
      : world_(testing::SceneBuilder(-3, -3, 3, 3)
                   .box(-0.01, -3, 0.01, 0)
                   .robot(testing::disk_model(0.3, 1000), {-1, -0.2}, {2, 0.35})
                   .build(),
               kPlanningMargin),
        team_(world_, {RobotId{0}}, 0) {
    const Configuration left{-1, -0.2}, over{0, 0.35}, right{1, -0.2}, goal{2, 0.35};
    path_.append(0, left);
    path_.append(team_.duration(left, over), over);
    path_.append(path_.end_time() + team_.duration(over, right), right);
    path_.append(path_.end_time() + kWait, right);
    path_.append(path_.end_time() + team_.duration(right, goal), goal);
  }

  CollisionWorld world_;
  Team team_;
  Trajectory path_{2};
};

// Once, a cut that began within 10 us behind a waypoint left the waypoint out.
TEST_F(TimedShortcuts, LeaveOutNoCornerThatIsNeeded) {
  int shorter = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    Trajectory cut = path_;
    Effort effort;
    cut_corners(team_, 0, seed, cut, effort);
    shorter += cut.end_time() < path_.end_time() - 0.9 * kWait ? 1 : 0;
    for (std::size_t k = 0; k + 1 < cut.size(); ++k) {
      ASSERT_TRUE(world_.motion_is_free({0}, cut.configuration(k), cut.configuration(k + 1)))
          << "seed " << seed << ", motion " << k;
    }
  }
  EXPECT_GT(shorter, 10'000);
}

}  // namespace
}  // namespace accord
