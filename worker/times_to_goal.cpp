#include "worker/times_to_goal.h"

#include <limits>

namespace accord {

TimesToGoal::TimesToGoal(const Team& team, const LocalRoadmap& roadmap, Node goal, Node start)
    : team_(team),
      roadmap_(roadmap),
      start_(roadmap.configuration(start)),
      times_(roadmap.size(), std::numeric_limits<double>::infinity()),
      known_(roadmap.size(), 0),
      near_(team.dof()) {
  reach(goal, 0);
}

double TimesToGoal::from(Node node) {
  while (!known_[node] && !open_.empty()) {
    const Reached next = open_.top();
    open_.pop();
    if (known_[next.node]) continue;
    known_[next.node] = 1;
    for (const LocalRoadmap::Edge& edge : roadmap_.edges(next.node)) {
      const double time = next.time + edge.duration;
      if (known_[edge.to] || time >= times_[edge.to]) continue;
      if (!roadmap_.is_blocked(next.node, edge)) reach(edge.to, time);
    }
  }
  return known_[node] ? times_[node] : std::numeric_limits<double>::infinity();
}

void TimesToGoal::reach(Node node, double time) {
  times_[node] = time;
  team_.nearest_representation(start_, roadmap_.configuration(node), near_);
  open_.push({time + team_.duration(start_, near_), time, node});
}

}  // namespace accord
