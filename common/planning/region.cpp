#include "common/planning/region.h"

#include <cmath>
#include <numbers>

#include "common/planning/random.h"

namespace accord {

Region whole_region(const Scene& scene, RobotId id) {
  const RobotModel& model = *scene.robot(id).model;
  Region region;
  for (std::size_t k = 0; k < model.dof(); ++k) {
    const DegreeOfFreedom& dof = model.dofs[k];
    const auto axis = static_cast<Eigen::Index>(k);
    if (k < model.translations() && scene.bounds) {
      region.lower.push_back(scene.bounds->min[axis]);
      region.upper.push_back(scene.bounds->max[axis]);
    } else if (dof.wraps || !std::isfinite(dof.lower) || !std::isfinite(dof.upper)) {
      region.lower.push_back(-std::numbers::pi);
      region.upper.push_back(std::numbers::pi);
    } else {
      region.lower.push_back(dof.lower);
      region.upper.push_back(dof.upper);
    }
  }
  return region;
}

void sample_region(const Region& region, std::uint64_t index, std::uint64_t seed,
                   std::span<double> q) {
  for (std::size_t k = 0; k < q.size(); ++k) {
    q[k] = region.lower[k] + halton(index, k, seed) * (region.upper[k] - region.lower[k]);
  }
}

}  // namespace accord
