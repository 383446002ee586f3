#include "coordinator/conflict_board.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr std::uint32_t kRobots = 10;

Trajectory wander(RandomStream& random, double from, const Trajectory& before) {
  Trajectory path(2);
  for (std::size_t i = 0; i < before.size() && before.time(i) < from; ++i) {
    path.append(before.time(i), before.configuration(i));
  }
  double t = from;
  path.append(t, before.empty() ? Configuration{random.uniform(-6, 6), random.uniform(-6, 6)}
                                : before.at(from));
  for (int i = 0; i < 4; ++i) {
    t += random.uniform(1, 4);
    path.append(t, Configuration{random.uniform(-6, 6), random.uniform(-6, 6)});
  }
  return path;
}

// Discs on random ways.
struct Wanderers {
  explicit Wanderers(std::uint64_t seed) : random(seed) {
    for (std::uint32_t r = 0; r < kRobots; ++r) {
      schedule.set_initial({r}, wander(random, 0, Trajectory(2)), "test");
    }
  }

  static std::shared_ptr<const Scene> discs() {
    testing::SceneBuilder builder(-20, -20, 20, 20);
    for (std::uint32_t r = 0; r < kRobots; ++r) builder.disk(0.5, {0, 0}, {0, 0});
    return builder.build();
  }

  RandomStream random;
  std::shared_ptr<const Scene> scene = discs();
  CollisionWorld world{scene, kPlanningMargin};
  Schedule schedule{scene};
};

std::vector<Conflict> all_pairs(const CollisionWorld& world, const Schedule& schedule) {
  std::vector<Conflict> conflicts;
  for (std::uint32_t a = 0; a < kRobots; ++a) {
    for (std::uint32_t b = a + 1; b < kRobots; ++b) {
      const auto time = earliest_contact(world, {a}, schedule.path({a}), {b}, schedule.path({b}), 0,
                                         std::numeric_limits<double>::infinity());
      if (time) conflicts.push_back({{a}, {b}, *time});
    }
  }
  std::ranges::stable_sort(conflicts, {}, &Conflict::time);
  return conflicts;
}

void expect_same(const std::set<Conflict, ConflictBoard::Earlier>& found,
                 const std::vector<Conflict>& b) {
  const std::vector<Conflict> a(found.begin(), found.end());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].first, b[i].first);
    EXPECT_EQ(a[i].second, b[i].second);
    EXPECT_NEAR(a[i].time, b[i].time, 1e-6);
  }
}

TEST(ConflictBoard, AgreesWithLookingAtAllPairsAfterEveryChange) {
  Wanderers fleet(11);
  auto& [random, scene, world, schedule] = fleet;
  ConflictBoard board(world, schedule);
  board.look_at_all();
  expect_same(board.conflicts(), all_pairs(world, schedule));
  for (int change = 0; change < 25; ++change) {
    const double from = random.uniform(0, 10);
    std::vector<RobotId> changed;
    for (int i = 0; i < 2; ++i) {
      const RobotId robot{static_cast<std::uint32_t>(random.below(kRobots))};
      if (std::ranges::count(changed, robot)) continue;
      schedule.set_initial(robot, wander(random, from, schedule.path(robot)), "test");
      changed.push_back(robot);
    }
    board.update(changed, from);
    expect_same(board.conflicts(), all_pairs(world, schedule));
  }
}

TEST(ConflictBoard, LooksNoFurtherAheadThanItIsAskedTo) {
  Wanderers fleet(12);
  auto& [random, scene, world, schedule] = fleet;
  const std::vector<Conflict> all = all_pairs(world, schedule);
  ASSERT_GT(all.size(), 6U);
  ConflictBoard board(world, schedule);
  EXPECT_TRUE(board.look_ahead(3, 0));
  EXPECT_GE(board.size(), 3U);
  EXPECT_LT(board.size(), all.size());
  std::size_t known = board.size();
  expect_same(board.conflicts(), {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(known)});
  // A change within what it has seen, and one beyond.
  for (const double from : {0.0, all.back().time}) {
    schedule.set_initial({0}, wander(random, from, schedule.path({0})), "test");
    board.update({{0}}, from);
    const std::vector<Conflict> now = all_pairs(world, schedule);
    known = board.size();
    expect_same(board.conflicts(), {now.begin(), now.begin() + static_cast<std::ptrdiff_t>(known)});
  }
  board.look_at_all();
  expect_same(board.conflicts(), all_pairs(world, schedule));
}

}  // namespace
}  // namespace accord
