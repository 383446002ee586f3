// Cuts a plan into parts that travel; plan_assembly.h puts them together again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord {

// Robot by robot, so that a plan is not in memory twice. Const functions are thread safe.
class PlanPieces {
 public:
  // Requires: fleet_fault(finished) is nullopt. `finished` outlives it and does not change.
  explicit PlanPieces(const FinishedPlan& finished);

  PlanOutline outline() const;
  // Of Plan::robots[robot]: at least one, each within kPathPieceBytes, waypoints before segments.
  std::vector<PathPiece> of_robot(std::size_t robot) const;

 private:
  PathSegment travelling(const PlanSegment& segment) const;

  const FinishedPlan& finished_;
  std::unordered_map<std::string_view, std::uint32_t> places_;
};

}  // namespace accord
