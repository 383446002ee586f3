// Whether robots can stand where their queries begin and end.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "common/model/scene.h"

namespace accord {

// Room beyond the clearance that starts and goals must keep: more than planning does
// (kPlanningMargin), so that every query that is accepted here can be planned.
inline constexpr double kQueryMargin = 2e-6;  // m

enum class QuerySide : std::uint8_t { kStart, kGoal };

// What there is to check about a robot's start, or its goal.
enum class QueryCheck : std::uint8_t {
  kNone,    // nothing: it is no place
  kPassed,  // it is sound, and so it is beside all others that are: nobody is blamed for it
  kDue,
};
struct QueryChecks {
  QueryCheck start = QueryCheck::kDue;
  QueryCheck goal = QueryCheck::kDue;
};

// Told what is wrong with a robot's start or goal. Returns whether to go on.
using QueryBlame = std::function<bool(RobotId robot, QuerySide side, std::string_view text)>;

// Looks for starts and goals that leave the bounds, touch obstacles or the robot itself, or come
// too close to another robot's. Requires: a check for each of the scene's robots; of those that are
// not kNone, the configuration has the robot's degrees of freedom.
void check_queries(std::shared_ptr<const Scene> scene, const std::vector<QueryChecks>& checks,
                   const QueryBlame& blame);

}  // namespace accord
