#include "worker/workspace.h"

#include <map>
#include <tuple>

namespace accord {
namespace {

// Robots with equal keys share a roadmap: same model, same place.
using Place = std::tuple<const RobotModel*, std::vector<double>>;

Place place_of(const Robot& robot) {
  const auto& m = robot.base.matrix();
  return {robot.model.get(), std::vector<double>(m.data(), m.data() + m.size())};
}

}  // namespace

Workspace::Workspace(const CollisionWorld& world) : world_(world) {
  std::map<Place, std::shared_ptr<RobotRoadmap>> known;
  const auto count = static_cast<std::uint32_t>(world.scene().robots.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    auto& roadmap = known[place_of(world.scene().robot({i}))];
    if (!roadmap) roadmap = std::make_shared<RobotRoadmap>(world, RobotId{i});
    roadmaps_.push_back(roadmap);
  }
}

}  // namespace accord
