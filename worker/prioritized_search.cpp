#include "worker/prioritized_search.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "common/planning/random.h"
#include "worker/path_shortening.h"
#include "worker/safe_interval_search.h"

namespace accord {
namespace {

using Order = std::vector<std::size_t>;

// All orders of up to three robots; of more, the given one, its reverse, and seeded shuffles.
std::vector<Order> priority_orders(std::size_t robots, std::size_t limit, std::uint64_t seed) {
  Order order(robots);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<Order> orders;
  if (robots <= 3) {
    do {
      orders.push_back(order);
    } while (std::ranges::next_permutation(order).found && orders.size() < limit);
    return orders;
  }
  orders.push_back(order);
  orders.emplace_back(order.rbegin(), order.rend());
  RandomStream random(combine({seed, 0x6f72646572}));
  while (orders.size() < limit) {
    for (std::size_t i = robots - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    orders.push_back(order);
  }
  return orders;
}

class PrioritizedSearch {
 public:
  PrioritizedSearch(const CollisionWorld& world, const Subproblem& subproblem,
                    DecoupledRoadmaps& roadmaps)
      : world_(world), subproblem_(subproblem), roadmaps_(roadmaps) {}

  // Later robots may arrive after earlier ones, which then have to stay at their goals for longer
  // than they knew: plan again with what was learnt.
  bool plan(const Order& order, Resolution& out) {
    double hold_until = subproblem_.from;
    for (int attempt = 0; attempt < 3; ++attempt) {
      if (!plan_once(order, hold_until, out)) return false;
      if (free_until_ >= out.end) return true;
      hold_until = out.end;
    }
    return false;
  }

 private:
  bool plan_once(const Order& order, double hold_until, Resolution& out) {
    out.paths.assign(subproblem_.tasks.size(), Trajectory());
    out.end = hold_until;
    free_until_ = std::numeric_limits<double>::infinity();
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const std::size_t i = order[rank];
      const RobotId robot = subproblem_.tasks[i].robot;
      Team team(world_, {robot}, subproblem_.from, subproblem_.latest);
      for (const Outsider& outsider : subproblem_.outsiders) {
        team.avoid(outsider.robot, outsider.path);
      }
      for (std::size_t before = 0; before < rank; ++before) {
        const std::size_t j = order[before];
        team.avoid(subproblem_.tasks[j].robot, out.paths[j]);
      }
      const SearchRequest request{DecoupledRoadmaps::kStart, DecoupledRoadmaps::kGoal,
                                  subproblem_.from, out.end, subproblem_.latest,
                                  subproblem_.limits.query_expansions};
      ++out.effort.searches;
      auto found = safe_interval_search(team, roadmaps_.of(i), request, out.effort.expansions);
      if (!found) return false;
      shorten(team, request, *found, out.effort);
      out.end = std::max(out.end, found->path.end_time());
      free_until_ = std::min(free_until_, found->free_until);
      out.paths[i] = std::move(found->path);
    }
    out.solved = true;
    return true;
  }

  const CollisionWorld& world_;
  const Subproblem& subproblem_;
  DecoupledRoadmaps& roadmaps_;
  double free_until_ = 0;
};

double sum_of_arrivals(const Resolution& resolution) {
  double sum = 0;
  for (const Trajectory& path : resolution.paths) sum += path.end_time();
  return sum;
}

}  // namespace

Resolution prioritized_search(const CollisionWorld& world, const Subproblem& subproblem,
                              DecoupledRoadmaps& roadmaps, const std::atomic<bool>& stop) {
  const std::size_t robots = subproblem.tasks.size();
  PrioritizedSearch search(world, subproblem, roadmaps);
  Resolution best;
  Effort effort;
  for (const Order& order :
       priority_orders(robots, subproblem.limits.priority_orders, subproblem.seed)) {
    if (stop) break;
    Resolution found;
    const bool solved = search.plan(order, found);
    effort += found.effort;
    if (!solved) continue;
    if (!best.solved || found.end < best.end ||
        (found.end == best.end && sum_of_arrivals(found) < sum_of_arrivals(best))) {
      best = std::move(found);
    }
    if (robots > 2) break;  // with many orders the first that works has to do
  }
  best.effort = effort;
  best.effort.motion_checks = roadmaps.motion_checks();
  return best;
}

}  // namespace accord
