#include "coordinator/space_time_grid.h"

#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

Trajectory random_path(RandomStream& random) {
  Trajectory path(2);
  double t = 0;
  const std::size_t waypoints = 1 + random.below(6);
  for (std::size_t i = 0; i < waypoints; ++i, t += random.uniform(0.5, 4)) {
    path.append(t, Configuration{random.uniform(-10, 10), random.uniform(-10, 10)});
  }
  return path;
}

TEST(SpaceTimeGrid, NamesEveryPairThatComesCloseInASlabThroughAnyChanges) {
  testing::SceneBuilder builder(-20, -20, 20, 20);
  constexpr std::uint32_t kRobots = 12;
  for (std::uint32_t r = 0; r < kRobots; ++r) builder.disk(0.5, {0, 0}, {0, 0});
  const CollisionWorld world(builder.build(), kPlanningMargin);
  RandomStream random(3);
  for (const double cell : {0.7, 4.0, 100.0}) {
    // Smaller than where the robots are, so that some are filed at its rim.
    SpaceTimeGrid grid(world, 1.0, {{-8, -8, 0}, {8, 9, 0}}, cell);
    std::vector<Trajectory> paths;
    for (std::uint32_t r = 0; r < kRobots; ++r) {
      paths.push_back(random_path(random));
      grid.place({r}, paths.back(), 0);
    }
    for (int change = 0; change < 20; ++change) {
      // Replaced from some time on by a path that agrees until then.
      const auto robot = static_cast<std::uint32_t>(random.below(kRobots));
      const double from = random.uniform(0, 8);
      Trajectory next(2);
      for (std::size_t i = 0; i < paths[robot].size() && paths[robot].time(i) < from; ++i) {
        next.append(paths[robot].time(i), paths[robot].configuration(i));
      }
      if (from > 0) next.append(from, paths[robot].at(from));
      next.append(from + random.uniform(1, 9),
                  Configuration{random.uniform(-10, 10), random.uniform(-10, 10)});
      paths[robot] = next;
      grid.place({robot}, next, from);
    }
    std::vector<RobotId> near;
    for (std::uint32_t a = 0; a < kRobots; ++a) {
      for (double t = 0; t < 25; t += 0.05) {
        grid.neighbours({a}, std::min(grid.slab_of(t), grid.slabs() - 1), near);
        for (std::uint32_t b = 0; b < kRobots; ++b) {
          if (a == b) continue;
          const Configuration qa = paths[a].at(t), qb = paths[b].at(t);
          if (std::hypot(qa[0] - qb[0], qa[1] - qb[1]) > 1.0) continue;
          EXPECT_TRUE(std::ranges::count(near, RobotId{b})) << a << " " << b << " at " << t;
        }
      }
    }
  }
}

}  // namespace
}  // namespace accord
