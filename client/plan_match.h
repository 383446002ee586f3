// Whether a plan was made for a scene, for commands that need more of that than the verifier's
// verdict or no verdict at all.
#pragma once

#include <optional>
#include <string>

#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

// A sentence, for people to notice, where the plan names another scene than this one.
std::optional<std::string> other_scene(const Scene& scene, const Plan& plan);

// A sentence that names a robot of which only one of the two knows, or whose configurations have
// another size in the plan than in the scene; nullopt: the plan's paths can be drawn in the scene.
// A plan that is not solved has no paths, which is fine.
std::optional<std::string> other_robots(const Scene& scene, const Plan& plan);

}  // namespace accord
