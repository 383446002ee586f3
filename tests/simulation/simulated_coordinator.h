// One life of a coordinator process: desk, board, planning and proof are the real ones, on a
// simulated network. Its threads are simulated: reading and writing take time that is drawn, and
// planning runs on this thread, the loop's turns being what it waits for.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/planning/random.h"
#include "common/transport/fleet/simulated_fleet.h"
#include "coordinator/dispatch/direct_port.h"
#include "coordinator/journal/journal.h"
#include "coordinator/service/request_desk.h"
#include "tests/support/simulated_cluster.h"

namespace accord::testing {

// Thrown by who wants the process dead; nothing of it is left but its journal.
struct Killed {};

// Who looks on as a coordinator works. All may throw Killed.
class CoordinatorWatcher {
 public:
  virtual ~CoordinatorWatcher() = default;

  virtual void at_turn() = 0;  // of the loop; time has moved on
  // Between any two things that a process does.
  virtual void at_step() = 0;
  virtual void on_taken(const FleetRequest& request) = 0;  // before it is looked at
  virtual void on_said(const FleetNews& news) = 0;         // before anybody hears it
  // What the journal has made of a write; empty: it is there.
  virtual void on_written(const RequestDesk::Accept& work, const std::string& fault) = 0;
  virtual void on_written(const RequestDesk::Finish& work, const std::string& fault) = 0;
};

class SimulatedCoordinator {
 public:
  using Time = Bus::Duration;

  // Takes up what the journal holds. All must outlive this.
  SimulatedCoordinator(SimulatedCluster& cluster, SimulatedFleet& fleet, Journal& journal,
                       CoordinatorWatcher& watcher, std::uint64_t seed);

  // One turn of the loop; or a whole request is planned, with all the turns that this takes.
  void work();
  void drain() { desk_.drain(now()); }
  // Drained, and all is written that was to be.
  bool is_done() const { return desk_.is_done() && errands_.empty(); }
  // Nothing is left to do for it.
  bool is_idle() const;

  EndpointId id() const { return bus_->self(); }

 private:
  struct Stopped {};  // unwinds planning

  void restore();
  RequestDesk::Now now() const;
  Time turn(std::optional<Time> deadline);
  void act();
  void carry_out(RequestDesk::Action action);
  void read(const PlanRequest& request);
  void accept(const RequestDesk::Accept& work);
  void finish(const RequestDesk::Finish& work);
  void recall(const std::string& id);
  Plan plan(const RequestDesk::Begin& job);

  // What another thread does: `what` happens in a while, after all that was asked of that thread
  // before.
  void start_errand(Time& thread_busy_until, std::function<void()> what);
  void run_errands();

  SimulatedCluster& cluster_;
  Journal& journal_;
  CoordinatorWatcher& watcher_;
  RandomStream random_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<FleetServicePort> port_;
  TaskBoard board_{TaskBoard::Settings{}};
  RequestDesk desk_;
  DirectPort::Turn turn_;
  DirectPort idle_;
  std::optional<RequestDesk::Begin> to_plan_;
  RequestId next_request_ = 1;
  std::string planning_;     // its id; empty: none is
  bool is_to_stop_ = false;  // what is being planned, or is to be next
  std::map<std::pair<Time, std::uint64_t>, std::function<void()>> errands_;
  std::uint64_t next_errand_ = 0;
  Time reader_busy_until_{0}, disk_busy_until_{0}, disk_answers_until_{0};
};

}  // namespace accord::testing
