#include "worker/robot_roadmap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/query_counter.h"
#include "common/planning/region.h"
#include "worker/free_samples.h"

namespace accord {
namespace {

// Nodes of level 0, and the factor from level to level.
constexpr std::size_t kNodesPerDof = 400;
constexpr std::size_t kGrowth = 4;
constexpr std::size_t kMostNodes = 400'000;  // of any level: some hundred megabytes
// The level that the roadmap for traffic has at most: the one after takes seconds to lay, and is
// for doors that a robot hardly fits through.
constexpr std::size_t kDensestForTraffic = 3;
// Nodes around a place where another robot may stand, and the air (m) between them and it.
constexpr int kCorners = 12;
constexpr double kAir = 5e-3;

std::size_t samples_of_level(const RobotModel& model, std::size_t level) {
  std::size_t samples = kNodesPerDof * model.dof();
  for (std::size_t i = 0; i < level; ++i) samples *= kGrowth;
  return std::min(samples, kMostNodes);
}

// The number of nodes at which they lie no further apart than the robot is large, if a level has
// it.
std::size_t dense_samples(const CollisionWorld& world, RobotId id) {
  const Robot& robot = world.scene().robot(id);
  const Aabb body = world.swept_bounds(id, robot.start, robot.start);
  const Region whole = whole_region(world.scene(), id);
  double bodies = 1;  // that fill the space
  for (std::size_t k = 0; k < robot.model->translations(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    bodies *= (whole.upper[k] - whole.lower[k]) / (body.max[axis] - body.min[axis]);
  }
  std::size_t level = 0;
  while (level < kDensestForTraffic &&
         static_cast<double>(samples_of_level(*robot.model, level)) < bodies) {
    ++level;
  }
  return samples_of_level(*robot.model, level);
}

// Corners of a polygon around where another disc stands, along whose sides a disc gets past it.
void add_detour(const CollisionWorld& world, RobotId robot, RobotId other, ConfigurationView place,
                std::vector<Configuration>& out) {
  const double distance = *world.radius(robot) + *world.radius(other) + world.required_separation();
  const double reach = distance / std::cos(std::numbers::pi / kCorners) + kAir;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    Configuration q{place[0] + reach * std::cos(angle), place[1] + reach * std::sin(angle)};
    if (world.is_free(robot, q)) out.push_back(std::move(q));
  }
}

}  // namespace

RobotRoadmap::RobotRoadmap(const CollisionWorld& world, RobotId robot)
    : world_(world), robot_(robot), levels_(kLevels) {}

const SharedRoadmap& RobotRoadmap::level(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  if (!levels_[index]) {
    const SeparateCost cost;
    const std::size_t samples = samples_of_level(*world_.scene().robot(robot_).model, index);
    levels_[index] =
        std::make_unique<SharedRoadmap>(world_, robot_, free_samples(world_, robot_, samples));
  }
  return *levels_[index];
}

const SharedRoadmap& RobotRoadmap::dense() const {
  const std::lock_guard lock(mutex_);
  if (!dense_) {
    const SeparateCost cost;
    std::vector<Configuration> nodes = free_samples(world_, robot_, dense_samples(world_, robot_));
    const auto is_disc = [this](RobotId id) {
      return world_.radius(id) && world_.scene().robot(id).model->dof() == 2;
    };
    const auto robots = static_cast<std::uint32_t>(world_.scene().robots.size());
    for (std::uint32_t other = 0; is_disc(robot_) && other < robots; ++other) {
      if (!is_disc({other})) continue;
      const Robot& robot = world_.scene().robot({other});
      add_detour(world_, robot_, {other}, robot.start, nodes);
      add_detour(world_, robot_, {other}, robot.goal, nodes);
    }
    dense_ = std::make_unique<SharedRoadmap>(world_, robot_, std::move(nodes));
  }
  return *dense_;
}

}  // namespace accord
