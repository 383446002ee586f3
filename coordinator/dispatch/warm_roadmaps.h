// Which worker has built which roadmaps, as far as is known from what it was given: tasks go where
// they need not be built once more. Of influence on speed only.
// Not thread safe.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "common/io/wire/scene_hash.h"
#include "common/transport/endpoint_id.h"

namespace accord {

// The number of a place whose robots share a roadmap (common/model/roadmap_places.h).
using RoadmapPlace = std::uint32_t;

// By place: the one whose robots its robots are most likely to meet, itself for none. Empty:
// nothing is known.
using RoadmapPartners = std::vector<RoadmapPlace>;

class WarmRoadmaps {
 public:
  // How well a worker is prepared for a task, the best first.
  enum class Warmth : std::uint8_t {
    kWarm,             // it has all the roadmaps
    kBesideWarm,       // nobody has those that it lacks, but it has a partner's
    kCold,             // nobody has those that it lacks
    kBesideElsewhere,  // nobody has, but another worker has a partner's
    kElsewhere,        // another worker has one that it lacks
  };

  Warmth warmth(const SceneHash& scene, std::span<const RoadmapPlace> places,
                const RoadmapPartners& partners, EndpointId worker) const;

  // It was given a task that needs them.
  void add(const SceneHash& scene, std::span<const RoadmapPlace> places, EndpointId worker);
  void forget(const SceneHash& scene) { scenes_.erase(scene); }
  void forget(EndpointId worker);

 private:
  using Owners = std::map<RoadmapPlace, std::set<EndpointId>>;

  static Warmth warmth(const Owners& owners, RoadmapPlace place, const RoadmapPartners& partners,
                       EndpointId worker);

  std::map<SceneHash, Owners> scenes_;
};

}  // namespace accord
