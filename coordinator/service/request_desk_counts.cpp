// What the desk counts, of which it has in hand, and reads off finished plans.
#include <algorithm>
#include <string_view>
#include <utility>

#include "common/planning/method_names.h"
#include "coordinator/service/request_desk.h"

namespace accord {
namespace {

// By its planner; 0 where it has not come that far.
std::uint64_t counted(double statistic) {
  constexpr double kMost = 1e15;
  return static_cast<std::uint64_t>(std::clamp(statistic, 0.0, kMost));
}

std::uint64_t counted(const Plan& plan, std::string_view statistic) {
  const auto found =
      std::ranges::find(plan.statistics, statistic, &std::pair<std::string, double>::first);
  return found == plan.statistics.end() ? 0 : counted(found->second);
}

}  // namespace

// Of what came of the last rounds nobody has told, where they were quick.
void RequestDesk::note_end(const Plan& plan, RequestState& state) {
  const auto raise = [&](std::uint64_t& count, std::string_view statistic) {
    count = std::max(count, counted(plan, statistic));
  };
  state.phase = RequestPhase::kFinished;
  raise(state.conflicts_found, "conflicts_found");
  raise(state.conflicts_resolved, "conflicts_resolved");
  raise(state.rounds, "rounds");
  state.per_cent = 100;
  state.best_cost = plan.sum_of_costs;
}

void RequestDesk::count_progress(const RequestState& before, const RequestState& after) {
  counters_.conflicts_found += after.conflicts_found - before.conflicts_found;
  counters_.conflicts_resolved += after.conflicts_resolved - before.conflicts_resolved;
  counters_.rounds += after.rounds - before.rounds;
}

void RequestDesk::count_planned(const Plan& plan, const Request& request, Now now) {
  counters_.planning[plan.status].add(
      std::chrono::duration<double>(now.steady - request.begun).count());
  RequestState after = request.state;  // which is for tell() to change
  note_end(plan, after);
  count_progress(request.state, after);

  constexpr std::string_view kSolvedBy = "solved_by_";
  const std::uint64_t exhausted = counted(plan, "subproblems_exhausted");
  std::uint64_t ended = exhausted;
  counters_.subproblems_exhausted += exhausted;
  for (const auto& [name, value] : plan.statistics) {
    if (name == "proof_time") counters_.proof.add(value);
    if (!name.starts_with(kSolvedBy)) continue;
    counters_.resolutions[counted_solver(name.substr(kSolvedBy.size()))] += counted(value);
    ended += counted(value);
  }
  const std::uint64_t all = counted(plan, "subproblems");
  counters_.subproblems_set_aside += all - std::min(all, ended);
}

void RequestDesk::count_write(const std::string& fault) {
  ++(fault.empty() ? counters_.writes : counters_.failed_writes);
  takes_writes_ = fault.empty();
}

void RequestDesk::on_not_forgotten() {
  is_forgetting_ = true;
  ++counters_.failed_writes;
  takes_writes_ = false;
}

RequestDesk::Load RequestDesk::load(Now now) const {
  Load load;
  load.planning = planning_;
  load.kept = kept_.size();
  load.bytes = bytes_;
  load.takes_writes = takes_writes_;
  for (const auto& [id, request] : requests_) {
    if (request.stage == Stage::kRead) ++load.reading;
    if (request.stage == Stage::kFinished) ++load.unwritten;
    if (request.stage != Stage::kQueued) continue;
    ++load.queued;
    load.oldest = std::max(load.oldest, now.steady - request.since);
  }
  return load;
}

}  // namespace accord
