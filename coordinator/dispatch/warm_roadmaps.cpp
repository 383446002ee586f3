#include "coordinator/dispatch/warm_roadmaps.h"

#include <algorithm>

namespace accord {
namespace {

enum class Owner : std::uint8_t { kNobody, kSelf, kOther };

}  // namespace

WarmRoadmaps::Warmth WarmRoadmaps::warmth(const SceneHash& scene,
                                          std::span<const RoadmapPlace> places,
                                          const RoadmapPartners& partners,
                                          EndpointId worker) const {
  const auto found = scenes_.find(scene);
  if (found == scenes_.end()) return Warmth::kCold;
  Warmth worst = Warmth::kWarm;
  for (const RoadmapPlace place : places) {
    worst = std::max(worst, warmth(found->second, place, partners, worker));
  }
  return worst;
}

WarmRoadmaps::Warmth WarmRoadmaps::warmth(const Owners& owners, RoadmapPlace place,
                                          const RoadmapPartners& partners, EndpointId worker) {
  const auto owner_of = [&](RoadmapPlace wanted) {
    const auto known = owners.find(wanted);
    if (known == owners.end() || known->second.empty()) return Owner::kNobody;
    return known->second.contains(worker) ? Owner::kSelf : Owner::kOther;
  };
  if (const Owner owner = owner_of(place); owner != Owner::kNobody) {
    return owner == Owner::kSelf ? Warmth::kWarm : Warmth::kElsewhere;
  }
  if (place >= partners.size()) return Warmth::kCold;
  switch (owner_of(partners[place])) {
    case Owner::kSelf:
      return Warmth::kBesideWarm;
    case Owner::kOther:
      return Warmth::kBesideElsewhere;
    case Owner::kNobody:
      break;
  }
  return Warmth::kCold;
}

void WarmRoadmaps::add(const SceneHash& scene, std::span<const RoadmapPlace> places,
                       EndpointId worker) {
  Owners& owners = scenes_[scene];
  for (const RoadmapPlace place : places) owners[place].insert(worker);
}

void WarmRoadmaps::forget(EndpointId worker) {
  for (auto& [scene, owners] : scenes_) {
    for (auto& [place, workers] : owners) workers.erase(worker);
  }
}

}  // namespace accord
