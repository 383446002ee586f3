// Puts plans together from the parts in which they travel, in whatever order and however often
// those come.
//
// A plan that is complete is given once: parts that come again, since somebody else asked for
// them, are passed over, unless this end has asked for it, too. Memory is bounded by what has come,
// never taken for what a part only claims: where incomplete plans are too many or too large, the
// one that has heard nothing for longest is forgotten.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"
#include "common/transport/fleet/recent_ids.h"

namespace accord {

// Not thread safe. Times are of any one clock that does not go back.
class PlanAssembly {
 public:
  using Time = std::chrono::nanoseconds;

  // A plan that has begun to come, and of which nothing has come for `patience`, is asked for
  // again; then after twice, four times, ... that, and in the end forgotten.
  explicit PlanAssembly(Time patience);

  // The plan, where this was what it lacked. Requires: fleet_fault() of it is nullopt.
  std::optional<FinishedPlan> add(PlanOutline outline, Time now);
  std::optional<FinishedPlan> add(PathPiece piece, Time now);

  // This end has asked for the plan: it is given even if it was before.
  void expect(const std::string& id);
  // There is a plan: if this end expects it, it is as overdue as if it had begun to come.
  void note_finished(const std::string& id, Time now);

  // The requests whose plans are to be asked for now.
  std::vector<std::string> overdue(Time now);
  // When overdue() will name the next one, if nothing comes.
  std::optional<Time> next_overdue() const;

  // Parts that contradicted others, and plans that were no plans when they were complete.
  std::uint64_t malformed() const { return malformed_; }

 private:
  struct Path {
    std::map<std::uint32_t, PathPiece> pieces;
    bool complete() const { return pieces.size() == pieces.begin()->second.pieces; }
  };
  struct Open {
    std::uint32_t version = 0;  // 0: nothing has come
    std::optional<PlanOutline> outline;
    std::map<std::uint32_t, Path> paths;  // by the robot's place
    std::size_t complete_paths = 0;
    std::size_t bytes = 0;
    Time heard{0};
    int asked = 0;  // times since anything came
  };
  using Plans = std::map<std::string, Open>;

  Plans::iterator open(const std::string& id, std::uint32_t version, Time now);
  bool fits(const Open& plan, const PathPiece& piece) const;
  std::optional<FinishedPlan> finish_if_complete(Plans::iterator plan);
  std::optional<FinishedPlan> joined(Open plan);
  Time due(const Open& plan) const;
  bool account(Plans::iterator grown, std::size_t bytes);
  void drop_parts(Open& plan);
  void forget(Plans::iterator plan);

  Time patience_;
  Plans plans_;
  std::size_t bytes_ = 0;  // of all of them
  RecentIds given_;        // with the version
  RecentIds expected_;     // and not given
  std::uint64_t malformed_ = 0;
};

}  // namespace accord
