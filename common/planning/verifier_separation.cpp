#include "common/planning/verifier_separation.h"

#include <algorithm>
#include <cmath>

#include "common/planning/verifier_bisection.h"
#include "common/planning/verifier_parallel.h"

namespace accord::verification {
namespace {

constexpr std::size_t kQueryBudget = 100'000;  // over all robots, or all slabs
constexpr std::size_t kLeastBudget = 64;       // for each of them

std::size_t share_of_budget(std::size_t sharers) {
  return std::max(kLeastBudget, kQueryBudget / std::max<std::size_t>(sharers, 1));
}

// Both robots of a pair during a stretch of time on which both move linearly.
struct Stretch {
  Pair pair;
  double t0;
  double t1;
};

// The closest of two discs or balls during a stretch, in closed form.
Closest closest_of_round(const Subject& subject, const Stretch& stretch, double radii) {
  const auto offset = [&](double t) {
    const Robot& a = subject.robot(stretch.pair.first);
    const Robot& b = subject.robot(stretch.pair.second);
    const auto place = [&](const Robot& robot, RobotId id) {
      return place_of(robot, subject.path(id).at(t));
    };
    return Vec3(place(b, stretch.pair.second) - place(a, stretch.pair.first));
  };
  constexpr double kRounding = 1e-9;
  const Vec3 before = offset(stretch.t0);
  const Vec3 drift = offset(stretch.t1) - before;
  const double squared = drift.squaredNorm();
  const double u = squared > 0 ? std::clamp(-before.dot(drift) / squared, 0.0, 1.0) : 0.0;
  return {(before + u * drift).norm() - radii - kRounding,
          stretch.t0 + u * (stretch.t1 - stretch.t0), 0};
}

// A lower bound on a pair's distance at an instant.
double pair_distance(const Subject& subject, const Pair& pair, double t, double cutoff) {
  return subject.world.separation(pair.first, subject.path(pair.first).at(t), pair.second,
                                  subject.path(pair.second).at(t), cutoff);
}

double pair_travel(const Subject& subject, const Stretch& s) {
  const auto travelled = [&](RobotId id) {
    const Trajectory& path = subject.path(id);
    return travel(subject.world, id, path.at(s.t0), path.at(s.t1));
  };
  return travelled(s.pair.first) + travelled(s.pair.second);
}

struct PairClosest {
  Closest closest;
  Pair pair;
};

void keep_lower(std::optional<PairClosest>& best, const Closest& candidate, Pair pair) {
  if (!best || candidate.distance < best->closest.distance) best = PairClosest{candidate, pair};
}

// The closest pair during one slab, of those that come closer than `upper`.
std::optional<PairClosest> closest_in_slab(const Subject& subject, const TimeSlabs& slabs,
                                           std::size_t slab, double upper) {
  std::optional<PairClosest> best;
  std::vector<Stretch> stretches;  // of pairs that have no closed form
  for (const Pair pair : slabs.near_pairs(slab, upper)) {
    const std::optional<double> radius_a = subject.world.radius(pair.first);
    const std::optional<double> radius_b = subject.world.radius(pair.second);
    for_each_stretch(subject.path(pair.first), subject.path(pair.second), slabs.begin(slab),
                     slabs.end(slab), [&](double t0, double t1) {
                       const Stretch stretch{pair, t0, t1};
                       if (radius_a && radius_b) {
                         keep_lower(best, closest_of_round(subject, stretch, *radius_a + *radius_b),
                                    pair);
                       } else {
                         stretches.push_back(stretch);
                       }
                       return true;
                     });
  }
  const auto distance = [&](std::size_t i, double t, double cutoff) {
    return pair_distance(subject, stretches[i].pair, t, cutoff);
  };
  if (best) upper = std::min(upper, best->closest.distance);
  Bisection bisection(distance, upper, share_of_budget(slabs.count()));
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    bisection.add(i, stretches[i].t0, stretches[i].t1, pair_travel(subject, stretches[i]));
  }
  if (const auto closest = bisection.solve()) {
    keep_lower(best, *closest, stretches[closest->item].pair);
  }
  return best;
}

// The closest that one robot comes to an obstacle.
std::optional<Closest> closest_to_obstacles(const Subject& subject, RobotId id) {
  const Trajectory& path = subject.path(id);
  const auto distance = [&](std::size_t, double t, double cutoff) {
    return subject.world.obstacle_distance(id, path.at(t), cutoff);
  };
  Bisection bisection(distance, kSeparationCutoff, share_of_budget(subject.robots()));
  if (path.size() == 1) bisection.add(0, path.start_time(), path.end_time(), 0);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    bisection.add(i, path.time(i), path.time(i + 1),
                  travel(subject.world, id, path.configuration(i), path.configuration(i + 1)));
  }
  return bisection.solve();
}

// The name of the obstacle that a configuration is closest to: the one that it would touch, were
// the clearance a little more than `distance`.
std::string nearest_obstacle(const Subject& subject, RobotId id, ConfigurationView q,
                             double distance) {
  auto wide = std::make_shared<Scene>(subject.scene);
  wide->bounds.reset();
  wide->clearance = distance + 1e-3;
  const CollisionWorld world(wide, 0);
  const std::optional<Fault> fault = world.fault(id, q);
  return fault && fault->kind == Fault::Kind::kObstacle ? fault->other : "";
}

}  // namespace

std::optional<Separation> robots_separation(const Subject& subject, const TimeSlabs& slabs,
                                            double sampled, unsigned threads) {
  // A little more than the sample, so that where it was taken is found again.
  const double upper = sampled + 1e-5;
  std::vector<std::optional<PairClosest>> results(slabs.count());
  parallel_for(slabs.count(), threads, [&](std::size_t slab) {
    results[slab] = closest_in_slab(subject, slabs, slab, upper);
  });
  std::optional<PairClosest> best;
  for (const auto& result : results) {
    if (result) keep_lower(best, result->closest, result->pair);
  }
  if (!best || best->closest.distance >= kSeparationCutoff) return std::nullopt;
  return Separation{std::max(best->closest.distance, subject.scene.clearance), best->closest.time,
                    subject.robot(best->pair.first).name, subject.robot(best->pair.second).name};
}

std::optional<Separation> obstacles_separation(const Subject& subject, unsigned threads) {
  std::vector<std::optional<Closest>> results(subject.robots());
  parallel_for(subject.robots(), threads, [&](std::size_t robot) {
    results[robot] = closest_to_obstacles(subject, RobotId{static_cast<std::uint32_t>(robot)});
  });
  std::optional<Closest> best;
  RobotId id;
  for (std::uint32_t r = 0; r < results.size(); ++r) {
    if (!results[r] || (best && results[r]->distance >= best->distance)) continue;
    best = results[r];
    id = RobotId{r};
  }
  if (!best) return std::nullopt;
  const Configuration q = subject.path(id).at(best->time);
  const double there = subject.world.obstacle_distance(id, q, kSeparationCutoff);
  return Separation{std::max(best->distance, subject.scene.clearance), best->time,
                    subject.robot(id).name, nearest_obstacle(subject, id, q, there)};
}

}  // namespace accord::verification
