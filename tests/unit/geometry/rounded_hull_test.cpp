#include "common/geometry/rounded_hull.h"

#include <gtest/gtest.h>

#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using test_scenes::Random;
using test_scenes::uniform;

Vec3 random_direction(Random& random) {
  Vec3 d;
  do {
    d = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
  } while (d.norm() > 1 || d.norm() < 0.1);
  return d.normalized();
}

// A set is inside a convex one where it reaches no farther, whatever the direction.
void expect_holds(const RoundedHull& hull, const std::vector<Vec3>& points) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 d = random_direction(random);
    double most = -1e300;
    for (const Vec3& p : points) most = std::max(most, p.dot(d));
    EXPECT_LE(most, hull.farthest(d).dot(d) + hull.radius);
  }
}

TEST(RoundedHull, HoldsAllPointsWithFewVerticesAndASmallRadius) {
  Random random(2);
  std::vector<Vec3> round;
  std::vector<Vec3> flat;
  for (int i = 0; i < 3000; ++i) {
    round.push_back(random_direction(random));
    flat.emplace_back(uniform(random, 0, 1), uniform(random, 0, 2), 0.3);
  }
  for (const auto& points : {round, flat}) {
    const RoundedHull hull = rounded_hull(points);
    EXPECT_LE(hull.vertices.size(), kMostHullVertices);
    EXPECT_LT(hull.radius, 0.1);
    expect_holds(hull, points);
  }
}

TEST(RoundedHull, OfABoxIsTheBox) {
  const auto points = test_scenes::box_mesh(Vec3(1, 2, 3))->vertices;
  const RoundedHull hull = rounded_hull(points);
  EXPECT_EQ(hull.vertices.size(), 8U);
  EXPECT_LT(hull.radius, 1e-12);
}

TEST(RoundedHull, OfOnePointOrALineIsThat) {
  EXPECT_EQ(rounded_hull(std::vector<Vec3>{Vec3(1, 2, 3)}).vertices.size(), 1U);
  std::vector<Vec3> line;
  for (int i = 0; i <= 10; ++i) line.emplace_back(0.1 * i, 0, 0);
  const RoundedHull hull = rounded_hull(line);
  expect_holds(hull, line);
  EXPECT_LT(hull.radius, 0.01);
}

}  // namespace
}  // namespace accord
