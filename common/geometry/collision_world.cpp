#include "common/geometry/collision_world.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "common/geometry/point_motion.h"
#include "common/geometry/world_core.h"

namespace accord {
namespace {

Vec3 point(ConfigurationView q, bool planar) {
  return {q[0], q[1], planar ? 0.0 : q[2]};
}

Aabb in_space(const Extent<2>& e) {
  return {{e.min.x(), e.min.y(), 0}, {e.max.x(), e.max.y(), 0}};
}
Aabb in_space(const Extent<3>& e) {
  return {e.min, e.max};
}

}  // namespace

struct CollisionWorld::Impl {
  // Calls what with the core of the scene's dimension.
  template <typename What>
  decltype(auto) ask(What&& what) const {
    return planar ? what(*planar) : what(*spatial);
  }

  Impl(const Scene& scene, double margin) {
    if (scene.planar) {
      planar.emplace(scene, margin);
    } else {
      spatial.emplace(scene, margin);
    }
    for (std::uint32_t i = 0; i < scene.robots.size(); ++i) {
      radii.push_back(ask([&](const auto& core) { return core.chain({i}).radius(); }));
    }
    apart = ask([](const auto& core) { return core.apart(); });
  }

  // Whether both are discs or balls.
  bool are_round(RobotId a, RobotId b) const {
    return radii[a.index()] >= 0 && radii[b.index()] >= 0;
  }
  // The u up to which two discs or balls keep apart on linear motions.
  std::optional<double> round_contact(RobotId a, ConfigurationView from_a, ConfigurationView to_a,
                                      RobotId b, ConfigurationView from_b,
                                      ConfigurationView to_b) const {
    ask([](const auto& core) { core.counter().add(1); });
    const Vec3 from = point(from_b, planar.has_value()) - point(from_a, planar.has_value());
    const Vec3 to = point(to_b, planar.has_value()) - point(to_a, planar.has_value());
    return first_within(from, to - from, radii[a.index()] + radii[b.index()] + apart);
  }

  std::optional<WorldCore<2>> planar;
  std::optional<WorldCore<3>> spatial;
  std::vector<double> radii;  // of discs and balls; negative for the rest
  double apart = 0;
};

CollisionWorld::CollisionWorld(std::shared_ptr<const Scene> scene, double margin)
    : scene_(std::move(scene)), impl_(std::make_unique<Impl>(*scene_, margin)), margin_(margin) {}

CollisionWorld::~CollisionWorld() = default;

bool CollisionWorld::is_free(RobotId robot, ConfigurationView q) const {
  return impl_->ask([&](const auto& core) { return core.is_free(robot, q); });
}

std::optional<Fault> CollisionWorld::fault(RobotId robot, ConfigurationView q) const {
  return impl_->ask([&](const auto& core) { return core.fault(robot, q); });
}

bool CollisionWorld::motion_is_free(RobotId robot, ConfigurationView a, ConfigurationView b) const {
  return impl_->ask([&](const auto& core) { return core.motion_is_free(robot, a, b); });
}

std::optional<double> CollisionWorld::first_fault(RobotId robot, ConfigurationView a,
                                                  ConfigurationView b) const {
  return impl_->ask([&](const auto& core) { return core.first_fault(robot, a, b); });
}

double CollisionWorld::obstacle_distance(RobotId robot, ConfigurationView q, double cutoff) const {
  return impl_->ask([&](const auto& core) { return core.obstacle_distance(robot, q, cutoff); });
}

double CollisionWorld::separation(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb,
                                  double cutoff) const {
  return impl_->ask([&](const auto& core) { return core.separation(a, qa, b, qb, cutoff); });
}

bool CollisionWorld::are_clear(RobotId a, ConfigurationView qa, RobotId b,
                               ConfigurationView qb) const {
  return motions_are_clear(a, qa, qa, b, qb, qb);
}

bool CollisionWorld::motions_are_clear(RobotId a, ConfigurationView from_a, ConfigurationView to_a,
                                       RobotId b, ConfigurationView from_b,
                                       ConfigurationView to_b) const {
  if (impl_->are_round(a, b)) return !impl_->round_contact(a, from_a, to_a, b, from_b, to_b);
  return impl_->ask(
      [&](const auto& core) { return core.motions_are_clear(a, from_a, to_a, b, from_b, to_b); });
}

Fault CollisionWorld::closest(RobotId a, ConfigurationView qa, RobotId b,
                              ConfigurationView qb) const {
  return impl_->ask([&](const auto& core) { return core.closest(a, qa, b, qb); });
}

std::optional<double> CollisionWorld::first_contact(RobotId a, const Motion& motion_a, RobotId b,
                                                    const Motion& motion_b) const {
  std::optional<double> u;
  if (impl_->are_round(a, b)) {
    u = impl_->round_contact(a, motion_a.from, motion_a.to, b, motion_b.from, motion_b.to);
  } else {
    u = impl_->ask([&](const auto& core) {
      return core.first_contact(a, motion_a.from, motion_a.to, b, motion_b.from, motion_b.to);
    });
  }
  if (!u) return std::nullopt;
  return motion_a.t0 + *u * (motion_a.t1 - motion_a.t0);
}

double CollisionWorld::required_separation() const {
  return scene_->clearance + margin_;
}

Aabb CollisionWorld::swept_bounds(RobotId robot, ConfigurationView a, ConfigurationView b) const {
  return impl_->ask([&](const auto& core) { return in_space(core.swept_bounds(robot, a, b)); });
}

std::span<const double> CollisionWorld::reach(RobotId robot) const {
  return impl_->ask([&](const auto& core) { return core.chain(robot).reach(); });
}

std::optional<double> CollisionWorld::radius(RobotId robot) const {
  const double radius = impl_->radii[robot.index()];
  if (radius < 0) return std::nullopt;
  return radius;
}

std::uint64_t CollisionWorld::distance_queries() const {
  return impl_->ask([](const auto& core) { return core.counter().total(); });
}

void CollisionWorld::count_distance_queries(std::uint64_t n) const {
  impl_->ask([n](const auto& core) { core.counter().add(n); });
}

}  // namespace accord
