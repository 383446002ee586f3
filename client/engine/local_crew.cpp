#include "client/engine/local_crew.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace accord {
namespace {

// Work that takes less all in all is done before threads have woken up for it; and where there is
// but one attempt, nobody else would gain from the caller's being free.
constexpr double kWorthHandingOver = 1e-4;  // s
constexpr double kWorthWatching = 2e-3;     // s: what else could be done meanwhile
// How soon a stop is noticed while others work.
constexpr auto kLookUp = std::chrono::milliseconds(5);

bool erase_ticket(std::deque<Attempt>& attempts, Ticket ticket) {
  return std::erase_if(attempts, [=](const Attempt& one) { return one.ticket == ticket; }) > 0;
}

}  // namespace

LocalCrew::LocalCrew(const CollisionWorld& world, unsigned hands) : worker_(world) {
  if (hands < 2) return;
  try {
    for (unsigned i = 0; i < hands; ++i) threads_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {
    // The system gives no more: those that there are do the work, or the caller.
  }
}

LocalCrew::~LocalCrew() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    for (Running& running : running_) running.stop = true;
  }
  has_work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void LocalCrew::begin(std::vector<Attempt> attempts) {
  const std::lock_guard lock(mutex_);
  for (Attempt& attempt : attempts) queue(std::move(attempt));
  if (is_for_the_caller()) return;
  make_way();
  needed_.size() + ahead_.size() > 1 ? has_work_.notify_all() : has_work_.notify_one();
}

void LocalCrew::queue(Attempt attempt) {
  if (!attempt.is_ahead) {
    needed_.push_back(std::move(attempt));
    return;
  }
  const auto place = std::ranges::upper_bound(ahead_, attempt.ticket, {}, &Attempt::ticket);
  ahead_.insert(place, std::move(attempt));
}

void LocalCrew::hurry(const std::vector<Ticket>& tickets) {
  const std::lock_guard lock(mutex_);
  for (const Ticket ticket : tickets) {
    for (Running& running : running_) {
      if (running.attempt.ticket == ticket) running.attempt.is_ahead = false;
    }
    const auto waiting = std::ranges::find(ahead_, ticket, &Attempt::ticket);
    if (waiting == ahead_.end()) continue;
    Attempt attempt = std::move(*waiting);
    ahead_.erase(waiting);
    attempt.is_ahead = false;
    needed_.push_back(std::move(attempt));
  }
  make_way();
}

void LocalCrew::drop(const std::vector<Ticket>& tickets) {
  const std::lock_guard lock(mutex_);
  for (const Ticket ticket : tickets) {
    if (erase_ticket(needed_, ticket) || erase_ticket(ahead_, ticket)) continue;
    std::erase_if(ended_, [=](const Attempted& one) { return one.ticket == ticket; });
    for (Running& running : running_) {
      if (running.attempt.ticket == ticket) running.stop = running.is_dropped = true;
    }
  }
}

void LocalCrew::make_way() {
  std::size_t hands = threads_.size();
  for (const Running& running : running_) {
    // Those that were stopped leave their hands in a moment.
    if (!running.stop) --hands;
  }
  for (auto running = running_.rbegin(); running != running_.rend() && hands < needed_.size();
       ++running) {
    if (!running->attempt.is_ahead || running->stop) continue;
    running->stop = running->is_put_off = true;
    ++hands;
  }
}

bool LocalCrew::is_for_the_caller() const {
  if (threads_.empty()) return true;
  if (!running_.empty() || !ahead_.empty() || !ended_.empty()) return false;
  double seconds = 0;
  for (const Attempt& attempt : needed_) seconds += attempt.seconds;
  return seconds < (needed_.size() == 1 ? kWorthWatching : kWorthHandingOver);
}

std::vector<Attempted> LocalCrew::wait(const std::atomic<bool>& stop) {
  std::unique_lock lock(mutex_);
  if (ended_.empty() && is_for_the_caller()) {
    const std::deque<Attempt> attempts = std::exchange(needed_, {});
    lock.unlock();
    return carry_out_here(attempts, stop);
  }
  while (!stop && (ended_.empty() || !needed_.empty())) has_ended_.wait_for(lock, kLookUp);
  if (stop) return {};
  return std::exchange(ended_, {});
}

std::vector<Attempted> LocalCrew::carry_out_here(const std::deque<Attempt>& attempts,
                                                 const std::atomic<bool>& stop) const {
  std::vector<Attempted> out;
  for (const Attempt& attempt : attempts) out.push_back(carry_out(attempt, stop));
  if (stop) return {};
  return out;
}

Attempted LocalCrew::carry_out(const Attempt& attempt, const std::atomic<bool>& stop) const {
  Attempted out;
  out.ticket = attempt.ticket;
  const auto begin = std::chrono::steady_clock::now();
  try {
    out.resolution = worker_.solve(*attempt.subproblem, attempt.solvers, stop);
  } catch (...) {  // no memory
    out.failure = std::current_exception();
  }
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return out;
}

void LocalCrew::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    has_work_.wait(lock, [this] { return quit_ || !needed_.empty() || !ahead_.empty(); });
    if (quit_) return;
    run_next(lock);
  }
}

void LocalCrew::run_next(std::unique_lock<std::mutex>& lock) {
  std::deque<Attempt>& from = needed_.empty() ? ahead_ : needed_;
  const auto running = running_.emplace(running_.end());
  running->attempt = std::move(from.front());
  from.pop_front();
  if (needed_.empty() && !ended_.empty()) has_ended_.notify_one();
  lock.unlock();
  Attempted attempted = carry_out(running->attempt, running->stop);
  lock.lock();
  if (running->is_put_off && !running->is_dropped) {
    queue(std::move(running->attempt));
  } else if (!running->stop) {
    ended_.push_back(std::move(attempted));
    if (needed_.empty()) has_ended_.notify_one();
  }
  running_.erase(running);
}

}  // namespace accord
