// A crew of any number of hands in virtual time: attempts take what the book says, messages what
// they are said to, and what the caller does between two calls of wait() takes what it costs on
// this machine. A discrete-event simulation, so that 64 hands can be seen to work on two cores. Not
// thread safe.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "coordinator/crew.h"
#include "tests/bench/scalability/cost_book.h"

namespace accord::bench {

struct Cluster {
  std::size_t hands = 1;
  double delay = 0;             // s: of a message, one way
  bool caller_is_free = false;  // what the caller does takes no time: to see what that would change
};

class SimulatedCrew final : public Crew {
 public:
  // The book must outlive this.
  SimulatedCrew(CostBook& book, const Cluster& cluster);

  void begin(std::vector<Attempt> attempts) override;
  void hurry(const std::vector<Ticket>& tickets) override;
  void drop(const std::vector<Ticket>& tickets) override;
  std::vector<Attempted> wait(const std::atomic<bool>& stop) override;
  std::size_t hands() const override { return cluster_.hands; }

  // s since it was made, in virtual time.
  double now() const;

  struct Account {
    std::size_t attempts = 0;
    std::size_t ahead = 0;  // of these, begun ahead of need
    double caller = 0;      // s: what the caller was busy
    double busy = 0;        // s: all hands together
    double longest = 0;     // s: an attempt
  };
  const Account& account() const { return account_; }

 private:
  struct Event {
    enum class Kind { kArrives, kIsHurried, kIsDropped, kEnds, kIsBack };
    double time;
    std::uint64_t order;  // of events at the same time
    Kind kind;
    Ticket ticket;

    bool operator<(const Event& other) const {
      return std::tie(time, order) < std::tie(other.time, other.order);
    }
  };
  struct Run {
    Attempt attempt;
    enum class Stage { kWaits, kIsWorkedOn, kIsDone } stage = Stage::kWaits;
    double begun = 0;             // s: when a hand took it up
    std::uint64_t end_event = 0;  // its end's order: an earlier run of it is over
  };

  void tell(double time, Event::Kind kind, Ticket ticket);
  void happen(const Event& event);
  void give_out(double time);
  std::optional<Ticket> next_waiting(bool is_ahead) const;
  // The attempt ahead of need that was taken up last, if all hands are busy.
  void make_way(double time);
  void lay_down(Run& run, double time);

  CostBook& book_;
  Cluster cluster_;
  double clock_ = 0;  // s: when wait() returned last
  double resumed_;    // the processor time then
  std::uint64_t order_ = 0;
  std::set<Event> events_;
  std::map<Ticket, Run> runs_;  // that have arrived and not ended
  std::map<Ticket, Attempt> on_their_way_;
  std::size_t busy_hands_ = 0;
  std::deque<Attempted> back_;
  std::set<Ticket> dropped_;
  Account account_;
};

}  // namespace accord::bench
