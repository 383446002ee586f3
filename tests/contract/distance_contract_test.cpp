// Every distance path (each pair of shapes, planar and spatial) against a reference that is
// independent of it, in the placements that break distance algorithms: aligned with the grid,
// touching, deep inside each other, nearly parallel, far from the origin.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "common/geometry/compile_shape.h"
#include "common/geometry/gap.h"
#include "common/geometry/mesh_surface.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

constexpr double kPi = std::numbers::pi;

struct PlacedShape {
  Shape shape;
  Pose pose;
};

using Distance = std::function<double(const PlacedShape&, const PlacedShape&)>;

// What is under test: the least gap over the two shapes' pieces.
template <int D>
double distance_by_gap(const PlacedShape& a, const PlacedShape& b) {
  MeshCache meshes;
  double least = 1e300;
  for (const Piece<D>& p : compile_shape<D>(a.shape, a.pose, meshes)) {
    for (const Piece<D>& q : compile_shape<D>(b.shape, b.pose, meshes)) {
      const Placed<D> pp{&p, p.frame};
      const Placed<D> pq{&q, q.frame};
      const Gap<D> there = gap(pp, pq, Wanted{}, Vec<D>(Vec<D>::Zero()));
      least = std::min(least, there.distance - p.radius - q.radius);
    }
  }
  return std::max(least, 0.0);
}

// ---- Placements ----

enum class Placement { kRandom, kFar, kGrid, kTouching, kDeep, kParallel };

Pose random_planar_pose(Random& random, double span) {
  return at(uniform(random, -span, span), uniform(random, -span, span), 0, 0, 0,
            uniform(random, -kPi, kPi));
}

Pose place(Placement placement, bool planar, Random& random) {
  const auto any = [&](double span) {
    return planar ? random_planar_pose(random, span) : random_pose(random, span);
  };
  const auto grid = [&](double step) {
    return step * static_cast<double>(std::uniform_int_distribution<int>(-6, 6)(random));
  };
  const auto quarter = [&] {
    return kPi / 2 * static_cast<double>(std::uniform_int_distribution<int>(0, 3)(random));
  };
  switch (placement) {
    case Placement::kRandom:
      return any(1.2);
    case Placement::kFar: {
      Pose pose = any(1.2);
      pose.translation() += Vec3(183, -95, planar ? 0 : 40);
      return pose;
    }
    case Placement::kGrid:
    case Placement::kTouching: {  // sizes are multiples of the grid, so that many touch
      const double z = planar ? 0 : grid(0.1);
      const double step = placement == Placement::kGrid ? 0.25 : 0.1;
      const double roll = planar ? 0 : quarter();
      const double x = grid(step);
      const double y = grid(step);
      return at(x, y, z, roll, planar ? 0 : quarter(), quarter());
    }
    case Placement::kDeep:
      return any(0.1);
    case Placement::kParallel: {
      Pose pose = at(grid(0.1), grid(0.1), planar ? 0 : grid(0.1));
      const double tilt = std::pow(10, uniform(random, -12, -2));
      if (planar) return pose * at(0, 0, 0, 0, 0, tilt);
      return pose * at(0, 0, 0, uniform(random, -tilt, tilt), tilt, uniform(random, -tilt, tilt));
    }
  }
  return Pose::Identity();
}

// ---- The contract ----

struct Report {
  int cases = 0;
  int overestimates = 0;  // a certificate would be wrong
  int loose = 0;          // it would be of no use
  int judged = 0;         // cases where the reference knows how tight it is
  double worst_over = 0;
  double worst_loose = 0;
};

Report hold_against_reference(const Distance& distance, const Shape& a, const Shape& b, bool planar,
                              Placement placement, int cases) {
  constexpr double kRounding = 1e-11;
  constexpr double kTight = 1e-6;
  Random random(static_cast<std::uint64_t>(placement) + 5);
  Report report;
  for (int k = 0; k < cases; ++k) {
    const PlacedShape pa{a, place(placement, planar, random)};
    const PlacedShape pb{b, place(placement, planar, random)};
    const double value = distance(pa, pb);
    const auto truth = reference::distance(reference::sets_of(a, pa.pose, planar),
                                           reference::sets_of(b, pb.pose, planar));
    ++report.cases;
    if (value > truth.upper + kRounding) ++report.overestimates;
    report.worst_over = std::max(report.worst_over, value - truth.upper);
    if (truth.upper - truth.lower < kTight || truth.upper < kTight) ++report.judged;
    if (value < truth.lower - kTight) ++report.loose;
    report.worst_loose = std::max(report.worst_loose, truth.lower - value);
  }
  return report;
}

struct NamedShape {
  std::string name;
  Shape shape;
};

std::vector<NamedShape> planar_shapes() {
  return {{"disc", Sphere{0.3}},
          {"capsule_upright", Cylinder{0.1, 0.5}},
          {"square", Box{Vec3(0.4, 0.4, 0.2)}},
          {"bar", Box{Vec3(1.0, 0.02, 0.2)}},
          {"triangle", Polygon{{{-0.3, -0.2}, {0.5, -0.2}, {0.1, 0.4}}}},
          {"hexagon",
           Polygon{{{0.4, 0}, {0.2, 0.3}, {-0.2, 0.3}, {-0.4, 0}, {-0.2, -0.3}, {0.2, -0.3}}}}};
}

std::vector<NamedShape> spatial_shapes() {
  return {{"ball", Sphere{0.3}},
          {"capsule", Capsule{0.1, 0.6}},
          {"needle", Capsule{1e-4, 0.8}},
          {"can", Cylinder{0.2, 0.4}},
          {"rod", Cylinder{0.02, 1.0}},
          {"plate", Cylinder{0.5, 0.01}},
          {"box", Box{Vec3(0.4, 0.2, 0.6)}},
          {"wall", Box{Vec3(1.0, 0.01, 0.8)}},
          {"mesh", Mesh{ring_mesh(0.2, 0.4, 0.2, 6)}}};
}

using Case = std::tuple<bool, Placement>;

class DistanceContract : public testing::TestWithParam<Case> {};

TEST_P(DistanceContract, IsNeverTooLargeAndTight) {
  const auto [planar, placement] = GetParam();
  const Distance distance = planar ? Distance(distance_by_gap<2>) : Distance(distance_by_gap<3>);
  const auto shapes = planar ? planar_shapes() : spatial_shapes();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      const int meshes = (shapes[i].name == "mesh") + (shapes[j].name == "mesh");
      const int cases = planar ? 200 : (meshes == 0 ? 100 : (meshes == 1 ? 8 : 1));
      const Report report = hold_against_reference(distance, shapes[i].shape, shapes[j].shape,
                                                   planar, placement, cases);
      EXPECT_EQ(report.overestimates, 0)
          << shapes[i].name << " to " << shapes[j].name << " by " << report.worst_over;
      EXPECT_EQ(report.loose, 0) << shapes[i].name << " to " << shapes[j].name << " by "
                                 << report.worst_loose;
      EXPECT_GT(report.judged, report.cases / 2) << shapes[i].name << " to " << shapes[j].name;
    }
  }
}

const char* name_of(Placement placement) {
  constexpr std::array<const char*, 6> kNames{"random",   "far",  "grid",
                                              "touching", "deep", "parallel"};
  return kNames[static_cast<std::size_t>(placement)];
}

std::string placement_name(const testing::TestParamInfo<Case>& c) {
  const auto [planar, placement] = c.param;
  return std::string(planar ? "planar_" : "spatial_") + name_of(placement);
}

INSTANTIATE_TEST_SUITE_P(All, DistanceContract,
                         testing::Combine(testing::Bool(),
                                          testing::Values(Placement::kRandom, Placement::kFar,
                                                          Placement::kGrid, Placement::kTouching,
                                                          Placement::kDeep, Placement::kParallel)),
                         placement_name);

// ---- The contract tells wrong implementations from right ones ----

int violations(const Distance& distance, Placement placement) {
  const Report report = hold_against_reference(distance, Box{Vec3(0.4, 0.2, 0.6)},
                                               Cylinder{0.2, 0.4}, false, placement, 100);
  return report.overestimates + report.loose;
}

TEST(WrongDistance, FailsTheContractWhereItIsSlightlyTooLarge) {
  const Distance wrong = [](const auto& a, const auto& b) {
    return distance_by_gap<3>(a, b) + 1e-9;
  };
  EXPECT_GT(violations(wrong, Placement::kRandom), 0);
}

TEST(WrongDistance, FailsTheContractWhereItIsThatOfBoundingBalls) {
  const Distance wrong = [](const PlacedShape& a, const PlacedShape& b) {
    const double apart = (a.pose.translation() - b.pose.translation()).norm();
    return std::max(apart - 0.4 - 0.3, 0.0);
  };
  EXPECT_GT(violations(wrong, Placement::kRandom), 0);
}

TEST(WrongDistance, FailsTheContractWhereItComesFromCorners) {
  // The distance from a box's corners to the other shape, as if boxes had no edges or faces.
  const Distance wrong = [](const PlacedShape& a, const PlacedShape& b) {
    const Vec3 half = std::get<Box>(a.shape).size / 2;
    double least = 1e300;
    for (unsigned i = 0; i < 8; ++i) {
      const Vec3 corner((i & 1U) != 0 ? half.x() : -half.x(), (i & 2U) != 0 ? half.y() : -half.y(),
                        (i & 4U) != 0 ? half.z() : -half.z());
      Pose pose = Pose::Identity();
      pose.translation() = a.pose * corner;
      least = std::min(least, distance_by_gap<3>({Sphere{0}, pose}, b));
    }
    return least;
  };
  EXPECT_GT(violations(wrong, Placement::kRandom), 0);
  EXPECT_GT(violations(wrong, Placement::kDeep), 0);
}

// ---- FCL as a second opinion on contact, where it can be trusted (platform.md) ----

std::shared_ptr<fcl::CollisionGeometryd> fcl_shape(const Shape& shape) {
  if (const auto* s = std::get_if<Sphere>(&shape)) return std::make_shared<fcl::Sphered>(s->radius);
  if (const auto* s = std::get_if<Box>(&shape)) return std::make_shared<fcl::Boxd>(s->size);
  if (const auto* s = std::get_if<Cylinder>(&shape)) {
    return std::make_shared<fcl::Cylinderd>(s->radius, s->length);
  }
  if (const auto* s = std::get_if<Capsule>(&shape)) {
    return std::make_shared<fcl::Capsuled>(s->radius, s->length);
  }
  const auto& surface = *std::get<Mesh>(shape).surface;
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : surface.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel();
  model->addSubModel(surface.vertices, triangles);
  model->endModel();
  return model;
}

bool collides_by_fcl(const PlacedShape& a, const PlacedShape& b) {
  const fcl::CollisionObjectd oa(fcl_shape(a.shape), a.pose);
  const fcl::CollisionObjectd ob(fcl_shape(b.shape), b.pose);
  fcl::CollisionResultd result;
  fcl::collide(&oa, &ob, fcl::CollisionRequestd(), result);
  return result.isCollision();
}

class FclCollide : public testing::TestWithParam<Placement> {};

TEST_P(FclCollide, AgreesOnWhatTouches) {
  constexpr double kClear = 1e-6;  // nearer than this, either answer will do
  Random random(9);
  // Where shapes rest against each other exactly, FCL may call them apart.
  const bool rests = GetParam() != Placement::kRandom && GetParam() != Placement::kFar &&
                     GetParam() != Placement::kDeep;
  int touching = 0;
  const auto shapes = spatial_shapes();
  for (const auto& [name_a, a] : shapes) {
    for (const auto& [name_b, b] : shapes) {
      for (int k = 0; k < 200; ++k) {
        const PlacedShape pa{a, place(GetParam(), false, random)};
        const PlacedShape pb{b, place(GetParam(), false, random)};
        const double distance = distance_by_gap<3>(pa, pb);
        if (collides_by_fcl(pa, pb)) {
          EXPECT_LT(distance, kClear) << name_a << " to " << name_b;
          ++touching;
        } else if (!rests && !std::holds_alternative<Mesh>(a) && !std::holds_alternative<Mesh>(b)) {
          EXPECT_GT(distance, 0) << name_a << " to " << name_b;
        }
      }
    }
  }
  EXPECT_GT(touching, 400);
}

INSTANTIATE_TEST_SUITE_P(All, FclCollide,
                         testing::Values(Placement::kRandom, Placement::kFar, Placement::kGrid,
                                         Placement::kTouching, Placement::kDeep,
                                         Placement::kParallel),
                         [](const auto& c) { return std::string(name_of(c.param)); });

// ---- Half spaces: the bounds of a scene ----

TEST(HalfSpace, GapIsHowFarTheShapeStaysInside) {
  Random random(3);
  for (const auto& [name, shape] : spatial_shapes()) {
    for (int k = 0; k < 50; ++k) {
      const Pose pose = random_pose(random, 1);
      MeshCache meshes;
      const Piece<3> piece = compile_shape<3>(shape, pose, meshes).front();
      Piece<3> wall;
      wall.core = Core::kHalfSpace;
      wall.frame.t = Vec3(0, 0, 1.5);  // its axis is z: all beyond z = 1.5
      const Gap<3> there =
          gap(Placed<3>{&piece, piece.frame}, Placed<3>{&wall, wall.frame}, {}, Vec3(Vec3::Zero()));
      double highest = -1e300;
      for (const auto& set : reference::sets_of(shape, pose, false)) {
        highest = std::max(highest, set->support(Vec3::UnitZ()).z());
      }
      EXPECT_NEAR(there.distance - piece.radius, 1.5 - highest, 1e-12) << name;
    }
  }
}

}  // namespace
}  // namespace accord
