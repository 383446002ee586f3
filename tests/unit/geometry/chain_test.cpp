#include "common/geometry/chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "common/geometry/traveller.h"
#include "tests/contract/reference_geometry.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using namespace test_scenes;

Vec3 in_space(const Vec<2>& p) {
  return {p.x(), p.y(), 0};
}
Vec3 in_space(const Vec<3>& p) {
  return p;
}

struct Subject {
  std::shared_ptr<const RobotModel> model;
  Pose base;
};

std::vector<Subject> planar_subjects() {
  return {{planar_arm(), at(1, 2, 0, 0, 0, 0.5)},
          {planar_arm(), at(-1, 0, 0, 3.14159265358979, 0, 0.5)},  // upside down
          {footprint(ell()), Pose::Identity()},
          {disk(0.3), Pose::Identity()}};
}

std::vector<Subject> spatial_subjects() {
  return {{six_joint_arm(), at(1, 2, 3, 0.1, 0.2, 0.3)},
          {odd_arm(), at(-1, 0, 0.5, 0.4, -0.2, 2)},
          {ball(0.3), Pose::Identity()}};
}

// Centres of pieces against the model's bodies placed by the textbook.
template <int D>
void expect_places_as_by_textbook(const std::vector<Subject>& subjects) {
  Random random(1);
  for (const Subject& subject : subjects) {
    const Robot r = robot("r", subject.model, subject.base);
    MeshCache meshes;
    const Chain<D> chain(r, meshes);
    std::vector<Frame<D>> frames(chain.links().size());
    for (int k = 0; k < 50; ++k) {
      const auto q = random_configuration(*subject.model, random, 4);
      const auto poses = reference::link_poses(r, q);
      chain.place(q.data(), frames.data());
      for (const auto& p : chain.pieces()) {
        const Body& body = subject.model->bodies[static_cast<std::size_t>(p.body)];
        const Pose pose = poses[static_cast<std::size_t>(body.link)] * body.pose;
        const Frame<D> frame = frames[static_cast<std::size_t>(p.link)] * p.piece.frame;
        if (std::holds_alternative<Polygon>(body.shape)) continue;  // cut in pieces
        EXPECT_LT((in_space(frame.t) - pose.translation()).norm(), 1e-12);
        if (p.piece.core == Core::kPoint) continue;
        // A planar rectangle's axis is that of one of its edges.
        const Vec3 axis = in_space(frame.axis());
        const double along = D == 2 ? std::max(std::abs(axis.dot(pose.linear().col(0))),
                                               std::abs(axis.dot(pose.linear().col(1))))
                                    : std::abs(axis.dot(pose.linear().col(2)));
        EXPECT_NEAR(along, 1, 1e-9);
      }
    }
  }
}

TEST(Chain, PlacesBodiesAsTheTextbookDoes) {
  expect_places_as_by_textbook<2>(planar_subjects());
  expect_places_as_by_textbook<3>(spatial_subjects());
}

template <int D>
std::vector<Vec<D>> core_points(const Placed<D>& placed, Random& random) {
  std::vector<Vec<D>> points{placed.frame.t};
  const Piece<D>& piece = *placed.piece;
  for (int i = 0; i < 8; ++i) {
    Vec<D> p = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis) p[axis] = uniform(random, 0, 1) < 0.5 ? -1 : 1;
    if (piece.core == Core::kBox || piece.core == Core::kMesh)
      p = p.cwiseProduct(piece.half).eval();
    if (piece.core == Core::kSegment || piece.core == Core::kPoint ||
        piece.core == Core::kPolygon) {
      p.setZero();
    }
    if constexpr (D == 2) {
      if (piece.core == Core::kPolygon)
        p = piece.vertices[static_cast<std::size_t>(i % piece.vertex_count)];
    } else {
      if (piece.core == Core::kSegment) p.z() = piece.half.x();
      if (piece.core == Core::kCylinder) {
        const double angle = uniform(random, 0, 7);
        p = {piece.half.y() * std::cos(angle), piece.half.y() * std::sin(angle), piece.half.x()};
      }
    }
    points.push_back(placed.frame(p));
  }
  return points;
}

// Velocities against differences, and the bounds on motion against both.
template <int D>
void expect_moves_within_bounds(const std::vector<Subject>& subjects) {
  constexpr double kStep = 1e-5;
  Random random(2);
  for (const Subject& subject : subjects) {
    MeshCache meshes;
    const Chain<D> chain(robot("r", subject.model, subject.base), meshes);
    Traveller<D> traveller;
    double tightest = 0;
    for (int k = 0; k < 200; ++k) {
      const auto a = random_configuration(*subject.model, random, 4);
      auto b = a;
      for (double& value : b) value += uniform(random, -1, 1);
      traveller.start(chain, a, b);
      const double u = uniform(random, 0.1, 0.9);
      for (int i = 0; i < static_cast<int>(chain.pieces().size()); ++i) {
        const int link = chain.pieces()[static_cast<std::size_t>(i)].link;
        traveller.move_to(u);
        const Placed<D> now = traveller.piece(i);
        const Twist<D> twist = traveller.twist(link);
        const Vec<D> origin = traveller.frame(link).t;
        traveller.move_to(u - kStep);
        const Placed<D> before = traveller.piece(i);
        traveller.move_to(u + kStep);
        const Placed<D> after = traveller.piece(i);
        for (const Vec<D>& point : core_points(now, random)) {
          const Vec<D> local = now.frame.inverse(point);
          const Vec<D> p = before.frame(local);
          const Vec<D> q = after.frame(local);
          const Vec<D> velocity = (q - p) / (2 * kStep);
          EXPECT_LT((velocity - twist.at(point - origin)).norm(), 1e-6);
          const double speed = (velocity - traveller.drift()).norm();
          EXPECT_LT(speed, traveller.pace(i).speed + 1e-6);
          const double bend = (p + q - 2 * point).norm() / (kStep * kStep);
          EXPECT_LT(bend, traveller.pace(i).bend + 1e-3);
          if (traveller.pace(i).speed > 0) {
            tightest = std::max(tightest, speed / traveller.pace(i).speed);
          }
        }
      }
    }
    if (chain.turns()) {
      EXPECT_GT(tightest, 0.7);
    }
  }
}

TEST(Chain, MovesWithinItsBounds) {
  expect_moves_within_bounds<2>(planar_subjects());
  expect_moves_within_bounds<3>(spatial_subjects());
}

TEST(Chain, ReachHoldsEveryPoint) {
  Random random(3);
  for (const Subject& subject : spatial_subjects()) {
    MeshCache meshes;
    const Chain<3> chain(robot("r", subject.model, subject.base), meshes);
    Traveller<3> traveller;
    for (int k = 0; k < 100; ++k) {
      const auto a = random_configuration(*subject.model, random, 3);
      for (std::size_t dof = 0; dof < a.size(); ++dof) {
        auto b = a;
        b[dof] += 1e-6;
        traveller.start(chain, a, b);
        for (int i = 0; i < static_cast<int>(chain.pieces().size()); ++i) {
          traveller.move_to(0);
          const Placed<3> before = traveller.piece(i);
          traveller.move_to(1);
          const Placed<3> after = traveller.piece(i);
          for (const Vec3& point : core_points(before, random)) {
            const Vec3 moved = after.frame(before.frame.inverse(point));
            EXPECT_LT((moved - point).norm(), 1e-6 * chain.reach()[dof] + 1e-12);
            if (chain.mobile()) continue;
            const Extent<3> all = chain.reach_box().inflated(1e-9);
            EXPECT_TRUE(all.overlaps({point, point}));
          }
        }
      }
    }
  }
}

TEST(Chain, KnowsWhichBodiesMustNotTouch) {
  MeshCache meshes;
  const Chain<2> chain(robot("r", planar_arm()), meshes);
  ASSERT_EQ(chain.self_pairs().size(), 1U);
  EXPECT_EQ(chain.self_pairs()[0].a, 0);
  EXPECT_EQ(chain.self_pairs()[0].b, 2);
  EXPECT_EQ(chain.self_pairs()[0].ancestor, 1);
}

template <int D>
std::string rejection(const Robot& robot) {
  try {
    MeshCache meshes;
    const Chain<D> chain(robot, meshes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(Chain, RejectsWhatDoesNotFitTheScene) {
  EXPECT_EQ(rejection<2>(robot("a", ball(1))), "robot \"a\": a ball needs a spatial scene");
  EXPECT_EQ(rejection<3>(robot("a", disk(1))), "robot \"a\": its model needs a planar scene");
  EXPECT_EQ(rejection<2>(robot("a", six_joint_arm())),
            "robot \"a\": the axis of joint \"joint2\" is not parallel to z");
  EXPECT_EQ(rejection<2>(robot("a", planar_arm(), at(0, 0, 1))),
            "robot \"a\": body \"link1\" does not meet the plane z = 0");
  EXPECT_NE(rejection<2>(robot("a", disk(1), at(1, 0))), "none");
}

}  // namespace
}  // namespace accord
