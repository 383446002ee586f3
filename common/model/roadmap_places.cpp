#include "common/model/roadmap_places.h"

#include <map>
#include <tuple>

namespace accord {

std::vector<std::uint32_t> roadmap_places(const Scene& scene) {
  using Place = std::tuple<const RobotModel*, std::vector<double>>;
  std::map<Place, std::uint32_t> known;
  std::vector<std::uint32_t> places;
  places.reserve(scene.robots.size());
  for (const Robot& robot : scene.robots) {
    const auto& m = robot.base.matrix();
    const auto next = static_cast<std::uint32_t>(known.size());
    Place place{robot.model.get(), std::vector<double>(m.data(), m.data() + m.size())};
    places.push_back(known.emplace(std::move(place), next).first->second);
  }
  return places;
}

}  // namespace accord
