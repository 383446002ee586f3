// The coordinator process at work: the one loop that owns bus, task board, public topics, requests
// and journal, beside threads that read and plan.
// Not thread safe, but for drain().
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "common/transport/bus.h"
#include "common/transport/fleet/fleet_port.h"
#include "coordinator/dispatch/task_board.h"
#include "coordinator/journal/journal.h"
#include "coordinator/service/journal_thread.h"
#include "coordinator/service/mailbox.h"
#include "coordinator/service/planning_threads.h"
#include "coordinator/service/request_desk.h"
#include "coordinator/service/service_tally.h"
#include "coordinator/service/status_board.h"

namespace accord {

class CoordinatorLoop {
 public:
  struct Settings {
    TaskBoard::Settings board;
    RequestDesk::Settings desk;
    PlanningThreads::Settings planning;
    std::string version;
    std::string host;
  };
  // All must outlive this. The fleet port must wake the bus when something arrives.
  CoordinatorLoop(const Settings& settings, Bus& bus, FleetServicePort& fleet, Journal& journal,
                  ServiceTally& tally);

  // Takes up what the journal holds and works until it is drained. Why it could not begin, as a
  // sentence.
  std::optional<std::string> run();

  // Accept nothing more, stop what is under way, keep it in the journal, and end. From any thread;
  // not from a signal handler.
  void drain();

  // For measurements; of the loop's thread.
  const TaskBoard& board() const { return board_; }
  const RequestDesk& desk() const { return desk_; }

 private:
  void turn();
  void take_requests(RequestDesk::Now now);
  void take_outcomes(RequestDesk::Now now);
  void exchange_with_workers(RequestDesk::Now now);
  void act();
  void wait();
  RequestDesk::Now now() const;

  std::optional<std::string> restore();

  Bus& bus_;
  FleetServicePort& fleet_;
  Journal& journal_;
  ServiceTally& tally_;
  TaskBoard board_;
  RequestDesk desk_;
  StatusBoard status_;
  Mailbox mailbox_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::atomic<bool> drain_{false};
  // Last: their threads use what is above.
  std::optional<JournalThread> journal_thread_;
  PlanningThreads threads_;
};

}  // namespace accord
