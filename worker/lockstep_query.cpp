#include "worker/lockstep_query.h"

#include <algorithm>
#include <cmath>

#include "worker/lattice.h"
#include "worker/lockstep.h"

namespace accord {
namespace {

// Robots on neighbouring lines may go round corners one behind the other only where lines are
// this much farther apart than they have to keep.
constexpr double kRoomForCorners = 1.4143;
// Every step takes this much longer than it has to, so that rounding makes none too fast.
constexpr double kRounding = 1e-8;

Vec3 to_point(ConfigurationView q) {
  Vec3 point = Vec3::Zero();
  for (std::size_t k = 0; k < q.size(); ++k) point[static_cast<Eigen::Index>(k)] = q[k];
  return point;
}

// What all robots of the crowd can do.
struct Crowd {
  RobotId largest;
  std::size_t dof;
  double speed;  // m/s: the slowest robot's
  Aabb box;      // holds all regions
  std::vector<Lockstep::Traveller> travellers;
};

std::optional<Crowd> find_crowd(const CollisionWorld& world, const Subproblem& subproblem) {
  const Task& first = subproblem.tasks.front();
  const Vec3 somewhere = to_point(first.start);
  Crowd crowd{first.robot,
              first.start.size(),
              world.scene().robot(first.robot).model->speed,
              {somewhere, somewhere},
              {}};
  for (const Task& task : subproblem.tasks) {
    if (!world.radius(task.robot) || task.start.size() != crowd.dof) return std::nullopt;
    if (*world.radius(task.robot) > *world.radius(crowd.largest)) crowd.largest = task.robot;
    crowd.speed = std::min(crowd.speed, world.scene().robot(task.robot).model->speed);
    crowd.box.merge({to_point(task.region.lower), to_point(task.region.upper)});
    crowd.travellers.push_back({task.robot, to_point(task.start), to_point(task.goal)});
  }
  return crowd;
}

// A step takes `duration` (s). Waypoints only where a robot turns or waits.
Trajectory to_path(const std::vector<Vec3>& steps, std::size_t dof, double from, double duration) {
  constexpr double kSame = 1e-12;  // m
  std::size_t last = steps.size() - 1;
  while (last > 0 && steps[last - 1] == steps[last]) --last;
  Trajectory path(dof);
  for (std::size_t k = 0; k <= last; ++k) {
    const bool goes_on =
        k > 0 && k < last && (steps[k + 1] - 2 * steps[k] + steps[k - 1]).norm() < kSame;
    if (goes_on) continue;
    path.append(from + static_cast<double>(k) * duration, {steps[k].data(), dof});
  }
  return path;
}

}  // namespace

Resolution LockstepQuery::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                   const std::atomic<bool>& stop) const {
  const CollisionWorld& world = workspace.world();
  Resolution out;
  const std::optional<Crowd> crowd = find_crowd(world, subproblem);
  if (!crowd) return out;
  const double keep = 2 * *world.radius(crowd->largest) + world.required_separation();
  const double least = kRoomForCorners * keep;
  if (!(Lattice::places(crowd->box, least, crowd->dof) <= Lattice::kMostPlaces)) return out;
  const Lattice lattice(world, crowd->largest, crowd->box, least);
  Lockstep lockstep(world, lattice, crowd->travellers, subproblem.seed);
  out.solved = lockstep.run(stop) && !stop;
  out.effort.expansions = lockstep.moves();
  if (!out.solved) return out;
  out.solver = kName;
  out.end = subproblem.from;
  const double duration = lattice.spacing() / crowd->speed * (1 + kRounding);
  std::vector<std::vector<Vec3>> steps = lockstep.take_steps();
  const std::vector<std::vector<Vec3>> left = lockstep.ways_left();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!left[i].empty()) out.left.push_back(subproblem.tasks[i].robot);
    steps[i].insert(steps[i].end(), left[i].begin(), left[i].end());
    out.paths.push_back(to_path(steps[i], crowd->dof, subproblem.from, duration));
    out.end = std::max(out.end, out.paths.back().end_time());
  }
  return out;
}

}  // namespace accord
