#include "common/planning/verifier.h"

#include <algorithm>

#include "common/geometry/tolerances.h"
#include "common/planning/verifier_form.h"
#include "common/planning/verifier_pairs.h"
#include "common/planning/verifier_parallel.h"
#include "common/planning/verifier_robot.h"
#include "common/planning/verifier_segments.h"
#include "common/planning/verifier_separation.h"
#include "common/planning/verifier_slabs.h"
#include "common/planning/verifier_subject.h"

namespace accord {
namespace {

using namespace verification;

// The earliest violation of any robot by itself; of the first robot where several are as early.
std::optional<Violation> check_robots(const Subject& subject, unsigned threads) {
  std::vector<std::optional<Violation>> found(subject.robots());
  parallel_for(subject.robots(), threads, [&](std::size_t robot) {
    found[robot] = check_robot(subject, RobotId{static_cast<std::uint32_t>(robot)});
  });
  std::optional<Violation> earliest;
  for (std::optional<Violation>& violation : found) {
    if (violation && (!earliest || violation->time < earliest->time)) earliest = violation;
  }
  return earliest;
}

// Threads that are worth starting: on small plans they would take longer to start than to work.
unsigned worthwhile(unsigned threads, const Subject& subject) {
  constexpr std::size_t kWaypointsPerThread = 1000;
  std::size_t waypoints = 0;
  for (const Trajectory* path : subject.paths) waypoints += path->size();
  return static_cast<unsigned>(
      std::clamp<std::size_t>(waypoints / kWaypointsPerThread, 1, std::max(threads, 1U)));
}

Verdict refuted(Violation violation) {
  return {std::move(violation), std::nullopt, std::nullopt};
}

}  // namespace

Verdict verify(const std::shared_ptr<const Scene>& scene, const Plan& plan, unsigned threads,
               Beyond beyond) {
  if (auto violation = check_form(*scene, plan)) return refuted(*std::move(violation));

  const CollisionWorld world(scene, kProofMargin);
  const Subject subject{*scene, world, paths_in_order(*scene, plan)};
  threads = beyond == Beyond::kNothing ? worthwhile(threads, subject) : std::max(threads, 1U);
  std::optional<Violation> earliest = check_robots(subject, threads);
  const TimeSlabs slabs(subject);
  PairsResult pairs = check_pairs(subject, slabs, threads, beyond == Beyond::kSeparations);
  if (pairs.violation && (!earliest || pairs.violation->time < earliest->time)) {
    earliest = std::move(pairs.violation);
  }
  if (!earliest) earliest = check_segments(*scene, plan);
  if (!earliest) earliest = check_costs(*scene, plan);
  if (earliest) return refuted(*std::move(earliest));
  if (beyond == Beyond::kNothing) return {};

  return {std::nullopt, robots_separation(subject, slabs, pairs.sampled_separation, threads),
          obstacles_separation(subject, threads)};
}

std::string_view to_string(Violation::Kind kind) {
  switch (kind) {
    case Violation::Kind::kForm:
      return "form";
    case Violation::Kind::kStart:
      return "start";
    case Violation::Kind::kGoal:
      return "goal";
    case Violation::Kind::kLimit:
      return "limit";
    case Violation::Kind::kSpeed:
      return "speed";
    case Violation::Kind::kBounds:
      return "bounds";
    case Violation::Kind::kObstacle:
      return "obstacle";
    case Violation::Kind::kSelf:
      return "self";
    case Violation::Kind::kRobots:
      return "robots";
    case Violation::Kind::kCosts:
      return "costs";
  }
  return "form";
}

}  // namespace accord
