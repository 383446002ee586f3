#include "tests/bench/scalability/simulated_crew.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tests/bench/scalability/cpu_clock.h"

namespace accord::bench {

SimulatedCrew::SimulatedCrew(CostBook& book, const Cluster& cluster)
    : book_(book), cluster_(cluster), resumed_(cpu_seconds()) {}

double SimulatedCrew::now() const {
  return cluster_.caller_is_free ? clock_ : clock_ + (cpu_seconds() - resumed_);
}

void SimulatedCrew::tell(double time, Event::Kind kind, Ticket ticket) {
  events_.insert({time, order_++, kind, ticket});
}

void SimulatedCrew::begin(std::vector<Attempt> attempts) {
  const double time = now();
  for (Attempt& attempt : attempts) {
    ++account_.attempts;
    account_.ahead += attempt.is_ahead ? 1 : 0;
    tell(time + cluster_.delay, Event::Kind::kArrives, attempt.ticket);
    on_their_way_.emplace(attempt.ticket, std::move(attempt));
  }
}

void SimulatedCrew::hurry(const std::vector<Ticket>& tickets) {
  const double time = now() + cluster_.delay;
  for (const Ticket ticket : tickets) tell(time, Event::Kind::kIsHurried, ticket);
}

void SimulatedCrew::drop(const std::vector<Ticket>& tickets) {
  const double time = now() + cluster_.delay;
  for (const Ticket ticket : tickets) {
    dropped_.insert(ticket);
    std::erase_if(back_, [=](const Attempted& one) { return one.ticket == ticket; });
    tell(time, Event::Kind::kIsDropped, ticket);
  }
}

std::vector<Attempted> SimulatedCrew::wait(const std::atomic<bool>&) {
  const double asked = now();
  account_.caller += asked - clock_;
  clock_ = asked;
  while (!events_.empty() && (back_.empty() || events_.begin()->time <= clock_)) {
    const Event event = *events_.begin();
    events_.erase(events_.begin());
    // The caller sleeps until something is back.
    if (event.kind == Event::Kind::kIsBack && !dropped_.contains(event.ticket)) {
      clock_ = std::max(clock_, event.time);
    }
    happen(event);
  }
  if (back_.empty()) throw std::logic_error("nothing is under way");
  std::vector<Attempted> out(std::move_iterator(back_.begin()), std::move_iterator(back_.end()));
  back_.clear();
  for (const Attempted& one : out) runs_.erase(one.ticket);
  resumed_ = cpu_seconds();
  return out;
}

void SimulatedCrew::happen(const Event& event) {
  if (event.kind == Event::Kind::kArrives) {
    const auto found = on_their_way_.find(event.ticket);
    runs_[event.ticket].attempt = std::move(found->second);
    on_their_way_.erase(found);
    return give_out(event.time);
  }
  const auto found = runs_.find(event.ticket);
  if (found == runs_.end()) return;
  Run& run = found->second;
  switch (event.kind) {
    case Event::Kind::kIsHurried:
      run.attempt.is_ahead = false;
      return give_out(event.time);
    case Event::Kind::kIsDropped:
      if (run.stage == Run::Stage::kIsWorkedOn) lay_down(run, event.time);
      runs_.erase(found);
      return give_out(event.time);
    case Event::Kind::kEnds: {
      // It may have been laid down meanwhile, and taken up again.
      if (run.stage != Run::Stage::kIsWorkedOn || run.end_event != event.order) return;
      lay_down(run, event.time);
      tell(event.time + cluster_.delay, Event::Kind::kIsBack, event.ticket);
      run.stage = Run::Stage::kIsDone;
      return give_out(event.time);
    }
    case Event::Kind::kIsBack: {
      const Entry& entry = book_.of(run.attempt);
      if (dropped_.contains(event.ticket)) {
        runs_.erase(found);
        return;
      }
      account_.longest = std::max(account_.longest, entry.seconds);
      back_.push_back({event.ticket, entry.resolution, entry.seconds, nullptr, {}});
      return;
    }
    case Event::Kind::kArrives:
      return;
  }
}

// Its hand is free again.
void SimulatedCrew::lay_down(Run& run, double time) {
  account_.busy += time - run.begun;
  run.stage = Run::Stage::kWaits;
  --busy_hands_;
}

std::optional<Ticket> SimulatedCrew::next_waiting(bool is_ahead) const {
  for (const auto& [ticket, run] : runs_) {
    if (run.stage == Run::Stage::kWaits && run.attempt.is_ahead == is_ahead) return ticket;
  }
  return std::nullopt;
}

void SimulatedCrew::give_out(double time) {
  make_way(time);
  while (busy_hands_ < cluster_.hands) {
    auto next = next_waiting(false);
    if (!next) next = next_waiting(true);
    if (!next) return;
    Run& run = runs_.at(*next);
    run.stage = Run::Stage::kIsWorkedOn;
    run.begun = time;
    ++busy_hands_;
    run.end_event = order_;
    tell(time + book_.of(run.attempt).seconds, Event::Kind::kEnds, *next);
  }
}

void SimulatedCrew::make_way(double time) {
  std::size_t needed = 0;
  for (const auto& [ticket, run] : runs_) {
    needed += run.stage == Run::Stage::kWaits && !run.attempt.is_ahead ? 1 : 0;
  }
  while (needed > cluster_.hands - busy_hands_) {
    const auto last = std::ranges::find_if(runs_.rbegin(), runs_.rend(), [](const auto& entry) {
      return entry.second.stage == Run::Stage::kIsWorkedOn && entry.second.attempt.is_ahead;
    });
    if (last == runs_.rend()) return;
    lay_down(last->second, time);
  }
}

}  // namespace accord::bench
