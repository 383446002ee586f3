// The motions of a team among the moving bodies that it avoids.
// Not thread safe.
#pragma once

#include <optional>
#include <vector>

#include "worker/local_roadmap.h"
#include "worker/team.h"
#include "worker/timed_motions.h"

namespace accord {

class AmongBodies final : public TimedMotions {
 public:
  AmongBodies(Team& team, const LocalRoadmap& roadmap)
      : team_(team), roadmap_(roadmap), is_cheap_(team.avoids_points()), target_(team.dof()) {}

  void safe_intervals(LocalRoadmap::Node node, double since, std::vector<Interval>& out) override {
    team_.safe_intervals(roadmap_.configuration(node), since, out,
                         MovingBody::Name{&roadmap_, node});
  }
  std::optional<double> earliest_departure(LocalRoadmap::Node from, const LocalRoadmap::Edge& edge,
                                           double lo, double hi) override {
    const ConfigurationView q = roadmap_.configuration(from);
    team_.nearest_representation(q, roadmap_.configuration(edge.to), target_);
    return team_.earliest_departure(q, target_, edge.duration, lo, hi);
  }
  bool are_cheap() const override { return is_cheap_; }
  std::uint64_t checks() const override { return team_.checks(); }

 private:
  Team& team_;
  const LocalRoadmap& roadmap_;
  bool is_cheap_;
  Configuration target_;  // scratch
};

}  // namespace accord
