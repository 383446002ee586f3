#include "common/planning/meetings.h"

#include <gtest/gtest.h>

#include <limits>
#include <list>

#include "common/geometry/tolerances.h"
#include "common/planning/conflict.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Traffic {
  std::shared_ptr<const Scene> scene;
  std::list<Trajectory> paths;
  std::vector<Mover> movers;
};

// Discs, and some carts, that wander about a square; a few pairs meet or none.
Traffic wandering(std::size_t robots, std::uint64_t seed) {
  RandomStream random(seed);
  const double half = 30;
  testing::SceneBuilder builder(-half, -half, half, half);
  const auto cart = testing::cart_model(1.0, 0.6);
  const auto place = [&](std::size_t dof) {
    Configuration q{random.uniform(-half, half), random.uniform(-half, half)};
    if (dof == 3) q.push_back(random.uniform(-3, 3));
    return q;
  };
  Traffic out;
  for (std::size_t i = 0; i < robots; ++i) {
    const std::size_t dof = i % 5 == 0 ? 3 : 2;
    Trajectory path(dof);
    double t = random.uniform(-1, 0);
    path.append(t, place(dof));
    for (std::size_t k = random.below(3); k > 0; --k) {
      t += random.uniform(0.1, 8);
      Configuration q(path.configuration(path.size() - 1).begin(),
                      path.configuration(path.size() - 1).end());
      for (double& x : q) x += random.uniform(-3, 3);
      path.append(t, q);
    }
    const Configuration start = path.at(0);
    dof == 3 ? builder.robot(cart, start, start) : builder.disk(0.4, start, start);
    out.paths.push_back(std::move(path));
    const double until = random.below(3) == 0 ? kInfinity : random.uniform(0, 20);
    out.movers.push_back(
        {{static_cast<std::uint32_t>(i)}, &out.paths.back(), until, random.below(4) != 0});
  }
  out.scene = builder.build();
  return out;
}

std::optional<double> first_contact(const CollisionWorld& world, const Mover& a, const Mover& b) {
  if (!a.is_in_question && !b.is_in_question) return std::nullopt;
  return earliest_contact(world, a.robot, *a.path, b.robot, *b.path, 0, std::min(a.until, b.until));
}

TEST(FindMeeting, OfManyFindsOneWhereEachWithEachDoes) {
  std::size_t clear = 0, meet = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const Traffic traffic = wandering(40, seed);
    const CollisionWorld world(traffic.scene, kDetectionMargin);
    std::size_t meetings = 0;
    for (std::size_t i = 0; i < traffic.movers.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (first_contact(world, traffic.movers[i], traffic.movers[j])) ++meetings;
      }
    }
    const auto found = find_meeting(world, traffic.movers, 0);
    ASSERT_EQ(found.has_value(), meetings > 0) << "seed " << seed;
    if (!found) {
      ++clear;
      continue;
    }
    ++meet;
    const auto time =
        first_contact(world, traffic.movers[found->first], traffic.movers[found->second]);
    ASSERT_TRUE(time) << "seed " << seed;
    EXPECT_NEAR(*time, found->time, 1e-6) << "seed " << seed;
  }
  EXPECT_GT(clear, 20U);
  EXPECT_GT(meet, 20U);
}

TEST(FindMeeting, OfManySeesThoseThatParkInEachOther) {
  Traffic traffic = wandering(40, 1);
  for (Mover& mover : traffic.movers) mover.until = 0;
  const CollisionWorld world(traffic.scene, kDetectionMargin);
  ASSERT_FALSE(find_meeting(world, traffic.movers, 0));
  const Trajectory first = testing::path({{0, {-29, 0}}, {5, {-29, 0.7}}});
  const Trajectory second = testing::path({{0, {-29, 3}}, {50, {-29, 1.4}}});
  traffic.movers[1] = {{1}, &first, kInfinity};
  traffic.movers[2] = {{2}, &second, kInfinity};
  const auto found = find_meeting(world, traffic.movers, 0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->time, 46.875, 1e-3);
}

TEST(FindMeeting, OfManySeesThoseThatNeverMove) {
  testing::SceneBuilder builder(-40, -40, 40, 40);
  const auto cart = testing::cart_model(1.0, 0.6);
  std::list<Trajectory> rests;
  std::vector<Mover> movers;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Configuration q{i < 2 ? 0.3 * i : 1.5 * i - 30, 0, 0};
    builder.robot(cart, q, q);
    rests.push_back(testing::path({{0, q}}));
    movers.push_back({{i}, &rests.back(), kInfinity});
  }
  const CollisionWorld world(builder.build(), kDetectionMargin);
  EXPECT_TRUE(find_meeting(world, movers, 0));
  movers[0].until = -1;
  movers[20].until = movers[19].until = movers[21].until = -1;
  EXPECT_FALSE(find_meeting(world, movers, 0));
}

}  // namespace
}  // namespace accord
