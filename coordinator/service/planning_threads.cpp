#include "coordinator/service/planning_threads.h"

#include <chrono>
#include <new>
#include <stdexcept>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/io/plan_file.h"
#include "coordinator/dispatch/remote_crew.h"
#include "coordinator/service/quarantine.h"

namespace accord {
namespace {

// Nobody could plan it.
Plan failed(const PlanningThreads::Job& job, const std::string& why) {
  return unsolved_plan(job.scene.get(), job.options, PlanStatus::kCancelled, "given up: " + why);
}

// Requests are numbered on from the time, so that no task has the name of one that a worker still
// has from a coordinator that was killed. The upper half of a task's name.
RequestId first_request() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<RequestId>(
             std::chrono::duration_cast<std::chrono::milliseconds>(now).count()) &
         0x7fffffffU;
}

}  // namespace

PlanningThreads::PlanningThreads(Settings settings, Mailbox& mailbox, std::function<void()> wake)
    : settings_(std::move(settings)),
      mailbox_(mailbox),
      wake_(std::move(wake)),
      next_request_(first_request()) {
  threads_.emplace_back([this] { read(); });
  for (unsigned i = 0; i < settings_.planning; ++i) threads_.emplace_back([this] { plan(); });
}

PlanningThreads::~PlanningThreads() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    for (const auto& [id, stop] : stops_) *stop = true;
  }
  has_work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void PlanningThreads::start_reading(PlanRequest request) {
  {
    const std::lock_guard lock(mutex_);
    to_read_.push_back(std::move(request));
  }
  has_work_.notify_all();
}

void PlanningThreads::start_planning(Job job) {
  {
    const std::lock_guard lock(mutex_);
    auto stop = std::make_shared<std::atomic<bool>>(false);
    stops_[job.id] = stop;
    to_plan_.push_back({std::move(job), std::move(stop)});
  }
  has_work_.notify_all();
}

void PlanningThreads::stop_planning(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto found = stops_.find(id);
  if (found != stops_.end()) *found->second = true;
}

std::optional<PlanningThreads::Outcome> PlanningThreads::take() {
  const std::lock_guard lock(mutex_);
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
  return outcome;
}

void PlanningThreads::report(Outcome outcome) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto* planned = std::get_if<Planned>(&outcome)) stops_.erase(planned->id);
    outcomes_.push_back(std::move(outcome));
  }
  wake_();
}

void PlanningThreads::read() {
  while (true) {
    PlanRequest request;
    {
      std::unique_lock lock(mutex_);
      has_work_.wait(lock, [this] { return quit_ || !to_read_.empty(); });
      if (quit_) return;
      request = std::move(to_read_.front());
      to_read_.pop_front();
    }
    report(read(std::move(request)));
  }
}

PlanningThreads::Read PlanningThreads::read(PlanRequest request) const {
  Read read{std::move(request), {}};
  try {
    auto scene = load_request(read.request, settings_.scenes, settings_.limits);
    if (scene) {
      read.ready = ReadyRequest{*scene, encode_record(read.request, **scene)};
    } else {
      read.ready = tl::unexpected(std::move(scene.error()));
    }
  } catch (const std::bad_alloc&) {
    read.ready = tl::unexpected(
        RequestFault{Rejection::kTooLarge, "", "the service has not enough memory for it"});
  }
  return read;
}

void PlanningThreads::plan() {
  while (true) {
    Running running;
    {
      std::unique_lock lock(mutex_);
      has_work_.wait(lock, [this] { return quit_ || !to_plan_.empty(); });
      if (quit_) return;
      running = std::move(to_plan_.front());
      to_plan_.pop_front();
    }
    Planned planned{running.job.id, {}, {}};
    try {
      planned.plan = plan(running);
      planned.json = to_json(planned.plan);
      report(std::move(planned));
      continue;
    } catch (const TaskFailure& failure) {
      planned.plan = failed(
          running.job, failure.what() + keep_task(settings_.quarantine, running.job.id, failure));
    } catch (const std::bad_alloc&) {
      planned.plan = failed(running.job, "the service has not enough memory");
    } catch (const std::exception& bug) {
      spdlog::error("request {}: internal error: {}", running.job.id, bug.what());
      planned.plan = failed(running.job, std::string("internal error: ") + bug.what());
    }
    planned.json = to_json(planned.plan);
    report(std::move(planned));
  }
}

Plan PlanningThreads::plan(const Running& running) {
  RequestId request = 0;
  {
    const std::lock_guard lock(mutex_);
    request = next_request_++;
  }
  const Job& job = running.job;
  const CrewFactory of_workers = [&](const CollisionWorld&, const CollisionWorld& detection) {
    return std::make_unique<RemoteCrew>(mailbox_.open_port(request), detection, &attempts_);
  };
  return plan_with(
      of_workers, job.scene, job.options,
      [&](const Progress& progress) {
        report(Advanced{job.id, progress});
      },
      running.stop.get());
}

}  // namespace accord
