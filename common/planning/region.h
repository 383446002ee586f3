// Boxes in configuration spaces, and points spread over them.
#pragma once

#include <cstdint>
#include <span>

#include "common/model/scene.h"
#include "common/planning/subproblem.h"

namespace accord {

// The whole configuration space of a robot as a box: scene bounds for translations, limits for
// joints, one turn for what wraps and for joints without limits.
// Requires: mobile robots have scene bounds.
Region whole_region(const Scene& scene, RobotId robot);

// Writes point `index` of a Halton sequence over the region, told apart by its seed, into q.
void sample_region(const Region& region, std::uint64_t index, std::uint64_t seed,
                   std::span<double> q);

}  // namespace accord
