// Threads beside the coordinator's loop: they read what requests bring, and plan. Solving is the
// workers' business; what is left here is conflicts, subproblems and the proof.
//
// start_*(), stop() and take() are for the loop; nothing here waits for anything but the
// destructor, which stops what runs and waits for it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "common/io/request_scene.h"
#include "common/model/plan.h"
#include "common/model/plan_request.h"
#include "common/model/scene.h"
#include "common/planning/attempt_tally.h"
#include "coordinator/planner.h"
#include "coordinator/service/mailbox.h"
#include "coordinator/service/request_record.h"

namespace accord {

class PlanningThreads {
 public:
  struct Settings {
    unsigned planning = 1;             // requests at a time
    unsigned threads = 1;              // of each proof
    std::filesystem::path scenes;      // stored ones; empty: none
    RequestLimits limits;              // of what requests bring
    std::filesystem::path quarantine;  // for tasks that could not be solved; empty: none are kept
  };
  // `wake` rouses the loop: take() has something. Called from any thread. The mailbox must outlive
  // this.
  PlanningThreads(Settings settings, Mailbox& mailbox, std::function<void()> wake);
  ~PlanningThreads();
  PlanningThreads(const PlanningThreads&) = delete;
  PlanningThreads& operator=(const PlanningThreads&) = delete;

  struct Job {
    std::string id;
    std::shared_ptr<const Scene> scene;
    PlanOptions options;
  };
  // Reads a request's scene and checks all that it says.
  void start_reading(PlanRequest request);
  void start_planning(Job job);
  // Planning of a request ends soon, as cancelled; nothing happens where it is not there.
  void stop_planning(const std::string& id);

  struct Read {
    PlanRequest request;
    tl::expected<ReadyRequest, RequestFault> ready;
  };
  struct Advanced {
    std::string id;
    Progress progress;
  };
  struct Planned {
    std::string id;
    Plan plan;
    std::string json;  // the same as a plan file
  };
  using Outcome = std::variant<Read, Advanced, Planned>;
  std::optional<Outcome> take();

  // How attempts at subproblems have gone so far.
  AttemptTally::Totals attempts() const { return attempts_.totals(); }

 private:
  struct Running {
    Job job;
    std::shared_ptr<std::atomic<bool>> stop;
  };

  void read();
  Read read(PlanRequest request) const;
  void plan();
  Plan plan(const Running& running);
  void report(Outcome outcome);

  Settings settings_;
  Mailbox& mailbox_;
  std::function<void()> wake_;
  AttemptTally attempts_;
  std::mutex mutex_;
  std::condition_variable has_work_;
  bool quit_ = false;
  std::deque<PlanRequest> to_read_;
  std::deque<Running> to_plan_;
  std::deque<Outcome> outcomes_;
  std::map<std::string, std::shared_ptr<std::atomic<bool>>> stops_;  // of what is to be planned
  RequestId next_request_;
  std::vector<std::thread> threads_;
};

}  // namespace accord
