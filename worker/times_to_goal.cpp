#include "worker/times_to_goal.h"

namespace accord {

TimesToGoal::TimesToGoal(const Team& team, const LocalRoadmap& roadmap, Node goal, Node start)
    : team_(team),
      roadmap_(roadmap),
      start_(roadmap.configuration(start)),
      least_(roadmap.size()),
      near_(team.dof()) {
  reach(goal, 0);
}

double TimesToGoal::from(Node node) {
  while (!least_[node].is_known && !open_.empty()) {
    const Reached next = open_.top();
    open_.pop();
    bool& is_known = least_[next.node].is_known;
    if (is_known) continue;
    is_known = true;
    for (const LocalRoadmap::Edge& edge : roadmap_.edges(next.node)) {
      const double time = next.time + edge.duration;
      const Least& there = least_[edge.to];
      if (there.is_known || time >= there.time) continue;
      if (!roadmap_.is_blocked(next.node, edge)) reach(edge.to, time);
    }
  }
  const Least& there = least_[node];
  return there.is_known ? there.time : std::numeric_limits<double>::infinity();
}

void TimesToGoal::reach(Node node, double time) {
  least_[node].time = time;
  team_.nearest_representation(start_, roadmap_.configuration(node), near_);
  open_.push({time + team_.duration(start_, near_), time, node});
}

}  // namespace accord
