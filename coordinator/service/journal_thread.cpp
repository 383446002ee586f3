#include "coordinator/service/journal_thread.h"

#include <iterator>
#include <new>
#include <utility>

#include <spdlog/spdlog.h>

#include "common/io/plan_file.h"

namespace accord {
namespace {

// How many plans are forgotten at a time.
constexpr std::size_t kForgetAtOnce = 64;

// Neighbours of one kind become one: a disk takes as long for many as for one.
template <typename Write>
bool merge(JournalThread::Work& first, JournalThread::Work& second) {
  auto* into = std::get_if<Write>(&first);
  auto* from = std::get_if<Write>(&second);
  if (into == nullptr || from == nullptr) return false;
  std::ranges::move(from->requests, std::back_inserter(into->requests));
  return true;
}

template <typename Write>
std::vector<std::string> ids_of(const Write& write) {
  std::vector<std::string> ids;
  for (const auto& request : write.requests) ids.push_back(request.id);
  return ids;
}

}  // namespace

JournalThread::JournalThread(Journal& journal, std::function<void()> wake)
    : journal_(journal), wake_(std::move(wake)), thread_([this] { serve(); }) {}

JournalThread::~JournalThread() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  has_work_.notify_one();
  thread_.join();
}

void JournalThread::start(Work work) {
  {
    const std::lock_guard lock(mutex_);
    const bool is_merged = !work_.empty() && (merge<RequestDesk::Accept>(work_.back(), work) ||
                                              merge<RequestDesk::Finish>(work_.back(), work));
    if (!is_merged) work_.push_back(std::move(work));
  }
  has_work_.notify_one();
}

std::optional<JournalThread::Outcome> JournalThread::take() {
  const std::lock_guard lock(mutex_);
  if (outcomes_.empty()) return std::nullopt;
  Outcome outcome = std::move(outcomes_.front());
  outcomes_.pop_front();
  return outcome;
}

void JournalThread::report(Outcome outcome) {
  {
    const std::lock_guard lock(mutex_);
    outcomes_.push_back(std::move(outcome));
  }
  wake_();
}

void JournalThread::serve() {
  while (true) {
    std::optional<Work> work;
    {
      std::unique_lock lock(mutex_);
      has_work_.wait(lock, [this] { return quit_ || !work_.empty(); });
      if (work_.empty()) return;
      work = std::move(work_.front());
      work_.pop_front();
    }
    std::visit([this](const auto& kind) { carry_out(kind); }, *work);
  }
}

void JournalThread::tell(const std::string& fault, const char* what_follows) {
  if (!fault.empty()) {
    spdlog::error("journal: {}: {}", what_follows, fault);
  } else if (is_failing_) {
    spdlog::info("journal: takes writes again");
  }
  is_failing_ = !fault.empty();
}

void JournalThread::carry_out(const RequestDesk::Accept& work) {
  const auto written = journal_.accept(work.requests);
  std::string fault = written ? "" : written.error();
  tell(fault, "requests are refused");
  report(Accepted{ids_of(work), std::move(fault)});
}

void JournalThread::carry_out(const RequestDesk::Finish& work) {
  const auto written = journal_.finish(work.requests);
  std::string fault = written ? "" : written.error();
  tell(fault, "plans are kept in memory for now");
  report(Stored{ids_of(work), std::move(fault)});
}

void JournalThread::carry_out(const RequestDesk::Recall& work) {
  try {
    auto json = journal_.plan(work.id);
    if (!json) {
      report(Recalled{work.id, tl::unexpected(std::move(json.error()))});
      return;
    }
    PlanResult read = parse_plan(*json, work.id);
    if (read.plan) {
      report(Recalled{work.id, std::move(*read.plan)});
    } else {
      report(Recalled{work.id, tl::unexpected("the plan that was kept cannot be read: " +
                                              to_string(read.faults.front()))});
    }
  } catch (const std::bad_alloc&) {
    report(Recalled{work.id, tl::unexpected(std::string("not enough memory for the plan"))});
  }
}

void JournalThread::carry_out(const RequestDesk::Forget& work) {
  while (true) {
    const auto forgotten = journal_.forget_finished_before(work.before, kForgetAtOnce);
    if (!forgotten) {
      tell(forgotten.error(), "old plans are kept longer");
      report(NotForgotten{});
      return;
    }
    if (*forgotten < kForgetAtOnce) return;
  }
}

}  // namespace accord
