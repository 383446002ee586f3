#include "worker/workspace.h"

#include "common/model/roadmap_places.h"

namespace accord {

Workspace::Workspace(const CollisionWorld& world) : world_(world) {
  const std::vector<std::uint32_t> places = roadmap_places(world.scene());
  std::vector<std::shared_ptr<RobotRoadmap>> by_place;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (places[i] == by_place.size()) {
      by_place.push_back(std::make_shared<RobotRoadmap>(world, RobotId{i}));
    }
    roadmaps_.push_back(by_place[places[i]]);
  }
}

}  // namespace accord
