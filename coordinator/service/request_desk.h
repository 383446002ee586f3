// The coordinator's books of requests: who asked for what, how far it has come, what is to be said.
// A state machine: events and the time go in, actions come out. No threads, no DDS, no clock, no
// files.
//
// What it promises:
//   * a request is answered as accepted once it is in the journal, not before; where the journal
//     cannot be written, it is refused. Planning need not wait for that: it begins at once;
//   * an accepted request ends with one plan, or the reason why there is none, which is kept for
//     Settings::keep and said again to whoever asks; a restart takes up what was not finished;
//   * two requests of one id and content are one request; of another content, the second is
//     refused;
//   * requests are begun by priority, then in the order in which they came;
//   * what it holds is bounded: beyond that, requests are refused with a reason.
//
// Not thread safe: one loop owns it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <tuple>
#include <variant>
#include <vector>

#include "common/io/request_scene.h"
#include "common/transport/fleet/fleet_messages.h"
#include "coordinator/journal/journal.h"
#include "coordinator/planner.h"
#include "coordinator/service/desk_counters.h"
#include "coordinator/service/request_record.h"

namespace accord {

class RequestDesk {
 public:
  struct Settings {
    std::size_t queued = 1000;                                 // requests that wait, at most
    std::size_t queued_bytes = std::size_t{512} << 20;         // of what they brought, at most
    std::size_t planning = 1;                                  // requests planned at a time
    std::size_t waypoints = 10'000'000;                        // of a plan, at most
    unsigned threads = 1;                                      // of a proof
    double keep = 86400;                                       // s, that finished plans are kept
    bool outlives = true;                                      // the journal, this process
    std::chrono::nanoseconds retry = std::chrono::seconds(1);  // of a write that has failed
  };
  struct Now {
    std::chrono::nanoseconds steady{0};  // since a beginning of the caller's choice; never back
    double wall = 0;                     // s since 1970
  };

  explicit RequestDesk(const Settings& settings) : settings_(settings) {}

  // What the journal holds, before anything else comes in. `record` is an unfinished request's, or
  // why it cannot be had; of a finished one it is not looked at. In the order of acceptance.
  void restore(const JournalEntry& entry, tl::expected<RequestRecord, std::string> record, Now now);

  // ---- What comes in ----

  void on_request(FleetRequest request, Now now);
  // What became of Read.
  void on_read(const PlanRequest& request, tl::expected<ReadyRequest, RequestFault> ready, Now now);
  void on_progress(const std::string& id, const Progress& progress, Now now);
  // What became of Begin. json: the plan as a plan file.
  void on_planned(const std::string& id, Plan plan, std::string json, Now now);
  // What became of Accept and Finish. fault: why they are not in the journal; empty: they are.
  void on_accepted(const std::vector<std::string>& ids, const std::string& fault, Now now);
  void on_stored(const std::vector<std::string>& ids, const std::string& fault, Now now);
  // What became of Recall: the plan, or why it cannot be had.
  void on_recalled(const std::string& id, tl::expected<Plan, std::string> plan);
  // Forget has failed: it is asked for again, later.
  void on_not_forgotten();
  // At the end of each turn: hands what has gathered to the journal, all of it at once; begins what
  // can be begun.
  void settle(Now now);

  // From now on nothing is accepted or begun. What is under way is stopped; it stays in the journal
  // where that outlives the process, else it ends as cancelled. Nobody waits for a disk to have
  // room again: plans that cannot be written are left to be made anew.
  void drain(Now now);
  // Drained, and nothing is under way.
  bool is_done() const;

  // ---- What is to be done ----

  struct Read {  // read what it brings, and check it
    PlanRequest request;
  };
  struct Accept {  // write them into the journal
    std::vector<AcceptedRequest> requests;
  };
  struct Begin {  // plan it
    std::string id;
    std::shared_ptr<const Scene> scene;
    PlanOptions options;
    SceneHash content;  // of what was asked
  };
  struct Stop {  // plan it no more
    std::string id;
  };
  struct Finish {  // write them into the journal
    std::vector<FinishedRequest> requests;
  };
  struct Recall {  // have its plan from the journal
    std::string id;
  };
  struct Forget {  // what finished before that, s since 1970
    double before;
  };
  struct Publish {
    FleetNews news;
  };
  using Action = std::variant<Read, Accept, Begin, Stop, Finish, Recall, Forget, Publish>;
  std::optional<Action> next_action();
  // When settle() has something to do, if nothing happens until then.
  std::optional<std::chrono::nanoseconds> next_deadline() const;

  using Counters = DeskCounters;
  const Counters& counters() const { return counters_; }
  // What it has in hand.
  struct Load {
    std::size_t reading = 0;  // requests that are read and checked, or not in the journal yet
    std::size_t queued = 0;
    std::size_t planning = 0;
    std::size_t unwritten = 0;           // finished, but not in the journal as that
    std::chrono::nanoseconds oldest{0};  // of those queued: since its acceptance
    std::size_t kept = 0;                // finished plans in the journal
    std::size_t bytes = 0;               // of what the requests in memory have brought
    bool takes_writes = true;            // the journal, as far as its last write tells
  };
  Load load(Now now) const;
  std::size_t queued() const { return queue_.size(); }
  std::size_t planning() const { return planning_; }
  bool is_draining() const { return draining_; }

 private:
  enum class Stage { kRead, kQueued, kPlanning, kFinished };
  struct Request {
    Stage stage = Stage::kRead;
    bool is_accepted = false;   // in the journal, and answered
    bool is_cancelled = false;  // by who asked
    bool is_refused = false;    // the journal has not taken it
    SceneHash content;
    std::size_t bytes = 0;
    std::shared_ptr<const Scene> scene;
    PlanOptions options;
    double deadline = 0;  // s; 0: none
    std::int32_t priority = 0;
    std::uint64_t order = 0;
    double accepted = 0;                // wall clock
    std::chrono::nanoseconds since{0};  // the same by the steady clock
    std::chrono::nanoseconds begun{0};  // when its planning was begun
    RequestState state;
    Plan plan;  // once finished
    std::string json;
    bool is_told = false;  // how it has ended
  };
  struct Kept {  // in the journal
    SceneHash content;
    double elapsed = 0;   // s, until it was finished
    double finished = 0;  // wall clock
  };
  using Requests = std::map<std::string, Request>;
  using Place = std::tuple<std::int64_t, std::uint64_t, std::string>;  // -priority, order, id

  void submit(PlanRequest request, Now now);
  std::optional<RequestReply> refusal(const PlanRequest& request, std::size_t bytes) const;
  void cancel(const std::string& id, Now now);
  void resend(const std::string& id, Now now);
  void reply_again(const std::string& id, Request& request, Now now);
  void reject(const std::string& id, Rejection reason, std::string field, std::string text);
  void set_options(const PlanRequest& request, Request& entry) const;
  void enqueue(const std::string& id, Request& request);
  Place place_of(const std::string& id, const Request& request) const;
  void begin_next(Now now);
  void end(const std::string& id, Request& request, PlanStatus status, std::string message,
           Now now);
  void finish(const std::string& id, Request& request, Now now);
  static void note_end(const Plan& plan, RequestState& state);
  void count_progress(const RequestState& before, const RequestState& after);
  void count_planned(const Plan& plan, const Request& request, Now now);
  void count_write(const std::string& fault);
  void tell(const std::string& id, Request& request, Now now);
  void drop(Requests::iterator request);
  RequestState state_after(const std::string& id, const Plan& plan) const;
  void say_state(const std::string& id, Request& request, Now now);
  void forget_old(Now now);
  void publish(FleetNews news) { actions_.emplace_back(Publish{std::move(news)}); }

  Settings settings_;
  Counters counters_;
  Requests requests_;                 // that are not in the journal as finished
  std::map<std::string, Kept> kept_;  // that are
  std::set<Place> queue_;
  std::vector<AcceptedRequest> to_accept_;
  std::vector<std::string> to_finish_;
  std::size_t planning_ = 0;
  std::size_t bytes_ = 0;  // of all requests
  std::uint64_t next_order_ = 0;
  std::vector<std::string> to_finish_again_;
  std::optional<std::chrono::nanoseconds> retry_at_, forget_at_;
  bool takes_writes_ = true;    // the journal has taken the last one
  bool is_forgetting_ = false;  // the journal still holds what is to be forgotten
  bool draining_ = false;
  std::deque<Action> actions_;
};

}  // namespace accord
