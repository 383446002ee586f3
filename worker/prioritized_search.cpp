#include "worker/prioritized_search.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <set>

#include "common/planning/conflict.h"
#include "common/planning/random.h"
#include "worker/continuation.h"
#include "worker/path_shortening.h"
#include "worker/prioritized_repair.h"
#include "worker/safe_interval_search.h"

namespace accord {
namespace {

using Order = std::vector<std::size_t>;
constexpr double kForGood = std::numeric_limits<double>::infinity();

Order in_given_order(std::size_t robots) {
  Order order(robots);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

class PrioritizedSearch {
 public:
  PrioritizedSearch(const CollisionWorld& world, const Subproblem& subproblem,
                    DecoupledRoadmaps& roadmaps)
      : world_(world), subproblem_(subproblem), roadmaps_(roadmaps) {}

  // Whether the tails that the last plan leads to are free of each other as far as the horizon.
  bool clean() const { return clean_; }

  bool plan(const Order& order, const std::atomic<bool>& stop, Resolution& out) {
    out.paths.assign(subproblem_.tasks.size(), Trajectory());
    out.end = subproblem_.from;
    clean_ = true;
    std::vector<Trajectory> onwards(order.size());  // by rank: paths with their tails
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const Task& task = subproblem_.tasks[order[rank]];
      Team team(world_, {task.robot}, subproblem_.from);
      roadmaps_.avoid_outsiders(order[rank], team);
      for (std::size_t before = 0; before < rank; ++before) {
        roadmaps_.avoid(order[rank], subproblem_.tasks[order[before]].robot, onwards[before],
                        kForGood, team);
      }
      LocalRoadmap& roadmap = roadmaps_.of(order[rank]);
      const SearchRequest request{DecoupledRoadmaps::start(roadmap),
                                  DecoupledRoadmaps::goal(roadmap),
                                  subproblem_.from,
                                  hold_until(subproblem_, task),
                                  subproblem_.limits.query_expansions,
                                  subproblem_.limits.query_checks};
      ++out.effort.searches;
      auto found = safe_interval_search(team, roadmap, request, stop, out.effort.expansions);
      if (!found) {
        return false;
      }
      shorten(team, request, *found, stop, out.effort);
      out.end = std::max(out.end, found->end_time());
      onwards[rank] = with_tail(world_, task, *found);
      for (std::size_t before = 0; before < rank && clean_; ++before) {
        clean_ = !earliest_contact(world_, task.robot, onwards[rank],
                                   subproblem_.tasks[order[before]].robot, onwards[before],
                                   subproblem_.from, subproblem_.horizon);
      }
      out.paths[order[rank]] = std::move(*found);
    }
    out.solved = true;
    return true;
  }

 private:
  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  DecoupledRoadmaps& roadmaps_;
  bool clean_ = true;
};

double sum_of_arrivals(const Resolution& resolution) {
  double sum = 0;
  for (const Trajectory& path : resolution.paths) sum += path.end_time();
  return sum;
}

Resolution in_task_order(PrioritizedSearch& search, std::size_t robots,
                         const std::atomic<bool>& stop, Effort& effort) {
  Resolution found;
  const bool solved = search.plan(in_given_order(robots), stop, found);
  effort += found.effort;
  return solved ? found : Resolution{};
}

// Every order of two robots: which goes first often matters more than anything else.
Resolution best_of_all_orders(PrioritizedSearch& search, Order order, const std::atomic<bool>& stop,
                              Effort& effort) {
  Resolution best;
  bool best_is_clean = false;
  do {
    Resolution found;
    const bool solved = search.plan(order, stop, found);
    effort += found.effort;
    if (!solved || (best_is_clean && !search.clean())) continue;
    if (!best.solved || search.clean() > best_is_clean ||
        sum_of_arrivals(found) < sum_of_arrivals(best)) {
      best = std::move(found);
      best_is_clean = search.clean();
    }
  } while (std::ranges::next_permutation(order).found);
  return best;
}

}  // namespace

Resolution prioritized_search(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop) {
  const std::size_t robots = subproblem.tasks.size();
  PrioritizedSearch search(world, subproblem, roadmaps);
  Effort effort;
  Resolution best;
  if (subproblem.limits.priority_orders == 1) {
    best = in_task_order(search, robots, stop, effort);
  } else if (robots <= 2) {
    best = best_of_all_orders(search, in_given_order(robots), stop, effort);
  } else {
    best = prioritized_repair(world, subproblem, roadmaps, stop, effort);
  }
  best.effort = effort;
  best.effort.motion_checks += roadmaps.motion_checks();
  return best;
}

}  // namespace accord
