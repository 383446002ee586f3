#include "coordinator/dispatch/roadmap_partners.h"

namespace accord {
namespace {

// What boxes have in common: m^2 or m^3.
double overlap(const Aabb& a, const Aabb& b, bool planar) {
  const Vec3 common = (a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min)).cwiseMax(0);
  return planar ? common.head<2>().prod() : common.prod();
}

}  // namespace

RoadmapPartners roadmap_partners(const CollisionWorld& world,
                                 const std::vector<RoadmapPlace>& places) {
  const auto& robots = world.scene().robots;
  std::vector<Aabb> ways;  // by place
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    const Aabb way = world.swept_bounds({i}, robots[i].start, robots[i].goal);
    if (places[i] == ways.size()) {
      ways.push_back(way);
    } else {
      ways[places[i]].merge(way);
    }
  }
  RoadmapPartners partners;
  for (RoadmapPlace a = 0; a < ways.size(); ++a) {
    double most = 0;
    partners.push_back(a);
    for (RoadmapPlace b = 0; b < ways.size(); ++b) {
      const double common = overlap(ways[a], ways[b], world.scene().planar);
      if (a == b || common <= most) continue;
      most = common;
      partners.back() = b;
    }
  }
  return partners;
}

}  // namespace accord
