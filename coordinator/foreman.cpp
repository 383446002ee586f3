#include "coordinator/foreman.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <spdlog/fmt/ranges.h>
#include <spdlog/spdlog.h>

#include "common/planning/identity.h"
#include "common/planning/levels.h"
#include "common/runtime/log.h"
#include "coordinator/stopwatch.h"

namespace accord {
namespace {

// Levels of a subproblem that takes less than this all in all are one attempt: telling the crew of
// each would take longer than is won.
constexpr double kWorthSplitting = 2e-3;  // s
// Foresight may take this share of the time that is waited for work: it is for slow work.
constexpr double kShareOfForesight = 0.1;
// Subproblems that are foreseen at a time, for each hand.
constexpr std::size_t kForeseenPerHand = 2;

// A line for each attempt that led to the resolution of a subproblem that was asked for.
void log_climb(std::uint64_t number, const Ladder& ladder) {
  if (!logs(LogLevel::kDebug)) return;
  for (const auto& [solvers, resolution, doer] : ladder.climbed()) {
    std::vector<LogField> fields{{"subproblem", number},
                                 {"outcome", to_string(outcome_of(resolution))},
                                 {"solvers", fmt::format("{}", fmt::join(solvers, ","))},
                                 {"seconds", doer.seconds}};
    if (!resolution.solver.empty()) fields.emplace_back("solver", resolution.solver);
    if (!doer.task.empty()) fields.emplace_back("task", doer.task);
    if (!doer.worker.empty()) fields.emplace_back("worker", doer.worker);
    log(LogLevel::kDebug, "attempt at a subproblem", fields);
  }
}

}  // namespace

std::vector<Resolution> Foreman::solve(const std::vector<Subproblem>& subproblems,
                                       const std::atomic<bool>& stop, const Foresight& foresight) {
  for (const Subproblem& subproblem : subproblems) {
    asked_.push_back(take_ladder(subproblem, foreseen_));
  }
  asked_so_far_ += subproblems.size();
  std::vector<Resolution> resolutions(subproblems.size());
  try {
    work(stop, foresight);
  } catch (...) {
    drop(std::exchange(asked_, {}));
    drop(std::exchange(foreseen_, {}));
    throw;
  }
  const Ladders asked = std::exchange(asked_, {});
  if (stop) {
    drop(asked);
    drop(std::exchange(foreseen_, {}));
    return resolutions;
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    log_climb(asked_so_far_ - asked.size() + i + 1, *asked[i]);
    resolutions[i] = asked[i]->take();
  }
  return resolutions;
}

void Foreman::work(const std::atomic<bool>& stop, const Foresight& foresight) {
  undecided_ = asked_.size();
  has_news_ = true;
  for (const auto& ladder : asked_) begin_needed(*ladder);
  while (!stop && undecided_ > 0) {
    begin_ahead(asked_);
    if (under_way_.size() < crew_->hands()) foresee(foresight);
    hand_over();
    for (Attempted& attempted : crew_->wait(stop)) note(std::move(attempted));
  }
}

std::unique_ptr<Ladder> Foreman::make_ladder(const Subproblem& subproblem) const {
  auto shared = std::make_shared<const Subproblem>(subproblem);
  const auto ladder_of = [&](std::vector<std::vector<std::string>> rungs) {
    return std::make_unique<Ladder>(std::move(shared), std::move(rungs));
  };
  if (is_robot_alone(subproblem)) return ladder_of({solvers_});
  std::vector<std::string> levels = levels_of(subproblem, solvers_);
  if (levels.empty()) return ladder_of({});
  std::vector<std::vector<std::string>> rungs;
  double seconds = 0;
  for (const std::string& level : levels) {
    rungs.push_back({level});
    seconds += estimate_.seconds(subproblem, rungs.back());
  }
  seconds = std::max(seconds, estimate_.seconds(subproblem, levels));
  if (crew_->hands() < 2 || seconds < kWorthSplitting) return ladder_of({std::move(levels)});
  return ladder_of(std::move(rungs));
}

std::unique_ptr<Ladder> Foreman::take_ladder(const Subproblem& subproblem, Ladders& from) const {
  const auto found = std::ranges::find_if(
      from, [&](const auto& ladder) { return are_identical(*ladder->subproblem(), subproblem); });
  if (found == from.end()) return make_ladder(subproblem);
  std::unique_ptr<Ladder> ladder = std::move(*found);
  from.erase(found);
  return ladder;
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
void Foreman::begin_ahead(const Ladders& ladders) {
  const std::size_t hands = crew_->hands();
  for (bool has_more = true; has_more && under_way_.size() < hands;) {
    has_more = false;
    for (const auto& ladder : ladders) {
      const auto rung = ladder->next_ahead();
      if (!rung || under_way_.size() >= hands) continue;
      begin(*ladder, *rung, true);
      has_more = true;
    }
  }
}

void Foreman::foresee(const Foresight& foresight) {
  if (foresight && has_news_ && foresaw_ <= kShareOfForesight * waited_) {
    has_news_ = false;
    const Stopwatch watch;
    Ladders stale = std::exchange(foreseen_, {});
    const auto is_asked = [this](const Subproblem& subproblem) {
      return std::ranges::any_of(asked_, [&](const auto& ladder) {
        return are_identical(*ladder->subproblem(), subproblem);
      });
    };
    const Likely known = [&](const Subproblem& subproblem) { return likely(subproblem, stale); };
    for (const Subproblem& subproblem : foresight(known, kForeseenPerHand * crew_->hands())) {
      if (!is_asked(subproblem)) foreseen_.push_back(take_ladder(subproblem, stale));
    }
    drop(stale);
    foresaw_ += watch.seconds();
  }
  for (const auto& ladder : foreseen_) {
    const auto rung = ladder->needed();
    if (under_way_.size() >= crew_->hands()) return;
    if (rung && ladder->is_open(*rung)) begin(*ladder, *rung, true);
  }
  begin_ahead(foreseen_);
}

std::optional<Resolution> Foreman::likely(const Subproblem& subproblem,
                                          const Ladders& foreseen) const {
  for (const Ladders* ladders : {&asked_, &foreseen}) {
    for (const auto& ladder : *ladders) {
      if (are_identical(*ladder->subproblem(), subproblem)) return ladder->likely();
    }
  }
  return std::nullopt;
}

void Foreman::hand_over() {
  if (!begun_.empty()) crew_->begin(std::exchange(begun_, {}));
}

void Foreman::note(Attempted attempted) {
  const auto found = under_way_.find(attempted.ticket);
  if (found == under_way_.end()) return;
  const auto [ladder, rung, is_ahead] = found->second;
  // So many were waited for at the same time.
  waited_ += attempted.seconds / static_cast<double>(under_way_.size());
  under_way_.erase(found);
  has_news_ = true;
  attempted.doer.seconds = attempted.seconds;
  if (attempted.failure) {
    if (!is_ahead) std::rethrow_exception(attempted.failure);
    ladder->put_off(rung);
    return;
  }
  estimate_.learn(*ladder->subproblem(), ladder->solvers(rung), attempted.seconds);
  const std::vector<Ticket> moot =
      ladder->end(rung, std::move(attempted.resolution), std::move(attempted.doer));
  for (const Ticket ticket : moot) under_way_.erase(ticket);
  if (!moot.empty()) crew_->drop(moot);
  if (!is_ahead) begin_needed(*ladder);
}

void Foreman::drop(const Ladders& ladders) {
  std::vector<Ticket> tickets;
  for (const auto& [ticket, under_way] : under_way_) {
    const auto its = std::ranges::find(ladders, under_way.ladder, &std::unique_ptr<Ladder>::get);
    if (its != ladders.end()) tickets.push_back(ticket);
  }
  for (const Ticket ticket : tickets) under_way_.erase(ticket);
  std::erase_if(begun_, [&](const Attempt& attempt) {
    return std::ranges::find(tickets, attempt.ticket) != tickets.end();
  });
  if (!tickets.empty()) crew_->drop(tickets);
}

}  // namespace accord
