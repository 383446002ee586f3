#include "worker/point_traffic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "common/planning/random.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
constexpr double kRoom = 0.8;
constexpr double kForever = std::numeric_limits<double>::infinity();

Trajectory random_walk(RandomStream& random) {
  Trajectory path(2);
  double t = random.uniform(0, 5);
  for (int i = 0; i < 6; ++i) {
    path.append(t, Configuration{random.uniform(-10, 10), random.uniform(-10, 10)});
    t += random.uniform(0.1, 4);
  }
  return path;
}

// The least distance of two segments in the plane.
double distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double least = kForever;
  constexpr int kSteps = 200;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3 p = a + (b - a) * i / kSteps;
    const double length = (d - c).squaredNorm();
    const double s = length == 0 ? 0 : std::clamp((p - c).dot(d - c) / length, 0.0, 1.0);
    least = std::min(least, (c + s * (d - c) - p).norm());
  }
  return least;
}

Vec3 end_of(const PointTraffic::Piece& piece) {
  if (std::isinf(piece.t1)) return piece.position;
  return piece.position + (piece.t1 - piece.t0) * piece.velocity;
}

TEST(PointTraffic, FindsEverythingThatComesNearOnceAndNothingThatWasRemoved) {
  RandomStream random(7);
  PointTraffic traffic(kRoom);
  PointTraffic everything(1000);  // one cell: finds all that there is
  for (std::uint32_t owner = 0; owner < 60; ++owner) {
    const Trajectory path = random_walk(random);
    const double radius = random.uniform(0.1, 0.5);
    traffic.add(owner, path, radius);
    if (owner % 3 == 0) {
      traffic.remove(owner);
    } else {
      everything.add(owner, path, radius);
    }
  }
  std::vector<const PointTraffic::Piece*> found, all;
  for (int question = 0; question < 200; ++question) {
    const Vec3 a(random.uniform(-10, 10), random.uniform(-10, 10), 0);
    const Vec3 b(random.uniform(-10, 10), random.uniform(-10, 10), 0);
    const double since = random.uniform(0, 20), until = since + random.uniform(0, 20);
    found.clear();
    all.clear();
    traffic.near(a, b, since, until, nullptr, found);
    everything.near(Vec3::Zero(), Vec3::Zero(), since, until, nullptr, all);
    std::set<std::pair<double, double>> places;  // of what was found
    for (const auto* piece : found) places.insert({piece->t0, piece->position.x()});
    EXPECT_EQ(places.size(), found.size()) << "a piece was found twice";
    EXPECT_LE(found.size(), all.size());
    for (const auto* piece : all) {
      if (distance(a, b, piece->position, end_of(*piece)) > piece->radius + kRoom) continue;
      EXPECT_TRUE(places.contains({piece->t0, piece->position.x()}));
    }
  }
}

TEST(PointTraffic, LeavesOutWhatDoesNotComeNear) {
  PointTraffic traffic(kRoom);
  for (std::uint32_t owner = 0; owner < 100; ++owner) {
    const double y = 10.0 * owner;
    traffic.add(owner, testing::path({{0, {-5, y}}, {10, {5, y}}}), 0.3);
  }
  std::vector<const PointTraffic::Piece*> found;
  traffic.near(Vec3(-5, 500, 0), Vec3(5, 500, 0), 0, kEver, nullptr, found);
  EXPECT_EQ(found.size(), 2u);  // the motion and the rest after it
}

TEST(PointTraffic, EndsAtTheGivenTimeEvenWhereARobotHasParked) {
  PointTraffic traffic(kRoom);
  traffic.add(1, testing::path({{0, {0, 0}}, {10, {10, 0}}}), 0.3, 0, 4);
  traffic.add(2, testing::path({{0, {0, 5}}}), 0.3, 0, 4);
  std::vector<const PointTraffic::Piece*> found;
  traffic.near(Vec3(0, 0, 0), Vec3(10, 0, 0), 0, kEver, nullptr, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]->t1, 4);
  found.clear();
  traffic.near(Vec3(0, 5, 0), Vec3(0, 5, 0), 0, kEver, nullptr, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]->t1, 4);
  found.clear();
  traffic.near(Vec3(0, 5, 0), Vec3(0, 5, 0), 4, kEver, nullptr, found);
  EXPECT_TRUE(found.empty());
}

TEST(PointTraffic, LeavesOutWhatHappensAtOtherTimes) {
  PointTraffic traffic(kRoom);
  traffic.add(1, testing::path({{0, {0, 0}}, {10, {1, 0}}, {20, {2, 0}}}), 0.3);
  std::vector<const PointTraffic::Piece*> found;
  traffic.near(Vec3(1, 0, 0), Vec3(1, 0, 0), 11, 12, nullptr, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]->t0, 10);
}

TEST(PointTraffic, FindsTheGivenOwnersOnlyWhereAskedTo) {
  PointTraffic traffic(kRoom);
  traffic.add(0, testing::path({{0, {0, 0}}}), 0.3);
  traffic.add(1, testing::path({{0, {0.5, 0}}}), 0.3);
  const std::vector<char> only{0, 1};
  std::vector<const PointTraffic::Piece*> found;
  traffic.near(Vec3(0, 0, 0), Vec3(0, 0, 0), 0, kEver, &only, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]->position.x(), 0.5);
}

TEST(PointTraffic, ForgettingSomeoneUnknownChangesNothing) {
  PointTraffic traffic(kRoom);
  traffic.remove(9);
  EXPECT_TRUE(traffic.empty());
}

}  // namespace
}  // namespace accord
