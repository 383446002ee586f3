#include "worker/lockstep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/point_motion.h"
#include "common/geometry/tolerances.h"
#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr double kRadius = 0.35;
const std::atomic<bool> kGoOn{false};

Vec3 to_point(const Configuration& q) {
  return {q[0], q[1], 0};
}

// All robots of a scene of discs, on a lattice over its bounds.
class Steps {
 public:
  explicit Steps(const testing::SceneBuilder& builder, std::uint64_t seed = 1)
      : scene_(builder.build()),
        world_(scene_, kPlanningMargin),
        lattice_(world_, {0}, {scene_->bounds->min, scene_->bounds->max}, 1.4143 * 2 * kRadius),
        lockstep_(world_, lattice_, travellers(), seed) {
    has_run_ = lockstep_.run(kGoOn);
    if (has_run_) steps_ = lockstep_.take_steps();
  }

  bool has_run() const { return has_run_; }
  const std::vector<std::vector<Vec3>>& steps() const { return steps_; }
  const Vec3& goal(std::size_t i) const { return goals_[i]; }
  const Lattice& lattice() const { return lattice_; }
  std::vector<std::vector<Vec3>> ways_left() const { return lockstep_.ways_left(); }

  std::size_t arrived() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) count += steps_[i].back() == goals_[i];
    return count;
  }

  // The first step in which two come too close to each other, or one to an obstacle, or goes too
  // far. -1: none.
  int first_bad_step() const {
    const double keep = 2 * kRadius + world_.required_separation();
    for (std::size_t k = 1; k < steps_.front().size(); ++k) {
      for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Vec3 &from = steps_[i][k - 1], &to = steps_[i][k];
        if ((to - from).norm() > lattice_.spacing() * (1 + 1e-9)) return static_cast<int>(k);
        if (!world_.motion_is_free({0}, {from.data(), 2}, {to.data(), 2})) {
          return static_cast<int>(k);
        }
        for (std::size_t j = 0; j < i; ++j) {
          const Vec3 drift = (to - from) - (steps_[j][k] - steps_[j][k - 1]);
          if (first_within(from - steps_[j][k - 1], drift, keep)) return static_cast<int>(k);
        }
      }
    }
    return -1;
  }

 private:
  std::vector<Lockstep::Traveller> travellers() {
    std::vector<Lockstep::Traveller> all;
    for (std::uint32_t id = 0; id < scene_->robots.size(); ++id) {
      const Robot& robot = scene_->robot({id});
      goals_.push_back(to_point(robot.goal));
      all.push_back({{id}, to_point(robot.start), goals_.back()});
    }
    return all;
  }

  std::shared_ptr<const Scene> scene_;
  CollisionWorld world_;
  Lattice lattice_;
  std::vector<Vec3> goals_;
  Lockstep lockstep_;
  bool has_run_ = false;
  std::vector<std::vector<Vec3>> steps_;
};

// Places clear of each other and of the hall's walls.
std::vector<Configuration> scattered(std::size_t count, double side, RandomStream& random) {
  std::vector<Configuration> places;
  while (places.size() < count) {
    const Configuration q{random.uniform(0.5, side - 0.5), random.uniform(0.5, side - 0.5)};
    const bool is_clear = std::ranges::all_of(places, [&](const Configuration& other) {
      return std::hypot(q[0] - other[0], q[1] - other[1]) > 2 * kRadius + 0.1;
    });
    if (is_clear) places.push_back(q);
  }
  return places;
}

TEST(Lockstep, NobodyComesTooCloseToAnyoneInACrowdedHall) {
  RandomStream random(5);
  testing::SceneBuilder builder(0, 0, 16, 16);
  const auto starts = scattered(60, 16, random), goals = scattered(60, 16, random);
  for (std::size_t i = 0; i < 60; ++i) builder.disk(kRadius, starts[i], goals[i]);
  const Steps run(builder);
  ASSERT_TRUE(run.has_run());
  EXPECT_EQ(run.first_bad_step(), -1);
  EXPECT_GE(run.arrived(), 57u);
}

TEST(Lockstep, APassageThatSomeoneHasParkedInIsClearedAndTakenAgain) {
  const Steps run(testing::SceneBuilder(0, 0, 12, 2)
                      .disk(kRadius, {1, 1}, {11, 1})
                      .disk(kRadius, {6.2, 1.1}, {6.2, 1.1}));
  ASSERT_TRUE(run.has_run());
  EXPECT_EQ(run.first_bad_step(), -1);
  EXPECT_EQ(run.arrived(), 2u);
  EXPECT_NE(std::ranges::count(run.steps()[1], run.goal(1)),
            static_cast<std::ptrdiff_t>(run.steps()[1].size()))
      << "the parked one never moved: the hall is too wide for this test";
}

TEST(Lockstep, TwoThatWantToChangePlacesPassEachOtherWhereThereIsRoom) {
  const Steps run(testing::SceneBuilder(0, 0, 12, 4)
                      .disk(kRadius, {1, 2}, {11, 2})
                      .disk(kRadius, {11, 2}, {1, 2}));
  EXPECT_EQ(run.first_bad_step(), -1);
  EXPECT_EQ(run.arrived(), 2u);
}

// In a corridor with no place to pass: the rest of the way leads to the goal all the same, for
// others to find out when.
TEST(Lockstep, WhereItCannotGoOnItSaysWhereEveryoneIsAndTheRestOfTheWay) {
  const Steps run(testing::SceneBuilder(0, 0, 12, 1)
                      .disk(kRadius, {1, 0.5}, {11, 0.5})
                      .disk(kRadius, {11, 0.5}, {1, 0.5}));
  ASSERT_TRUE(run.has_run());
  EXPECT_EQ(run.first_bad_step(), -1);
  EXPECT_LT(run.arrived(), 2u);
  const auto left = run.ways_left();
  for (std::size_t i = 0; i < 2; ++i) {
    if (run.steps()[i].back() == run.goal(i)) {
      EXPECT_TRUE(left[i].empty());
    } else {
      EXPECT_EQ(left[i].back(), run.goal(i));
    }
  }
}

TEST(Lockstep, DoesNotBeginWhereSomeoneHasNoWay) {
  const Steps run(testing::SceneBuilder(0, 0, 12, 4)
                      .box(5.9, 0, 6.1, 4)
                      .disk(kRadius, {1, 2}, {11, 2})
                      .disk(kRadius, {1, 3}, {3, 3}));
  EXPECT_FALSE(run.has_run());
}

TEST(Lockstep, StopsWhenToldTo) {
  const auto scene = testing::SceneBuilder(0, 0, 12, 4).disk(kRadius, {1, 2}, {11, 2}).build();
  const CollisionWorld world(scene, kPlanningMargin);
  const Lattice lattice(world, {0}, {Vec3::Zero(), Vec3(12, 4, 0)}, 1.0);
  Lockstep lockstep(world, lattice, {{{0}, Vec3(1, 2, 0), Vec3(11, 2, 0)}}, 1);
  const std::atomic<bool> stop{true};
  lockstep.run(stop);
  EXPECT_EQ(lockstep.moves(), 0u);
}

TEST(Lockstep, TheSameSeedGivesTheSameSteps) {
  RandomStream random(8);
  testing::SceneBuilder builder(0, 0, 12, 12);
  const auto starts = scattered(30, 12, random), goals = scattered(30, 12, random);
  for (std::size_t i = 0; i < 30; ++i) builder.disk(kRadius, starts[i], goals[i]);
  EXPECT_EQ(Steps(builder, 4).steps(), Steps(builder, 4).steps());
}

}  // namespace
}  // namespace accord
