// Which robots can share what is worked out about where they can go: those of the same model in the
// same place. Pure; thread safe.
#pragma once

#include <cstdint>
#include <vector>

#include "common/model/scene.h"

namespace accord {

// By robot: the number of its place. Places are numbered from 0 in the order of their first robots.
std::vector<std::uint32_t> roadmap_places(const Scene& scene);

}  // namespace accord
