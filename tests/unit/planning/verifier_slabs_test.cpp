// The verifier's broad phase may name pairs too many, never too few.
#include "common/planning/verifier_slabs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord::verification {
namespace {

constexpr double kRadius = 0.5;

Trajectory random_path(RandomStream& random, std::size_t waypoints) {
  Trajectory path(2);
  double t = 0;
  for (std::size_t i = 0; i < waypoints; ++i, t += random.uniform(0.2, 3)) {
    path.append(t, Configuration{random.uniform(-10, 10), random.uniform(-10, 10)});
  }
  return path;
}

bool holds(const Aabb& box, const Configuration& q) {
  return box.min.x() <= q[0] - kRadius && q[0] + kRadius <= box.max.x() &&
         box.min.y() <= q[1] - kRadius && q[1] + kRadius <= box.max.y();
}

TEST(PathBoxes, HoldAllThatIsSweptAndLittleMore) {
  const auto scene = testing::SceneBuilder(-20, -20, 20, 20).disk(kRadius, {0, 0}, {0, 0}).build();
  const CollisionWorld world(scene, kProofMargin);
  RandomStream random(5);
  for (const std::size_t waypoints : {1U, 2U, 3U, 4U, 7U, 8U, 9U, 31U, 64U, 100U}) {
    const Trajectory path = random_path(random, waypoints);
    const PathBoxes boxes(world, {0}, path);
    for (int query = 0; query < 50; ++query) {
      const double t0 = random.uniform(0, path.end_time() + 2);
      const double t1 = query % 5 == 0 ? t0 : random.uniform(t0, path.end_time() + 3);
      const Aabb box = boxes.over(t0, t1);
      Aabb exact = world.swept_bounds({0}, path.at(t0), path.at(t0));
      exact.merge(world.swept_bounds({0}, path.at(t1), path.at(t1)));
      for (std::size_t i = 0; i < path.size(); ++i) {
        if (path.time(i) < t0 || path.time(i) > t1) continue;
        exact.merge(world.swept_bounds({0}, path.configuration(i), path.configuration(i)));
      }
      EXPECT_LE((box.min - exact.min).norm() + (box.max - exact.max).norm(), 1e-9)
          << waypoints << " waypoints, " << t0 << " to " << t1;
      for (int k = 0; k <= 20; ++k) EXPECT_TRUE(holds(box, path.at(t0 + (t1 - t0) * k / 20)));
    }
  }
}

class Slabs : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Slabs, CoverAllTimeAndNameEveryPairThatComesNear) {
  testing::SceneBuilder builder(-20, -20, 20, 20);
  constexpr std::uint32_t kRobots = 14;
  for (std::uint32_t r = 0; r < kRobots; ++r) builder.disk(kRadius, {0, 0}, {0, 0});
  const auto scene = builder.build();
  const CollisionWorld world(scene, kProofMargin);
  RandomStream random(GetParam());
  std::vector<Trajectory> paths;
  for (std::uint32_t r = 0; r < kRobots; ++r) paths.push_back(random_path(random, GetParam()));
  Subject subject{*scene, world, {}};
  for (const Trajectory& path : paths) subject.paths.push_back(&path);
  const TimeSlabs slabs(subject);
  const double distance = 0.3;
  double reached = 0;
  std::size_t named = 0;
  for (std::size_t slab = 0; slab < slabs.count(); ++slab) {
    slabs.for_each_part(slab, distance, [&](double begin, double end, std::vector<Pair>& pairs) {
      EXPECT_EQ(begin, reached);
      EXPECT_LT(begin, end);
      reached = end;
      std::set<std::pair<RobotId, RobotId>> near;
      for (const Pair pair : pairs) {
        EXPECT_LT(pair.first, pair.second);
        near.emplace(pair.first, pair.second);
      }
      named += near.size();
      for (int k = 0; k <= 50; ++k) {
        const double t = begin + (end - begin) * k / 50;
        for (std::uint32_t a = 0; a < kRobots; ++a) {
          for (std::uint32_t b = a + 1; b < kRobots; ++b) {
            const Configuration qa = paths[a].at(t), qb = paths[b].at(t);
            if (std::hypot(qa[0] - qb[0], qa[1] - qb[1]) > 2 * kRadius + distance) continue;
            EXPECT_TRUE(near.contains({RobotId{a}, RobotId{b}})) << a << " " << b << " at " << t;
          }
        }
      }
      return true;
    });
  }
  EXPECT_DOUBLE_EQ(reached, subject.end() > 0 ? subject.end() : 1);
  EXPECT_GT(named, 0U);
}

INSTANTIATE_TEST_SUITE_P(Waypoints, Slabs, ::testing::Values(1, 2, 5, 40));

}  // namespace
}  // namespace accord::verification
