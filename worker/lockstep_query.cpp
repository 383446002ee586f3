#include "worker/lockstep_query.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "worker/lattice.h"
#include "worker/lockstep.h"
#include "worker/point_traffic.h"
#include "worker/team.h"
#include "worker/timed_shortcuts.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Vec3 to_vec(ConfigurationView q) {
  Vec3 point = Vec3::Zero();
  for (std::size_t k = 0; k < q.size(); ++k) point[static_cast<Eigen::Index>(k)] = q[k];
  return point;
}

class LockstepSearch {
 public:
  LockstepSearch(const CollisionWorld& world, const Subproblem& subproblem,
                 const std::atomic<bool>& stop)
      : world_(world), subproblem_(subproblem), stop_(stop) {}

  Resolution run() {
    Resolution out;
    const double t0 = now();
    if (!find_paths(out)) return out;
    const double t1 = now();
    double before = 0, after = 0, lb = 0;
    for (const auto& p : out.paths) before += p.end_time() - subproblem_.from;
    for (const auto& p : subproblem_.tasks) lb += p.to - subproblem_.from;
    shorten(out);
    for (const auto& p : out.paths) after += p.end_time() - subproblem_.from;
    fprintf(stderr, "lockstep %zu robots: %.2f s, cost %.2f -> %.2f in %.2f s, moves %lu\n",
            subproblem_.tasks.size(), t1 - t0, before / lb, after / lb, now() - t1,
            out.effort.expansions);
    out.solved = true;
    out.end = subproblem_.from;
    for (const Trajectory& path : out.paths) out.end = std::max(out.end, path.end_time());
    return out;
  }

 private:
  RobotId robot(std::size_t i) const { return subproblem_.tasks[i].robot; }

  bool find_paths(Resolution& out) {
    RobotId largest = robot(0);
    double speed = kInfinity;
    const std::size_t dof = subproblem_.tasks[0].start.size();
    std::vector<Lockstep::Traveller> travellers;
    Aabb box{to_vec(subproblem_.tasks[0].start), to_vec(subproblem_.tasks[0].start)};
    for (const Task& task : subproblem_.tasks) {
      if (!world_.radius(task.robot) || task.start.size() != dof) return false;
      if (*world_.radius(task.robot) > *world_.radius(largest)) largest = task.robot;
      speed = std::min(speed, world_.scene().robot(task.robot).model->speed);
      travellers.push_back({task.robot, to_vec(task.start), to_vec(task.goal)});
      box.merge({to_vec(task.region.lower), to_vec(task.region.lower)});
      box.merge({to_vec(task.region.upper), to_vec(task.region.upper)});
    }
    const double keep = 2 * *world_.radius(largest) + world_.required_separation();
    const double spacing = 1.0001 * (getenv("SP") ? atof(getenv("SP")) : std::sqrt(2.0)) * keep;
    if (Lattice::places(box, spacing, dof) > Lattice::kMostPlaces) return false;
    const double t0 = now();
    const Lattice lattice(world_, largest, box, spacing);
    Lockstep lockstep(world_, lattice, std::move(travellers));
    fprintf(stderr, "lattice of %u in %.3f s\n", lattice.size(), now() - t0);
    const auto places = lockstep.run(2000, stop_);
    out.effort.expansions = lockstep.moves();
    fprintf(stderr, "ran in %.3f s, %s %zu\n", now() - t0, places ? "ok" : "FAILED",
            places ? (*places)[0].size() : 0);
    if (!places) return false;
    const double tick = lattice.spacing() / speed * (1 + 1e-9);
    for (const std::vector<Vec3>& steps : *places) {
      Trajectory path(dof);
      std::size_t last = steps.size() - 1;
      while (last > 0 && steps[last - 1] == steps[last]) --last;
      for (std::size_t k = 0; k <= last; ++k) {
        const bool goes_on =
            k > 0 && k < last &&
            ((steps[k + 1] - steps[k]) - (steps[k] - steps[k - 1])).norm() < 1e-12;
        if (goes_on) continue;
        path.append(subproblem_.from + static_cast<double>(k) * tick, {steps[k].data(), dof});
      }
      out.paths.push_back(std::move(path));
    }
    return true;
  }

  void shorten(Resolution& out) {
    PointTraffic traffic(0.5 + world_.required_separation());
    const auto add = [&](std::size_t i) {
      traffic.add(robot(i).value, out.paths[i], *world_.radius(robot(i)), subproblem_.from,
                  kInfinity);
    };
    for (std::size_t i = 0; i < out.paths.size(); ++i) add(i);
    for (std::size_t i = 0; i < out.paths.size(); ++i) {
      traffic.remove(robot(i).value);
      Team team(world_, {robot(i)}, subproblem_.from);
      team.avoid(traffic);
      cut_corners(team, kInfinity, subproblem_.seed + i, out.paths[i], out.effort);
      add(i);
    }
  }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  const std::atomic<bool>& stop_;
};

}  // namespace

Resolution LockstepQuery::do_solve(const Workspace& workspace, const Subproblem& subproblem,
                                   const std::atomic<bool>& stop) const {
  Resolution resolution = LockstepSearch(workspace.world(), subproblem, stop).run();
  resolution.solver = kName;
  return resolution;
}

}  // namespace accord
