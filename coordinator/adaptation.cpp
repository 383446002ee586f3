#include "coordinator/adaptation.h"

#include <algorithm>

namespace accord {
namespace {

// Times that a conflict of the same pair comes back before its robots are merged with those that
// they keep getting in conflict with.
constexpr unsigned kTradesToMerge = 2;
// A team that cannot make it grows by this many robots at a time, a crowd by half of itself.
constexpr std::size_t kTakenInAtOnce = 2;
// A local solution that delays its robots by more than this all in all, in robots' own times, has
// been squeezed in between others that may be the ones to give way.
constexpr double kOwnTimesForLocal = 3.0;
// More robots than these, each in conflict with one of the others at about the same time, are a
// crowd.
constexpr std::size_t kLocalTeam = 4;

// Horizons of crowds that the board looks ahead, beyond the earliest conflict.
constexpr double kReach = 2;

// The levels take longer the larger the crowd, for each of its robots: beyond this many, seconds.
constexpr std::size_t kLargestCrowd = 300;
// So many mobile robots around a team that cannot get by them are a crowd with it.
constexpr std::ptrdiff_t kBystanders = 2;

// Robots outside the team that are in conflict with one of it in the window: their paths have to
// change in any case. Earliest first.
std::vector<RobotId> entangled_with(const Subproblem& subproblem, const ConflictBoard& board) {
  std::set<RobotId> team;
  for (const Task& task : subproblem.tasks) team.insert(task.robot);
  std::vector<RobotId> robots;
  for (const Conflict& conflict : board.conflicts()) {
    if (conflict.time > subproblem.to) break;
    const bool first = team.contains(conflict.first), second = team.contains(conflict.second);
    if (first != second) robots.push_back(first ? conflict.second : conflict.first);
  }
  return robots;
}

// The team, and everyone in conflict with one of these before a time (s).
std::set<RobotId> entangled_before(double horizon, std::set<RobotId> team,
                                   const ConflictBoard& board) {
  std::vector<RobotId> fresh(team.begin(), team.end());
  while (!fresh.empty()) {
    const RobotId robot = fresh.back();
    fresh.pop_back();
    for (const ConflictBoard::WithOther& own : board.conflicts_of(robot)) {
      if (own.time <= horizon && team.insert(own.other).second) fresh.push_back(own.other);
    }
  }
  return team;
}

}  // namespace

double Adaptation::reach() const {
  Growth crowd;
  crowd.crowd = true;
  double longest = 0;
  for (std::uint32_t robot = 0; robot < schedule_.size(); ++robot) {
    const auto window = factory_.window({{robot}, {robot}, 0}, crowd);
    longest = std::max(longest, window.horizon);
  }
  return kReach * longest;
}

Growth Adaptation::growth_of(const Conflict& conflict, const ConflictBoard& board) const {
  const auto known = stages_.find({conflict.first, conflict.second});
  Stages stages = known == stages_.end() ? Stages{} : known->second;
  const Trade* trade = trade_of(conflict);
  if (trade && trade->count >= kTradesToMerge) {
    for (const RobotId robot : {conflict.first, conflict.second}) {
      for (const CouplingSegment& segment : schedule_.coupling(robot)) {
        if (segment.to < trade->from || segment.from > trade->until) continue;
        stages.local.taken_in.insert(segment.robots.begin(), segment.robots.end());
      }
    }
  }
  stages.local.taken_in.insert({conflict.first, conflict.second});
  if (stages.crowd_is_spent) return stages.local;
  if (!stages.wants_crowd && stages.local.taken_in.size() <= kLocalTeam) return stages.local;
  stages.crowd.taken_in.insert(stages.local.taken_in.begin(), stages.local.taken_in.end());
  Growth crowd = crowd_of(conflict, std::move(stages.crowd), board);
  if (is_for_lockstep(conflict, crowd)) {
    crowd.lockstep = true;
    crowd.to_the_end = true;
    return crowd;
  }
  return stages.has_bystanders || crowd.taken_in.size() > kLocalTeam ? crowd : stages.local;
}

bool Adaptation::is_for_lockstep(const Conflict& conflict, const Growth& crowd) const {
  return !lockstep_is_spent_ && crowd.taken_in.size() > kLargestCrowd &&
         factory_.can_move_in_lockstep(conflict.first, conflict.second);
}

bool Adaptation::prefers_crowd(const Conflict& conflict, const Subproblem& subproblem,
                               const Resolution& resolution, const ConflictBoard& board) {
  Stages& stages = stages_[{conflict.first, conflict.second}];
  if (subproblem.is_crowd() || subproblem.lockstep || stages.crowd_is_spent) return false;
  double delay = 0, worth = 0;
  for (std::size_t i = 0; i < subproblem.tasks.size(); ++i) {
    delay += resolution.paths[i].end_time() - subproblem.tasks[i].to;
    worth = std::max(worth, kOwnTimesForLocal * factory_.own_time(subproblem.tasks[i].robot));
  }
  if (delay <= worth) return false;
  stages.crowd.taken_in.insert({conflict.first, conflict.second});
  stages.has_local = crowd_of(conflict, stages.crowd, board).taken_in.size() > kLocalTeam;
  stages.wants_crowd = stages.wants_crowd || stages.has_local;
  return stages.has_local;
}

const Adaptation::Trade* Adaptation::trade_of(const Conflict& conflict) const {
  const auto found = trades_.find({conflict.first, conflict.second});
  return found == trades_.end() || conflict.time > found->second.until ? nullptr : &found->second;
}

// A crowd that pushes its conflicts ahead of itself looks further ahead each time, but not so far
// that it would be too large, or beyond where conflicts are known.
Growth Adaptation::crowd_of(const Conflict& conflict, Growth growth,
                            const ConflictBoard& board) const {
  growth.crowd = true;
  const std::set<RobotId> team = growth.taken_in;
  const Trade* trade = trade_of(conflict);
  for (unsigned further = trade ? trade->count / kTradesToMerge : 0;; further /= 2) {
    Growth grown = growth;
    grown.window += further;
    const double horizon = factory_.window(conflict, grown).horizon;
    if (further > 0 && horizon > board.seen_until()) continue;
    grown.taken_in = entangled_before(horizon, team, board);
    if (further == 0 || grown.taken_in.size() <= kLargestCrowd) return grown;
  }
}

void Adaptation::note_resolved(const Conflict& conflict, const Subproblem& subproblem) {
  const Pair pair{conflict.first, conflict.second};
  stages_.erase(pair);
  if (subproblem.lockstep) {
    lockstep_is_spent_ = true;
    return;
  }
  Trade& trade = trades_[pair];
  if (conflict.time > trade.until) trade = {};
  ++trade.count;
  trade.from = trade.count == 1 ? subproblem.from : std::min(trade.from, subproblem.from);
  // What was left for after the horizon may come up right there, or after one of another pair.
  constexpr double kLookouts = 3;
  const double ahead = subproblem.horizon - conflict.time;
  trade.until = std::max(trade.until, subproblem.horizon + kLookouts * ahead);
}

bool Adaptation::grow(const Conflict& conflict, const Subproblem& subproblem,
                      const std::vector<RobotId>& in_the_way, const ConflictBoard& board) {
  if (subproblem.lockstep) {
    lockstep_is_spent_ = true;
    return true;
  }
  Stages& stages = stages_[{conflict.first, conflict.second}];
  std::vector<RobotId> candidates = entangled_with(subproblem, board);
  candidates.insert(candidates.end(), in_the_way.begin(), in_the_way.end());
  if (subproblem.is_crowd()) {
    stages.crowd_is_spent = stages.has_local || !grow_crowd(subproblem, candidates, stages.crowd);
    return true;
  }
  // Those who stand by may make way where going around them has failed. Arms cannot leave.
  const auto bystanders = std::ranges::count_if(
      subproblem.outsiders,
      [&](const Outsider& outsider) { return factory_.is_mobile(outsider.robot); });
  stages.wants_crowd = true;
  stages.has_bystanders = bystanders >= kBystanders;
  return grow_local(subproblem, candidates, stages.local);
}

bool Adaptation::grow_local(const Subproblem& subproblem, const std::vector<RobotId>& candidates,
                            Growth& growth) {
  ++growth.attempts;
  growth.shortsighted = !growth.shortsighted && !subproblem.outsiders.empty();
  if (growth.shortsighted) return true;
  const bool on_roadmaps = std::ranges::all_of(
      subproblem.tasks, [&](const Task& task) { return factory_.uses_roadmap(task.robot); });
  growth.to_the_end = !growth.to_the_end && on_roadmaps;
  if (growth.to_the_end) {
    growth.shortsighted = !subproblem.outsiders.empty();
    return true;
  }
  if (subproblem.whole) {
    std::vector<RobotId> everyone = candidates;
    for (const Outsider& outsider : subproblem.outsiders) everyone.push_back(outsider.robot);
    if (take_in(everyone, kTakenInAtOnce, growth) > 0) return true;
    return ++growth.retries <= Growth::kRetries;
  }
  if (growth.window % 2 == 1 && take_in(candidates, kTakenInAtOnce, growth) > 0) return true;
  return grow_window(subproblem, growth);
}

bool Adaptation::grow_crowd(const Subproblem& subproblem, const std::vector<RobotId>& candidates,
                            Growth& growth) {
  ++growth.attempts;
  growth.shortsighted = !growth.shortsighted && !subproblem.outsiders.empty();
  if (growth.shortsighted) return true;
  const std::size_t taken = take_in(candidates, subproblem.tasks.size() / 2, growth);
  return grow_window(subproblem, growth) || taken > 0;
}

std::size_t Adaptation::take_in(const std::vector<RobotId>& candidates, std::size_t most,
                                Growth& growth) {
  std::size_t taken = 0;
  for (const RobotId robot : candidates) {
    if (taken == most) break;
    if (growth.taken_in.insert(robot).second) ++taken;
  }
  robots_taken_in_ += taken;
  return taken;
}

bool Adaptation::grow_window(const Subproblem& subproblem, Growth& growth) {
  if (subproblem.whole) return false;
  ++growth.window;
  ++windows_grown_;
  return true;
}

}  // namespace accord
