#include "coordinator/service/coordinator_loop.h"

#include <algorithm>
#include <utility>

#include <spdlog/spdlog.h>

namespace accord {
namespace {

// The longest wait: the time in which nothing is due.
constexpr auto kLongest = std::chrono::milliseconds(100);
// After a drain, what was said last is given so long to arrive.
constexpr auto kLinger = std::chrono::milliseconds(200);

template <typename... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Match(Cases...) -> Match<Cases...>;  // clang 14 does not find it by itself

}  // namespace

CoordinatorLoop::CoordinatorLoop(const Settings& settings, Bus& bus, FleetServicePort& fleet,
                                 Journal& journal, ServiceTally& tally)
    : bus_(bus),
      fleet_(fleet),
      journal_(journal),
      tally_(tally),
      board_(settings.board),
      desk_(settings.desk),
      status_(settings.version, settings.host),
      mailbox_([&bus] { bus.wake(); }),
      threads_(settings.planning, mailbox_, [&bus] { bus.wake(); }) {}

RequestDesk::Now CoordinatorLoop::now() const {
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::steady_clock::now() - began_, std::chrono::duration<double>(wall).count()};
}

void CoordinatorLoop::drain() {
  drain_ = true;
  bus_.wake();
}

std::optional<std::string> CoordinatorLoop::run() {
  if (auto fault = restore()) return fault;
  journal_thread_.emplace(journal_, [this] { bus_.wake(); });
  if (desk_.counters().restored > 0) {
    spdlog::info("takes up {} requests that the journal holds", desk_.counters().restored);
  }
  std::optional<std::chrono::nanoseconds> end;
  while (!end || now().steady < *end) {
    if (drain_ && !desk_.is_draining()) {
      spdlog::info("drains: {} requests wait, {} are being planned", desk_.queued(),
                   desk_.planning());
      desk_.drain(now());
    }
    turn();
    if (!end && desk_.is_done()) end = now().steady + kLinger;
    wait();
  }
  journal_thread_.reset();
  return std::nullopt;
}

std::optional<std::string> CoordinatorLoop::restore() {
  const auto entries = journal_.entries();
  if (!entries) return entries.error();
  for (const JournalEntry& entry : *entries) {
    tl::expected<RequestRecord, std::string> record;
    if (!entry.outcome) {
      const auto bytes = journal_.record(entry.id);
      record = bytes ? decode_record(*bytes) : tl::unexpected(bytes.error());
    }
    desk_.restore(entry, std::move(record), now());
    tally_.note_turn();
  }
  return std::nullopt;
}

void CoordinatorLoop::turn() {
  const RequestDesk::Now time = now();
  take_requests(time);
  take_outcomes(time);
  desk_.settle(time);
  act();
  exchange_with_workers(time);
  if (status_.update(board_, desk_, time.steady)) {
    tally_.note({board_.counters(), desk_.counters(), bus_.counters(), fleet_.counters(),
                 status_.service(), board_.unfinished(), threads_.attempts(),
                 board_.load(time.steady), desk_.load(time)});
  }
  while (auto news = status_.next()) fleet_.publish(*news);
}

void CoordinatorLoop::take_requests(RequestDesk::Now time) {
  while (auto request = fleet_.take()) desk_.on_request(std::move(*request), time);
}

void CoordinatorLoop::take_outcomes(RequestDesk::Now time) {
  while (auto outcome = threads_.take()) {
    std::visit(Match{[&](PlanningThreads::Read& read) {
                       desk_.on_read(read.request, std::move(read.ready), time);
                     },
                     [&](PlanningThreads::Advanced& advanced) {
                       desk_.on_progress(advanced.id, advanced.progress, time);
                     },
                     [&](PlanningThreads::Planned& planned) {
                       spdlog::info("request {}: {}{}{}", planned.id,
                                    to_string(planned.plan.status),
                                    planned.plan.message.empty() ? "" : ": ", planned.plan.message);
                       desk_.on_planned(planned.id, std::move(planned.plan),
                                        std::move(planned.json), time);
                     }},
               *outcome);
  }
  while (auto outcome = journal_thread_->take()) {
    std::visit(Match{[&](JournalThread::Accepted& accepted) {
                       desk_.on_accepted(accepted.ids, accepted.fault, time);
                     },
                     [&](JournalThread::Stored& stored) {
                       desk_.on_stored(stored.ids, stored.fault, time);
                     },
                     [&](JournalThread::Recalled& recalled) {
                       desk_.on_recalled(recalled.id, std::move(recalled.plan));
                     },
                     [&](JournalThread::NotForgotten&) { desk_.on_not_forgotten(); }},
               *outcome);
  }
}

void CoordinatorLoop::act() {
  while (auto action = desk_.next_action()) {
    std::visit(
        Match{[&](RequestDesk::Read& read) { threads_.start_reading(std::move(read.request)); },
              [&](RequestDesk::Begin& begin) {
                spdlog::info("request {}: planning begins", begin.id);
                threads_.start_planning(
                    {std::move(begin.id), std::move(begin.scene), std::move(begin.options)});
              },
              [&](RequestDesk::Stop& stop) { threads_.stop_planning(stop.id); },
              [&](RequestDesk::Publish& publish) { fleet_.publish(publish.news); },
              [&](auto& write) { journal_thread_->start(std::move(write)); }},
        *action);
  }
}

void CoordinatorLoop::exchange_with_workers(RequestDesk::Now time) {
  mailbox_.serve(board_);
  while (const auto event = bus_.take()) board_.on_event(*event, time.steady);
  board_.on_time(time.steady);
  while (auto finished = board_.take_finished()) mailbox_.deliver(std::move(*finished));
  while (const auto out = board_.next_outgoing(time.steady)) {
    board_.on_published(out->to, bus_.publish(out->to, out->message), time.steady);
  }
}

void CoordinatorLoop::wait() {
  const auto time = now().steady;
  auto until = time + kLongest;
  for (const auto due : {board_.next_deadline(), desk_.next_deadline()}) {
    if (due) until = std::min(until, *due);
  }
  if (until > time) bus_.wait_for_event(until - time);
}

}  // namespace accord
