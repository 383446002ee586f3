#include "tests/simulation/simulated_coordinator.h"

#include <algorithm>
#include <variant>

#include "common/io/plan_file.h"
#include "common/io/request_scene.h"
#include "common/planning/method_names.h"
#include "coordinator/dispatch/remote_crew.h"

namespace accord::testing {
namespace {

RequestDesk::Settings small_desk() {
  RequestDesk::Settings settings;
  settings.queued = 2;
  return settings;
}

RequestLimits limits_of_requests() {
  RequestLimits limits;
  limits.methods = method_names();
  limits.solvers = local_solver_names();
  return limits;
}

template <typename Write>
std::vector<std::string> ids_of(const Write& write) {
  std::vector<std::string> ids;
  for (const auto& request : write.requests) ids.push_back(request.id);
  return ids;
}

// Progress of each phase once: how often it comes beyond that hangs on the real clock, which no
// seed repeats.
ProgressCallback once_a_phase(std::function<void(const Progress&)> tell) {
  return [tell = std::move(tell),
          last = std::optional<Progress::Phase>{}](const Progress& progress) mutable {
    if (std::exchange(last, progress.phase) != progress.phase) tell(progress);
  };
}

Plan without_paths(const RequestDesk::Begin& job, std::string message) {
  Plan plan;
  plan.scene = job.scene->name;
  plan.method = job.options.method;
  plan.seed = job.options.seed;
  plan.timestep = job.scene->timestep;
  plan.status = PlanStatus::kCancelled;
  plan.message = std::move(message);
  return plan;
}

}  // namespace

SimulatedCoordinator::SimulatedCoordinator(SimulatedCluster& cluster, SimulatedFleet& fleet,
                                           Journal& journal, CoordinatorWatcher& watcher,
                                           std::uint64_t seed)
    : cluster_(cluster),
      journal_(journal),
      watcher_(watcher),
      random_(seed),
      bus_(cluster.network().join(Role::kCoordinator)),
      port_(fleet.serve([] {})),
      desk_(small_desk()),
      turn_([this](Bus&, std::optional<Time> deadline) { return turn(deadline); }),
      idle_(*bus_, board_, 0, turn_) {
  restore();
}

void SimulatedCoordinator::restore() {
  const auto entries = journal_.entries();
  for (const JournalEntry& entry : *entries) {
    tl::expected<RequestRecord, std::string> record;
    if (!entry.outcome) record = decode_record(*journal_.record(entry.id));
    desk_.restore(entry, std::move(record), now());
  }
}

RequestDesk::Now SimulatedCoordinator::now() const {
  return {cluster_.now(), 1e9 + std::chrono::duration<double>(cluster_.now()).count()};
}

bool SimulatedCoordinator::is_idle() const {
  return errands_.empty() && !to_plan_ && desk_.queued() == 0 && desk_.planning() == 0;
}

// ---- The loop ----

void SimulatedCoordinator::work() {
  if (!to_plan_) {
    idle_.turn();
    return;
  }
  const RequestDesk::Begin job = *std::exchange(to_plan_, std::nullopt);
  planning_ = job.id;
  Plan plan = this->plan(job);
  planning_.clear();
  is_to_stop_ = false;
  std::string json = to_json(plan);
  desk_.on_planned(job.id, std::move(plan), std::move(json), now());
  act();
}

SimulatedCoordinator::Time SimulatedCoordinator::turn(std::optional<Time> deadline) {
  for (const auto due :
       {desk_.next_deadline(),
        errands_.empty() ? std::nullopt : std::optional(errands_.begin()->first.first)}) {
    if (due) deadline = deadline ? std::min(*deadline, *due) : *due;
  }
  cluster_.pass(deadline);
  watcher_.at_turn();
  while (auto request = port_->take()) {
    watcher_.on_taken(*request);
    desk_.on_request(std::move(*request), now());
    act();
  }
  run_errands();
  desk_.settle(now());
  act();
  if (is_to_stop_ && !planning_.empty()) throw Stopped{};
  return cluster_.now();
}

void SimulatedCoordinator::act() {
  while (auto action = desk_.next_action()) {
    watcher_.at_step();
    carry_out(std::move(*action));
  }
}

void SimulatedCoordinator::carry_out(RequestDesk::Action action) {
  if (auto* begin = std::get_if<RequestDesk::Begin>(&action)) {
    to_plan_ = std::move(*begin);
  } else if (const auto* stop = std::get_if<RequestDesk::Stop>(&action)) {
    if (stop->id == planning_ || (to_plan_ && to_plan_->id == stop->id)) is_to_stop_ = true;
  } else if (auto* request = std::get_if<RequestDesk::Read>(&action)) {
    start_errand(reader_busy_until_,
                 [this, request = std::move(request->request)] { read(request); });
  } else if (auto* accept = std::get_if<RequestDesk::Accept>(&action)) {
    start_errand(disk_busy_until_, [this, work = std::move(*accept)] { this->accept(work); });
  } else if (auto* finish = std::get_if<RequestDesk::Finish>(&action)) {
    start_errand(disk_busy_until_, [this, work = std::move(*finish)] { this->finish(work); });
  } else if (const auto* wanted = std::get_if<RequestDesk::Recall>(&action)) {
    start_errand(disk_busy_until_, [this, id = wanted->id] { recall(id); });
  } else if (const auto* publish = std::get_if<RequestDesk::Publish>(&action)) {
    watcher_.on_said(publish->news);
    port_->publish(publish->news);
  }
}

// ---- Its threads ----

void SimulatedCoordinator::start_errand(Time& thread_busy_until, std::function<void()> what) {
  const auto takes = std::chrono::microseconds(100 + random_.below(20'000));
  thread_busy_until = std::max(thread_busy_until, cluster_.now()) + takes;
  errands_.emplace(std::pair(thread_busy_until, next_errand_++), std::move(what));
}

void SimulatedCoordinator::run_errands() {
  while (!errands_.empty() && errands_.begin()->first.first <= cluster_.now()) {
    const auto errand = errands_.extract(errands_.begin());
    watcher_.at_step();
    errand.mapped()();
  }
}

void SimulatedCoordinator::read(const PlanRequest& request) {
  static const RequestLimits limits = limits_of_requests();
  auto scene = load_request(request, {}, limits);
  if (!scene) {
    desk_.on_read(request, tl::unexpected(std::move(scene.error())), now());
    return;
  }
  desk_.on_read(request, ReadyRequest{*scene, encode_record(request, **scene)}, now());
}

// A while passes between a write and its answer: the process may die in between, too.
void SimulatedCoordinator::accept(const RequestDesk::Accept& work) {
  const auto written = journal_.accept(work.requests);
  const std::string fault = written ? "" : written.error();
  watcher_.on_written(work, fault);
  start_errand(disk_answers_until_,
               [this, ids = ids_of(work), fault] { desk_.on_accepted(ids, fault, now()); });
}

void SimulatedCoordinator::finish(const RequestDesk::Finish& work) {
  const auto written = journal_.finish(work.requests);
  const std::string fault = written ? "" : written.error();
  watcher_.on_written(work, fault);
  start_errand(disk_answers_until_,
               [this, ids = ids_of(work), fault] { desk_.on_stored(ids, fault, now()); });
}

void SimulatedCoordinator::recall(const std::string& id) {
  const auto json = journal_.plan(id);
  auto plan = json ? tl::expected<Plan, std::string>(*parse_plan(*json, id).plan)
                   : tl::unexpected(json.error());
  start_errand(disk_answers_until_,
               [this, id, plan = std::move(plan)] { desk_.on_recalled(id, plan); });
}

Plan SimulatedCoordinator::plan(const RequestDesk::Begin& job) {
  const CrewFactory of_workers = [&](const CollisionWorld&, const CollisionWorld& detection) {
    return std::make_unique<RemoteCrew>(
        std::make_unique<DirectPort>(*bus_, board_, next_request_++, turn_), detection);
  };
  try {
    return plan_with(of_workers, job.scene, job.options,
                     once_a_phase([&](const Progress& progress) {
                       desk_.on_progress(job.id, progress, now());
                     }));
  } catch (const Stopped&) {
    return without_paths(job, "cancelled");
  } catch (const TaskFailure& failure) {
    return without_paths(job, std::string("given up: ") + failure.what());
  }
}

}  // namespace accord::testing
