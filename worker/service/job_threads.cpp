#include "worker/service/job_threads.h"

#include <exception>
#include <utility>

namespace accord {

JobThreads::JobThreads(SceneShelf& shelf, unsigned threads, std::function<void()> wake)
    : shelf_(shelf), wake_(std::move(wake)) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { serve(); });
}

JobThreads::~JobThreads() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    for (auto& [key, stop] : stops_) *stop = true;
  }
  has_work_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void JobThreads::start(TaskDesk::Job job) {
  auto stop = std::make_shared<std::atomic<bool>>(false);
  {
    const std::lock_guard lock(mutex_);
    stops_[job.key] = stop;
    work_.emplace_back(Running{std::move(job), std::move(stop)});
  }
  has_work_.notify_one();
}

void JobThreads::make_ready(TaskDesk::Scene scene) {
  {
    const std::lock_guard lock(mutex_);
    work_.emplace_front(std::move(scene));  // jobs wait for it
  }
  has_work_.notify_one();
}

void JobThreads::stop(const TaskKey& key) {
  const std::lock_guard lock(mutex_);
  const auto found = stops_.find(key);
  if (found != stops_.end()) *found->second = true;
}

std::optional<JobThreads::Outcome> JobThreads::take() {
  const std::lock_guard lock(mutex_);
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
  return outcome;
}

void JobThreads::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    has_work_.wait(lock, [this] { return quit_ || !work_.empty(); });
    if (quit_) return;
    Work work = std::move(work_.front());
    work_.pop_front();
    lock.unlock();
    Outcome outcome = carry_out(work);
    lock.lock();
    if (const auto* ended = std::get_if<Ended>(&outcome)) stops_.erase(ended->job.key);
    outcomes_.push_back(std::move(outcome));
    lock.unlock();
    wake_();
    lock.lock();
  }
}

JobThreads::Outcome JobThreads::carry_out(Work& work) {
  if (auto* running = std::get_if<Running>(&work)) {
    SceneShelf::Solved solved;
    try {
      solved = shelf_.solve(running->job, *running->stop);
    } catch (const std::exception& error) {
      solved.result.outcome = ResultItem::Outcome::kFailed;
      solved.result.text = error.what();
    }
    return Ended{std::move(running->job), std::move(solved.result), std::move(solved.levels)};
  }
  const auto& scene = std::get<TaskDesk::Scene>(work);
  try {
    const auto added = shelf_.add(scene.hash, scene.bytes);
    return SceneOutcome{scene.hash, added ? "" : added.error()};
  } catch (const std::exception& error) {
    return SceneOutcome{scene.hash, error.what()};
  }
}

}  // namespace accord
