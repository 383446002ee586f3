#include "coordinator/foreman.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/planning/levels.h"

namespace accord {
namespace {

// Levels of a subproblem that takes less than this all in all are one attempt: telling the crew of
// each would take longer than is won.
constexpr double kWorthSplitting = 2e-3;  // s

}  // namespace

std::vector<Resolution> Foreman::solve(const std::vector<Subproblem>& subproblems,
                                       const std::atomic<bool>& stop) {
  std::vector<Ladder> ladders;
  ladders.reserve(subproblems.size());
  for (const Subproblem& subproblem : subproblems) ladders.push_back(make_ladder(subproblem));
  undecided_ = ladders.size();
  try {
    for (Ladder& ladder : ladders) begin_needed(ladder);
    while (!stop && undecided_ > 0) {
      begin_ahead(ladders);
      hand_over();
      for (Attempted& attempted : crew_->wait(stop)) note(std::move(attempted));
    }
  } catch (...) {
    drop_all();
    throw;
  }
  drop_all();
  std::vector<Resolution> resolutions(subproblems.size());
  for (std::size_t i = 0; i < ladders.size() && !stop; ++i) resolutions[i] = ladders[i].take();
  return resolutions;
}

Ladder Foreman::make_ladder(const Subproblem& subproblem) const {
  auto shared = std::make_shared<const Subproblem>(subproblem);
  if (is_robot_alone(subproblem)) return {std::move(shared), {solvers_}};
  std::vector<std::string> levels = levels_of(subproblem, solvers_);
  if (levels.empty()) return {std::move(shared), {}};
  std::vector<std::vector<std::string>> rungs;
  double seconds = 0;
  for (const std::string& level : levels) {
    rungs.push_back({level});
    seconds += estimate_.seconds(subproblem, rungs.back());
  }
  seconds = std::max(seconds, estimate_.seconds(subproblem, levels));
  if (crew_->hands() < 2 || seconds < kWorthSplitting) rungs = {std::move(levels)};
  return {std::move(shared), std::move(rungs)};
}

void Foreman::begin(Ladder& ladder, std::size_t rung, bool is_ahead) {
  const Ticket ticket = next_ticket_++;
  ladder.begin(rung, ticket);
  under_way_[ticket] = {&ladder, rung, is_ahead};
  begun_.push_back({ticket, ladder.subproblem(), ladder.solvers(rung), is_ahead,
                    estimate_.seconds(*ladder.subproblem(), ladder.solvers(rung))});
}

void Foreman::begin_needed(Ladder& ladder) {
  const auto rung = ladder.needed();
  if (!rung) {
    --undecided_;
    return;
  }
  const auto ticket = ladder.ticket(*rung);
  if (!ticket) return begin(ladder, *rung, false);
  under_way_.at(*ticket).is_ahead = false;
  crew_->hurry({*ticket});
}

// One more level of each, in turn.
void Foreman::begin_ahead(std::vector<Ladder>& ladders) {
  const std::size_t hands = crew_->hands();
  for (bool has_more = true; has_more && under_way_.size() < hands;) {
    has_more = false;
    for (Ladder& ladder : ladders) {
      const auto rung = ladder.next_ahead();
      if (!rung || under_way_.size() >= hands) continue;
      begin(ladder, *rung, true);
      has_more = true;
    }
  }
}

void Foreman::hand_over() {
  if (!begun_.empty()) crew_->begin(std::exchange(begun_, {}));
}

void Foreman::note(Attempted attempted) {
  const auto found = under_way_.find(attempted.ticket);
  if (found == under_way_.end()) return;
  const auto [ladder, rung, is_ahead] = found->second;
  under_way_.erase(found);
  if (attempted.failure) {
    if (!is_ahead) std::rethrow_exception(attempted.failure);
    ladder->put_off(rung);
    return;
  }
  estimate_.learn(*ladder->subproblem(), ladder->solvers(rung), attempted.seconds);
  const bool was_needed = ladder->needed() == rung;
  const std::vector<Ticket> moot = ladder->end(rung, std::move(attempted.resolution));
  for (const Ticket ticket : moot) under_way_.erase(ticket);
  if (!moot.empty()) crew_->drop(moot);
  if (was_needed) begin_needed(*ladder);
}

void Foreman::drop_all() {
  std::vector<Ticket> tickets;
  for (const auto& [ticket, under_way] : under_way_) tickets.push_back(ticket);
  under_way_.clear();
  begun_.clear();
  if (!tickets.empty()) crew_->drop(tickets);
}

}  // namespace accord
