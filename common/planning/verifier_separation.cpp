#include "common/planning/verifier_separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "common/planning/verifier_bisection.h"
#include "common/planning/verifier_parallel.h"

namespace accord::verification {
namespace {

constexpr std::size_t kQueryBudget = 100'000;  // over all robots, or all slabs
constexpr std::size_t kLeastBudget = 64;       // for each of them
// What is looked for may be so much farther than a sample, so that where that was taken is found
// again.
constexpr double kAboveSample = 1e-5;  // m

std::size_t share_of_budget(std::size_t sharers) {
  return std::max(kLeastBudget, kQueryBudget / std::max<std::size_t>(sharers, 1));
}

// Both robots of a pair during a stretch of time on which both move linearly.
struct Stretch {
  Pair pair;
  double t0;
  double t1;
};

// The centre of a disc or ball.
Vec3 centre(const Subject& subject, RobotId id, double t) {
  Vec3 q = Vec3::Zero();
  const Trajectory& path = subject.path(id);
  path.at(t, std::span<double>(q.data(), path.dof()));
  return subject.robot(id).base * q;
}

// The closest of two discs or balls during a stretch, in closed form; the offsets are those of the
// second's centre from the first's at its two ends.
Closest closest_of_round(const Stretch& stretch, const Vec3& before, const Vec3& after,
                         double radii) {
  constexpr double kRounding = 1e-9;  // m
  const Vec3 drift = after - before;
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

// The closest that two discs or balls come during a slab.
Closest closest_of_round_pair(const Subject& subject, Pair pair, double begin, double end,
                              double radii) {
  const auto offset = [&](double t) {
    return Vec3(centre(subject, pair.second, t) - centre(subject, pair.first, t));
  };
  Closest closest{std::numeric_limits<double>::infinity(), begin, 0};
  Vec3 before = offset(begin);
  for_each_stretch(subject.path(pair.first), subject.path(pair.second), begin, end,
                   [&](double t0, double t1) {
                     const Vec3 after = offset(t1);
                     const Closest here = closest_of_round({pair, t0, t1}, before, after, radii);
                     if (here.distance < closest.distance) closest = here;
                     before = after;
                     return true;
                   });
  return closest;
}

// The closest of the stretches, of those that come closer than `upper`, within a budget of queries.
std::optional<PairClosest> closest_by_bisection(const Subject& subject,
                                                const std::vector<Stretch>& stretches, double upper,
                                                std::size_t budget) {
  const auto distance = [&](std::size_t i, double t, double cutoff) {
    return pair_distance(subject, stretches[i].pair, t, cutoff);
  };
  Bisection bisection(distance, upper, budget);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    bisection.add(i, stretches[i].t0, stretches[i].t1, pair_travel(subject, stretches[i]));
  }
  const std::optional<Closest> closest = bisection.solve();
  if (!closest) return std::nullopt;
  return PairClosest{*closest, stretches[closest->item].pair};
}

// The closest of the pairs from begin to end, of those that come closer than `upper`, within a
// budget of queries.
std::optional<PairClosest> closest_of(const Subject& subject, const std::vector<Pair>& pairs,
                                      double begin, double end, double upper, std::size_t budget) {
  std::optional<PairClosest> best;
  std::vector<Stretch> stretches;  // of pairs that have no closed form
  for (const Pair pair : pairs) {
    const std::optional<double> radius_a = subject.world.radius(pair.first);
    const std::optional<double> radius_b = subject.world.radius(pair.second);
    if (radius_a && radius_b) {
      const double radii = *radius_a + *radius_b;
      keep_lower(best, closest_of_round_pair(subject, pair, begin, end, radii), pair);
      continue;
    }
    for_each_stretch(subject.path(pair.first), subject.path(pair.second), begin, end,
                     [&](double t0, double t1) {
                       stretches.push_back({pair, t0, t1});
                       return true;
                     });
  }
  if (best) upper = std::min(upper, best->closest.distance);
  const auto other = closest_by_bisection(subject, stretches, upper, budget);
  if (other) keep_lower(best, other->closest, other->pair);
  return best;
}

// The closest pair during one slab, of those that come closer than `upper`.
std::optional<PairClosest> closest_in_slab(const Subject& subject, const TimeSlabs& slabs,
                                           std::size_t slab, double upper) {
  std::optional<PairClosest> best;
  slabs.for_each_part(slab, upper, [&](double begin, double end, std::vector<Pair>& pairs) {
    const double below = best ? std::min(upper, best->closest.distance) : upper;
    const auto here = closest_of(subject, pairs, begin, end, below, share_of_budget(slabs.count()));
    if (here) keep_lower(best, here->closest, here->pair);
    return true;
  });
  return best;
}

// The smallest distance from an obstacle at any waypoint, at most the cutoff.
double sampled_obstacle_distance(const Subject& subject) {
  double smallest = kSeparationCutoff;
  for (std::uint32_t r = 0; r < subject.robots(); ++r) {
    const Trajectory& path = subject.path(RobotId{r});
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double here =
          subject.world.obstacle_distance(RobotId{r}, path.configuration(i), smallest);
      smallest = std::min(smallest, here);
    }
  }
  return smallest;
}

// The closest that one robot comes to an obstacle, if that is below `upper`.
std::optional<Closest> closest_to_obstacles(const Subject& subject, RobotId id, double upper) {
  const Trajectory& path = subject.path(id);
  const auto distance = [&](std::size_t, double t, double cutoff) {
    return subject.world.obstacle_distance(id, path.at(t), cutoff);
  };
  Bisection bisection(distance, upper, share_of_budget(subject.robots()));
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
  const double upper = sampled + kAboveSample;
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
  const double upper = std::min(sampled_obstacle_distance(subject) + kAboveSample,  //
                                kSeparationCutoff);
  std::vector<std::optional<Closest>> results(subject.robots());
  parallel_for(subject.robots(), threads, [&](std::size_t robot) {
    const RobotId id{static_cast<std::uint32_t>(robot)};
    results[robot] = closest_to_obstacles(subject, id, upper);
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
