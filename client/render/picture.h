// A still picture of a scene and, where there is one, of its plan: what `accord render` writes.
#pragma once

#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

// An SVG document: bounds, obstacles, every robot at its start (filled) and at its goal (outlined),
// and with a plan its way and, for carts and arms, faded poses along it. A spatial scene is seen
// from above and from the side. `plan` may be null; paths of robots that the scene does not know
// are left out.
std::string draw(const Scene& scene, const Plan* plan);

}  // namespace accord
