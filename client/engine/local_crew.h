// A crew of threads of this process.
//
// One hand is the caller's own thread: wait() carries out what was begun, in order, and nothing
// ahead of need. With more there is a thread a hand, so that the caller is free to decide what
// comes next while others work; what is over sooner than it is handed over stays with the caller.
// Not thread safe, as every Crew.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

#include "coordinator/crew.h"
#include "worker/worker.h"

namespace accord {

class LocalCrew final : public Crew {
 public:
  // The world must outlive this. As many hands as told, or as threads that the system gives.
  // Requires: hands > 0.
  LocalCrew(const CollisionWorld& world, unsigned hands);
  // Stops what is under way, and waits for it.
  ~LocalCrew() override;
  LocalCrew(const LocalCrew&) = delete;
  LocalCrew& operator=(const LocalCrew&) = delete;

  void begin(std::vector<Attempt> attempts) override;
  void hurry(const std::vector<Ticket>& tickets) override;
  void drop(const std::vector<Ticket>& tickets) override;
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override;
  std::size_t hands() const override { return std::max<std::size_t>(1, threads_.size()); }

 private:
  struct Running {
    Attempt attempt;
    std::atomic<bool> stop{false};
    bool is_dropped = false;
    bool is_put_off = false;
  };

  Attempted carry_out(const Attempt& attempt, const std::atomic<bool>& stop) const;
  std::vector<Attempted> carry_out_here(const std::deque<Attempt>& attempts,
                                        const std::atomic<bool>& stop) const;
  bool is_for_the_caller() const;
  void queue(Attempt attempt);
  // Stops attempts ahead of need, the last one first, until there are hands for all that is needed.
  void make_way();
  void serve();
  void run_next(std::unique_lock<std::mutex>& lock);

  Worker worker_;
  mutable std::mutex mutex_;
  std::condition_variable has_work_, has_ended_;
  bool quit_ = false;
  std::deque<Attempt> needed_, ahead_;  // not begun by anybody; by ticket, those ahead
  std::list<Running> running_;
  std::vector<Attempted> ended_;
  std::vector<std::thread> threads_;
};

}  // namespace accord
