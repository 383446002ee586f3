// Scenes, subproblems, resolutions and requests for the tests of the wire.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/model/plan_request.h"
#include "common/model/scene.h"
#include "common/planning/random.h"
#include "common/planning/subproblem.h"

namespace accord::wire_samples {

// File names of scenes/ that are scenes.
std::vector<std::string> example_scenes();
std::shared_ptr<const Scene> load_example(const std::string& name);

// Two discs and a cart among three obstacles: small enough to change every byte of.
std::shared_ptr<const Scene> small_scene();

// Any numbers that the codec is to carry, zeros of both signs and denormals among them.
double random_number(RandomStream& random, double least, double most);
Trajectory random_path(RandomStream& random, std::size_t dof, double from, std::size_t waypoints);
Subproblem random_subproblem(RandomStream& random, const Scene& scene);
Resolution random_resolution(RandomStream& random, const Subproblem& subproblem);
// Of a form that is sound; its scene is any bytes.
PlanRequest random_request(RandomStream& random);

}  // namespace accord::wire_samples
