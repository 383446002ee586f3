#include "worker/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"
#include "worker/lattice_ways.h"

namespace accord {
namespace {

constexpr double kRadius = 0.35;
constexpr double kLeast = 1.0;

ConfigurationView planar(const Vec3& point) {
  return {point.data(), 2};
}

// A hall with two racks; aisles between 2.4 m wide.
class LatticeTest : public ::testing::Test {
 protected:
  LatticeTest()
      : scene_(testing::SceneBuilder(0, 0, 9.2, 10)
                   .box(2.4, 2.4, 3.4, 7.6)
                   .box(5.8, 2.4, 6.8, 7.6)
                   .disk(kRadius, {1.3, 4.2}, {8.1, 5.6})
                   .build()),
        world_(scene_, kPlanningMargin),
        lattice_(world_, {0}, {Vec3::Zero(), Vec3(9.2, 10, 0)}, kLeast),
        weights_(lattice_.size(), 1) {}

  LatticeWays ways(const Vec3& start, const Vec3& goal) const {
    return {world_, lattice_, weights_, {0}, start, goal};
  }

  std::shared_ptr<const Scene> scene_;
  CollisionWorld world_;
  Lattice lattice_;
  std::vector<std::uint32_t> weights_;
};

TEST_F(LatticeTest, IsFreeAndNeighboursAreNoFartherApartThanItsSpacing) {
  ASSERT_GT(lattice_.size(), 30u);
  std::size_t edges = 0;
  for (Lattice::Node node = 0; node < lattice_.size(); ++node) {
    const Vec3& from = lattice_.position(node);
    EXPECT_TRUE(world_.is_free({0}, planar(from)));
    for (const Lattice::Node other : lattice_.neighbours(node)) {
      const Vec3& to = lattice_.position(other);
      EXPECT_TRUE(world_.motion_is_free({0}, planar(from), planar(to)));
      EXPECT_LE((to - from).norm(), lattice_.spacing());
      EXPECT_GE((to - from).norm(), kLeast - 1e-9);
      EXPECT_TRUE(std::ranges::count(lattice_.neighbours(other), node)) << "one way only";
      ++edges;
    }
  }
  EXPECT_GT(edges, 2 * lattice_.size());
}

// Lines a metre apart from the wall on would give the second aisle a single one.
TEST_F(LatticeTest, LaysTwoLinesThroughEveryAisleThatIsWideEnough) {
  for (const double left : {0.0, 3.4, 6.8}) {
    std::size_t inside = 0;
    for (Lattice::Node node = 0; node < lattice_.size(); ++node) {
      const Vec3& at = lattice_.position(node);
      const bool is_half_way = at.y() > 4.5 && at.y() < 4.5 + kLeast;
      if (is_half_way && at.x() > left && at.x() < left + 2.4) ++inside;
    }
    EXPECT_GE(inside, 2u) << "aisle from " << left << " m";
  }
}

TEST_F(LatticeTest, FindsAllNodesAroundAPointNearestFirst) {
  RandomStream random(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 point(random.uniform(-1, 10), random.uniform(-1, 11), 0);
    const double distance = random.uniform(0, 4);
    std::vector<Lattice::Node> found;
    lattice_.within(point, distance, found);
    const auto away = [&](Lattice::Node node) { return (lattice_.position(node) - point).norm(); };
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, away));
    std::size_t expected = 0;
    for (Lattice::Node node = 0; node < lattice_.size(); ++node) expected += away(node) <= distance;
    EXPECT_EQ(found.size(), expected);
  }
}

TEST_F(LatticeTest, KnowsHowManyPlacesThereWillBeAtMost) {
  const Aabb box{Vec3::Zero(), Vec3(9.2, 10, 0)};
  EXPECT_LE(lattice_.size(), Lattice::places(box, kLeast, 2));
  EXPECT_GT(Lattice::places({Vec3::Zero(), Vec3(1e9, 1e9, 1e9)}, kLeast, 3), Lattice::kMostPlaces);
}

TEST_F(LatticeTest, LeadsARobotFromOffTheLatticeToItsGoalInFreeSteps) {
  const Vec3 start(1.3, 4.2, 0), goal(8.1, 5.6, 0);
  const LatticeWays way = ways(start, goal);
  ASSERT_TRUE(way.start());
  EXPECT_EQ(way.position(*way.start()), start);
  EXPECT_EQ(way.position(way.goal()), goal);
  std::uint32_t steps = 0;
  for (LatticeWays::Node at = *way.start(); at != way.goal(); ++steps) {
    ASSERT_LT(steps, 100u);
    const LatticeWays::Node next = way.best_next(at);
    const Vec3 &from = way.position(at), &to = way.position(next);
    EXPECT_TRUE(world_.motion_is_free({0}, planar(from), planar(to)));
    EXPECT_LE((to - from).norm(), lattice_.spacing() * (1 + 1e-9));
    EXPECT_LT(way.cost(next), way.cost(at));
    at = next;
  }
  EXPECT_EQ(steps, way.cost(*way.start())) << "weights are 1, so that costs are steps";
}

TEST_F(LatticeTest, GoesRoundNodesThatCostMore) {
  const Vec3 start(1.2, 0.8, 0), goal(8.0, 0.8, 0);
  const std::uint32_t straight = ways(start, goal).cost(*ways(start, goal).start());
  for (Lattice::Node node = 0; node < lattice_.size(); ++node) {
    const Vec3& at = lattice_.position(node);
    if (at.x() > 4 && at.x() < 5.5 && at.y() < 2.4) weights_[node] = 50;
  }
  const LatticeWays way = ways(start, goal);
  EXPECT_GT(way.cost(*way.start()), straight);
  EXPECT_LT(way.cost(*way.start()), 50u) << "there is a way round the racks";
}

TEST_F(LatticeTest, StepsAsideOnlyWhereThatIsFreeAndLeadsOn) {
  LatticeWays way = ways(Vec3(1.3, 4.2, 0), Vec3(8.1, 5.6, 0));
  const auto aside = way.displaced(*way.start(), Vec3(-0.5, 0, 0));
  ASSERT_TRUE(aside);
  EXPECT_TRUE(way.is_off(*aside));
  EXPECT_NEAR(way.position(*aside).x(), 0.8, 1e-12);
  std::vector<LatticeWays::Node> next;
  way.next(*aside, next);
  EXPECT_FALSE(next.empty());
  EXPECT_EQ(way.displaced(*way.start(), Vec3(1, 0, 0)), std::nullopt) << "into the rack";
  EXPECT_EQ(way.displaced(*way.start(), Vec3(-0.5, 0, 0)), aside) << "a place is known again";
}

TEST(LatticeWays, FindsNoWayOutOfAClosedRoom) {
  const auto scene =
      testing::SceneBuilder(0, 0, 12, 4).box(5.9, 0, 6.1, 4).disk(kRadius, {2, 2}, {10, 2}).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Lattice lattice(world, {0}, {Vec3::Zero(), Vec3(12, 4, 0)}, kLeast);
  const std::vector<std::uint32_t> weights(lattice.size(), 1);
  EXPECT_FALSE(LatticeWays(world, lattice, weights, {0}, Vec3(2, 2, 0), Vec3(10, 2, 0)).start());
  EXPECT_TRUE(LatticeWays(world, lattice, weights, {0}, Vec3(2, 2, 0), Vec3(4, 3, 0)).start());
}

}  // namespace
}  // namespace accord
