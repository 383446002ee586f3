#include "worker/workspace.h"

#include <algorithm>

#include "common/model/roadmap_places.h"

namespace accord {

Workspace::Workspace(const CollisionWorld& world) : world_(world) {
  const std::vector<std::uint32_t> places = roadmap_places(world.scene());
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const auto first = std::ranges::find(places, places[i]) - places.begin();
    const bool is_first = first == static_cast<std::ptrdiff_t>(i);
    roadmaps_.push_back(is_first ? std::make_shared<RobotRoadmap>(world, RobotId{i})
                                 : roadmaps_[static_cast<std::size_t>(first)]);
  }
}

}  // namespace accord
