#include "coordinator/service/request_desk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/io/plan_file.h"
#include "coordinator/journal/memory_journal.h"
#include "tests/support/scenes.h"

namespace accord {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::shared_ptr<const Scene> a_scene() {
  return testing::SceneBuilder(-5, -5, 5, 5).disk(0.3, {-4, 0}, {4, 0}).build();
}

PlanRequest request_of(const std::string& id) {
  PlanRequest request;
  request.id = id;
  request.scene_text = "the scene of " + id;
  return request;
}

Plan solved_plan() {
  Plan plan;
  plan.scene = "test";
  plan.status = PlanStatus::kSolved;
  plan.makespan = plan.sum_of_costs = 8;
  RobotPlan robot;
  robot.name = "r0";
  robot.trajectory = testing::path({{0, {-4, 0}}, {8, {4, 0}}});
  robot.segments = {{0, 8, {"r0"}, "prm"}};
  plan.robots = {robot};
  return plan;
}

// A desk whose actions are carried out at once: requests are read as a_scene(), planning waits for
// the test.
class RequestDeskTest : public ::testing::Test {
 protected:
  void open(RequestDesk::Settings settings = {}) {
    desk_ = std::make_unique<RequestDesk>(settings);
    const auto entries = journal_.entries();
    for (const JournalEntry& entry : *entries) {
      tl::expected<RequestRecord, std::string> record;
      if (!entry.outcome) record = decode_record(*journal_.record(entry.id));
      desk_->restore(entry, std::move(record), now_);
    }
    settle();
  }

  void submit(const PlanRequest& request) {
    desk_->on_request(request, now_);
    settle();
  }
  void submit(const std::string& id) { submit(request_of(id)); }
  void ask_again(const std::string& id) {
    desk_->on_request(ResendRequest{id}, now_);
    settle();
  }
  void cancel(const std::string& id) {
    desk_->on_request(CancelRequest{id}, now_);
    settle();
  }
  void finish(const std::string& id, const Plan& plan = solved_plan()) {
    desk_->on_planned(id, plan, to_json(plan), now_);
    settle();
  }
  void pass(std::chrono::milliseconds time) {
    now_.steady += time;
    now_.wall += std::chrono::duration<double>(time).count();
    settle();
  }

  void settle() {
    do {
      carry_out();
      desk_->settle(now_);
      carry_out();
    } while (!disk_is_slow_ && write());
  }
  // Carries out what waits for the disk; false: nothing does.
  bool write() {
    const auto waiting = std::exchange(writes_, {});
    for (const auto& work : waiting) {
      std::vector<std::string> ids;
      if (const auto* accept = std::get_if<RequestDesk::Accept>(&work)) {
        for (const AcceptedRequest& request : accept->requests) ids.push_back(request.id);
        const auto written = journal_.accept(accept->requests);
        desk_->on_accepted(ids, written ? "" : written.error(), now_);
      } else {
        const auto& finish = std::get<RequestDesk::Finish>(work);
        for (const FinishedRequest& request : finish.requests) ids.push_back(request.id);
        const auto written = journal_.finish(finish.requests);
        desk_->on_stored(ids, written ? "" : written.error(), now_);
      }
    }
    return !waiting.empty();
  }
  void carry_out() {
    while (auto action = desk_->next_action()) {
      if (auto* read = std::get_if<RequestDesk::Read>(&*action)) {
        if (fault_) {
          desk_->on_read(read->request, tl::unexpected(*fault_), now_);
        } else {
          const Bytes record = encode_record(read->request, *a_scene());
          desk_->on_read(read->request, ReadyRequest{a_scene(), record}, now_);
        }
      } else if (auto* accept = std::get_if<RequestDesk::Accept>(&*action)) {
        writes_.emplace_back(std::move(*accept));
      } else if (auto* begin = std::get_if<RequestDesk::Begin>(&*action)) {
        begun_.push_back(begin->id);
        timeout_ = begin->options.timeout;
      } else if (auto* stop = std::get_if<RequestDesk::Stop>(&*action)) {
        stopped_.push_back(stop->id);
      } else if (auto* finish = std::get_if<RequestDesk::Finish>(&*action)) {
        writes_.emplace_back(std::move(*finish));
      } else if (auto* recall = std::get_if<RequestDesk::Recall>(&*action)) {
        const auto json = journal_.plan(recall->id);
        ASSERT_TRUE(json) << json.error();
        desk_->on_recalled(recall->id, *parse_plan(*json, recall->id).plan);
      } else if (auto* forget = std::get_if<RequestDesk::Forget>(&*action)) {
        if (!journal_.forget_finished_before(forget->before, 100)) desk_->on_not_forgotten();
      } else {
        FleetNews& news = std::get<RequestDesk::Publish>(*action).news;
        if (const auto* reply = std::get_if<RequestReply>(&news)) replies_.push_back(*reply);
        if (const auto* state = std::get_if<RequestState>(&news)) states_.push_back(*state);
        if (const auto* plan = std::get_if<FinishedPlan>(&news)) plans_.push_back(*plan);
      }
    }
  }

  MemoryJournal journal_;
  std::unique_ptr<RequestDesk> desk_;
  RequestDesk::Now now_{std::chrono::seconds(100), 1e9};
  std::optional<RequestFault> fault_;
  bool disk_is_slow_ = false;  // the test calls write()
  std::vector<std::variant<RequestDesk::Accept, RequestDesk::Finish>> writes_;
  std::vector<std::string> begun_, stopped_;
  std::optional<double> timeout_;
  std::vector<RequestReply> replies_;
  std::vector<RequestState> states_;
  std::vector<FinishedPlan> plans_;
};

TEST_F(RequestDeskTest, TakesARequestFromItsSubmissionToItsPlan) {
  open();
  submit("a");
  ASSERT_THAT(replies_, SizeIs(1));
  EXPECT_TRUE(replies_[0].accepted);
  EXPECT_THAT(begun_, ElementsAre("a"));
  desk_->on_progress("a", {Progress::Phase::kConflicts, 1, 4, 2, 1}, now_);
  finish("a");
  std::vector<RequestPhase> phases;
  for (const RequestState& state : states_) phases.push_back(state.phase);
  EXPECT_THAT(phases, ElementsAre(RequestPhase::kQueued, RequestPhase::kConflicts,
                                  RequestPhase::kFinished));
  EXPECT_EQ(states_[1].conflicts_found, 4U);
  ASSERT_THAT(plans_, SizeIs(1));
  EXPECT_EQ(to_json(plans_[0].plan), to_json(solved_plan()));
  EXPECT_EQ(desk_->planning(), 0U);
}

TEST_F(RequestDeskTest, SaysHowMuchIsDoneAndNeverLessThanBefore) {
  open();
  submit("a");
  EXPECT_EQ(states_.back().per_cent, 0);
  EXPECT_EQ(states_.back().best_cost, 0) << "there are no paths yet";
  // In the second round resolutions bring more conflicts than they end.
  constexpr auto kConflicts = Progress::Phase::kConflicts;
  for (const Progress& progress :
       {Progress{kConflicts, 1, 4, 0, 0, 4, 10}, Progress{kConflicts, 1, 4, 2, 1, 2, 11},
        Progress{kConflicts, 1, 16, 3, 2, 12, 12},
        Progress{Progress::Phase::kProof, 1, 16, 9, 3, 0, 12}}) {
    desk_->on_progress("a", progress, now_);
    settle();
  }
  pass(std::chrono::seconds(2));
  finish("a");
  std::vector<double> per_cent, costs;
  for (const RequestState& state : states_) {
    per_cent.push_back(state.per_cent);
    costs.push_back(state.best_cost);
  }
  EXPECT_THAT(per_cent, ElementsAre(0, 10, 52.5, 52.5, 95, 100));
  EXPECT_THAT(costs, ElementsAre(0, 10, 11, 12, 12, 8));
  EXPECT_EQ(states_.back().elapsed, 2);
}

TEST_F(RequestDeskTest, SaysTheSameOfAFinishedRequestWheneverItIsAsked) {
  open();
  submit("a");
  Plan plan = solved_plan();
  plan.statistics = {{"conflicts_found", 16}, {"conflicts_resolved", 9}, {"rounds", 3}};
  desk_->on_progress("a", {Progress::Phase::kProof, 1, 16, 9, 3, 0, 12}, now_);
  pass(std::chrono::seconds(2));
  finish("a", plan);
  const RequestState said = states_.back();
  pass(std::chrono::seconds(3));
  ask_again("a");
  EXPECT_EQ(states_.back(), said);
}

TEST_F(RequestDeskTest, SaysWithAPlanWhatItWasAskedFor) {
  open();
  submit("a");
  finish("a");
  const std::string content = plans_.back().content;
  EXPECT_EQ(content.size(), 64U);
  ask_again("a");
  EXPECT_EQ(plans_.back().content, content) << "from the journal";
}

// A quick request ends before anybody has told how its last rounds went.
TEST_F(RequestDeskTest, SaysOfAFinishedRequestWhatItsPlanCounted) {
  open();
  submit("a");
  Plan plan = solved_plan();
  plan.statistics = {{"conflicts_found", 16}, {"conflicts_resolved", 9}, {"rounds", 3}};
  desk_->on_progress("a", {Progress::Phase::kConflicts, 1, 12, 0, 0, 0, 12}, now_);
  finish("a", plan);
  EXPECT_EQ(states_.back().conflicts_found, 16U);
  EXPECT_EQ(states_.back().conflicts_resolved, 9U);
  EXPECT_EQ(states_.back().rounds, 3U);
}

TEST_F(RequestDeskTest, HasARequestInTheJournalBeforeItSaysSo) {
  open();
  disk_is_slow_ = true;
  submit("a");
  EXPECT_THAT(begun_, ElementsAre("a")) << "planning need not wait";
  desk_->on_progress("a", {Progress::Phase::kConflicts, 1, 4, 2, 1}, now_);
  finish("a");
  EXPECT_THAT(replies_, IsEmpty());
  EXPECT_THAT(states_, IsEmpty());
  EXPECT_THAT(plans_, IsEmpty());
  write();
  settle();
  EXPECT_THAT(replies_, SizeIs(1));
  EXPECT_THAT(plans_, SizeIs(1));
}

TEST_F(RequestDeskTest, RefusesARequestThatTheJournalDoesNotTake) {
  open();
  journal_.fail_next_writes(1);
  submit("a");
  ASSERT_THAT(replies_, SizeIs(1));
  EXPECT_FALSE(replies_[0].accepted);
  EXPECT_EQ(replies_[0].reason, Rejection::kNoJournal);
  EXPECT_THAT(stopped_, ElementsAre("a"));
  finish("a");
  EXPECT_THAT(plans_, IsEmpty());
  submit("a");
  EXPECT_TRUE(replies_.back().accepted) << "there is room again";
}

TEST_F(RequestDeskTest, WritesTogetherWhatComesTogether) {
  open();
  disk_is_slow_ = true;
  for (const char* id : {"a", "b", "c"}) desk_->on_request(request_of(id), now_);
  settle();
  ASSERT_THAT(writes_, SizeIs(1));
  EXPECT_THAT(std::get<RequestDesk::Accept>(writes_[0]).requests, SizeIs(3));
}

TEST_F(RequestDeskTest, HandsOutAPlanThatTheJournalDoesNotTakeAndKeepsIt) {
  open();
  submit("a");
  journal_.fail_next_writes(2);
  finish("a");
  EXPECT_THAT(plans_, SizeIs(1));
  EXPECT_FALSE((*journal_.find("a"))->outcome);
  ask_again("a");
  EXPECT_THAT(plans_, SizeIs(2));
  pass(std::chrono::milliseconds(1500));  // fails again
  pass(std::chrono::milliseconds(1500));
  EXPECT_TRUE((*journal_.find("a"))->outcome);
  ask_again("a");
  EXPECT_THAT(plans_, SizeIs(3));
}

TEST_F(RequestDeskTest, SaysWhatIsWrongWithARequest) {
  open();
  fault_ = RequestFault{Rejection::kBadScene, "robots[0].goal", "it is taken"};
  submit("a");
  ASSERT_THAT(replies_, SizeIs(1));
  EXPECT_EQ(replies_[0].reason, Rejection::kBadScene);
  EXPECT_EQ(replies_[0].field, "robots[0].goal");
  EXPECT_EQ(replies_[0].text, "it is taken");
  EXPECT_EQ(desk_->planning(), 0U);
  fault_.reset();
  submit("");
  EXPECT_EQ(replies_.back().reason, Rejection::kBadId);
}

TEST_F(RequestDeskTest, TakesTheSameRequestTwiceAsOne) {
  open();
  submit("a");
  submit("a");
  EXPECT_THAT(begun_, ElementsAre("a"));
  EXPECT_THAT(replies_, SizeIs(2)) << "the second may be asked since the first reply got lost";
  finish("a");
  submit("a");
  EXPECT_THAT(begun_, ElementsAre("a"));
  EXPECT_THAT(plans_, SizeIs(2)) << "its plan is there already";
}

TEST_F(RequestDeskTest, RefusesOtherContentUnderAnIdThatIsInUse) {
  open();
  submit("a");
  PlanRequest other = request_of("a");
  other.seed = 2;
  submit(other);
  EXPECT_EQ(replies_.back().reason, Rejection::kIdInUse);
  finish("a");
  submit(other);
  EXPECT_EQ(replies_.back().reason, Rejection::kIdInUse);
}

TEST_F(RequestDeskTest, BeginsByPriorityThenInOrder) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("first");
  submit("b");
  submit("c");
  PlanRequest urgent = request_of("urgent");
  urgent.priority = 5;
  submit(urgent);
  EXPECT_EQ(states_.back().ahead, 0U);
  ask_again("c");
  EXPECT_EQ(states_.back().ahead, 2U);
  finish("first");
  finish("urgent");
  finish("b");
  EXPECT_THAT(begun_, ElementsAre("first", "urgent", "b", "c"));
}

TEST_F(RequestDeskTest, RefusesMoreThanItHolds) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  settings.queued = 2;
  open(settings);
  for (const char* id : {"a", "b", "c", "d"}) submit(id);
  EXPECT_EQ(replies_.back().reason, Rejection::kQueueFull);
  finish("a");
  submit("d");
  EXPECT_TRUE(replies_.back().accepted);

  settings.queued_bytes = 20;
  open(settings);
  submit("x");
  EXPECT_EQ(replies_.back().reason, Rejection::kQueueFull);
}

TEST_F(RequestDeskTest, CancelsARequestThatWaits) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("a");
  submit("b");
  cancel("b");
  ASSERT_THAT(plans_, SizeIs(1));
  EXPECT_EQ(plans_[0].id, "b");
  EXPECT_EQ(plans_[0].plan.status, PlanStatus::kCancelled);
  finish("a");
  EXPECT_THAT(begun_, ElementsAre("a"));
  EXPECT_EQ((*journal_.find("b"))->outcome->status, PlanStatus::kCancelled);
}

TEST_F(RequestDeskTest, StopsARequestThatIsBeingPlanned) {
  open();
  submit("a");
  cancel("a");
  EXPECT_THAT(stopped_, ElementsAre("a"));
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("a", cancelled);
  EXPECT_EQ(plans_.back().plan.status, PlanStatus::kCancelled);
  EXPECT_EQ(desk_->planning(), 0U);
  cancel("nobody");
  EXPECT_EQ(replies_.back().reason, Rejection::kUnknownRequest);
}

// Else a crash in between would have it planned after all.
TEST_F(RequestDeskTest, SaysThatARequestIsCancelledOnceThatIsWritten) {
  open();
  submit("a");
  disk_is_slow_ = true;
  cancel("a");
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("a", cancelled);
  ask_again("a");
  EXPECT_THAT(plans_, IsEmpty());
  EXPECT_NE(states_.back().phase, RequestPhase::kFinished);
  write();
  settle();
  ASSERT_THAT(plans_, SizeIs(1));
  EXPECT_EQ(states_.back().phase, RequestPhase::kFinished);
  EXPECT_EQ((*journal_.find("a"))->outcome->status, PlanStatus::kCancelled);
}

TEST_F(RequestDeskTest, SaysThatARequestIsCancelledWhereThatCannotBeWritten) {
  open();
  submit("a");
  submit("b");
  journal_.fail_next_writes(1);
  cancel("b");
  ASSERT_THAT(plans_, SizeIs(1));
  pass(std::chrono::milliseconds(1500));
  EXPECT_THAT(plans_, SizeIs(1)) << "it was said already";
  EXPECT_TRUE((*journal_.find("b"))->outcome);
}

TEST_F(RequestDeskTest, CountsADeadlineFromItsAcceptance) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("a");
  PlanRequest soon = request_of("soon"), later = request_of("later");
  soon.deadline = 1;
  later.deadline = 10;
  submit(soon);
  submit(later);
  pass(std::chrono::seconds(4));
  finish("a");
  EXPECT_EQ(plans_.back().id, "soon");
  EXPECT_EQ(plans_.back().plan.status, PlanStatus::kTimeout);
  EXPECT_THAT(begun_, ElementsAre("a", "later"));
  EXPECT_NEAR(*timeout_, 6, 1e-6);
}

TEST_F(RequestDeskTest, TakesUpWhatTheJournalHoldsAfterARestart) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("a");
  submit("b");
  submit("done");
  cancel("done");
  begun_.clear();
  states_.clear();
  open(settings);  // as after a crash
  EXPECT_EQ(desk_->counters().restored, 2U);
  EXPECT_THAT(states_, ::testing::Contains(::testing::Field(&RequestState::id, "b")))
      << "though it waits";
  EXPECT_THAT(begun_, ElementsAre("a"));
  finish("a");
  finish("b");
  EXPECT_THAT(begun_, ElementsAre("a", "b"));
  EXPECT_EQ(plans_.back().plan.status, PlanStatus::kSolved);
  EXPECT_EQ(desk_->planning(), 0U);
}

TEST_F(RequestDeskTest, LeavesWhatItDoesNotFinishForTheNextOneWhenItIsDrained) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("a");
  submit("b");
  desk_->drain(now_);
  settle();
  EXPECT_THAT(stopped_, ElementsAre("a"));
  EXPECT_FALSE(desk_->is_done());
  submit("c");
  EXPECT_EQ(replies_.back().reason, Rejection::kShuttingDown);
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("a", cancelled);
  EXPECT_THAT(plans_, IsEmpty());
  EXPECT_TRUE(desk_->is_done());
  EXPECT_EQ(journal_.unfinished()->size(), 2U);
}

// Who was told "unknown" would submit it again, and be told that nothing is accepted any more.
TEST_F(RequestDeskTest, StillKnowsWhatItLeavesForTheNextOne) {
  open();
  submit("a");
  desk_->drain(now_);
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("a", cancelled);
  EXPECT_TRUE(desk_->is_done());
  begun_.clear();
  ask_again("a");
  EXPECT_TRUE(replies_.back().accepted);
  EXPECT_EQ(states_.back().phase, RequestPhase::kQueued);
  EXPECT_THAT(begun_, IsEmpty());
}

TEST_F(RequestDeskTest, DoesNotWaitForAFullDiskWhenItIsDrained) {
  open();
  submit("a");
  submit("b");
  journal_.fail_next_writes(100);
  finish("a");
  desk_->drain(now_);
  settle();
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("b", cancelled);
  EXPECT_TRUE(desk_->is_done());
  EXPECT_EQ(journal_.unfinished()->size(), 2U);
  ask_again("a");
  EXPECT_TRUE(replies_.back().accepted);
  EXPECT_EQ(plans_.back().id, "a") << "it is there for whoever asks meanwhile";
}

TEST_F(RequestDeskTest, WritesWhatTheDiskHadNoRoomForBeforeItEnds) {
  open();
  submit("a");
  journal_.fail_next_writes(1);
  finish("a");
  desk_->drain(now_);
  settle();
  EXPECT_TRUE(desk_->is_done());
  EXPECT_TRUE((*journal_.find("a"))->outcome);
}

// It would be accepted, and neither planned nor ended where nothing outlives the process.
TEST_F(RequestDeskTest, RefusesWhatWasBeingReadWhenItIsDrained) {
  RequestDesk::Settings settings;
  settings.outlives = false;
  open(settings);
  desk_->on_request(request_of("a"), now_);
  desk_->drain(now_);
  settle();
  ASSERT_THAT(replies_, SizeIs(1));
  EXPECT_EQ(replies_[0].reason, Rejection::kShuttingDown);
  EXPECT_TRUE(desk_->is_done());
}

TEST_F(RequestDeskTest, EndsEverythingWhenItIsDrainedAndTheJournalDoesNotOutliveIt) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  settings.outlives = false;
  open(settings);
  submit("a");
  submit("b");
  desk_->drain(now_);
  settle();
  Plan cancelled;
  cancelled.status = PlanStatus::kCancelled;
  finish("a", cancelled);
  EXPECT_THAT(plans_, SizeIs(2));
  EXPECT_TRUE(desk_->is_done());
}

TEST_F(RequestDeskTest, ForgetsPlansThatWereKeptLongEnough) {
  RequestDesk::Settings settings;
  settings.keep = 60;
  open(settings);
  submit("a");
  finish("a");
  pass(std::chrono::seconds(50));
  EXPECT_TRUE(*journal_.find("a"));
  pass(std::chrono::seconds(20));
  EXPECT_FALSE(*journal_.find("a"));
  ask_again("a");
  EXPECT_EQ(replies_.back().reason, Rejection::kUnknownRequest);
}

// Else its id could not be used again before a restart.
TEST_F(RequestDeskTest, ForgetsPlansOnceTheDiskTakesIt) {
  RequestDesk::Settings settings;
  settings.keep = 60;
  open(settings);
  submit("a");
  finish("a");
  journal_.fail_next_writes(2);
  pass(std::chrono::seconds(70));
  EXPECT_TRUE(*journal_.find("a"));
  pass(std::chrono::seconds(1));
  EXPECT_TRUE(*journal_.find("a"));
  pass(std::chrono::seconds(1));
  EXPECT_FALSE(*journal_.find("a"));
  submit("a");
  EXPECT_TRUE(replies_.back().accepted);
}

TEST_F(RequestDeskTest, HandsOutNoPlanThatIsTooLarge) {
  RequestDesk::Settings settings;
  settings.waypoints = 1;
  open(settings);
  submit("a");
  finish("a");
  EXPECT_EQ(plans_.back().plan.status, PlanStatus::kInvalid);
  EXPECT_THAT(plans_.back().plan.message, HasSubstr("2 waypoints"));
}

TEST_F(RequestDeskTest, MeasuresQueueAndPlanningAndWhatPlansTellOfTheirs) {
  RequestDesk::Settings settings;
  settings.planning = 1;
  open(settings);
  submit("a");
  submit("b");
  pass(std::chrono::seconds(2));
  EXPECT_EQ(desk_->load(now_).queued, 1U);
  EXPECT_EQ(desk_->load(now_).planning, 1U);
  EXPECT_EQ(desk_->load(now_).oldest, std::chrono::seconds(2));
  desk_->on_progress("a", {Progress::Phase::kConflicts, 1, 5, 1, 1}, now_);
  EXPECT_EQ(desk_->counters().conflicts_found, 5U) << "as it comes, not at the end";

  Plan plan = solved_plan();
  plan.statistics = {
      {"conflicts_found", 9},  {"conflicts_resolved", 3},    {"rounds", 2},
      {"subproblems", 7},      {"subproblems_exhausted", 2}, {"solved_by_prioritized-query", 2},
      {"solved_by_nobody", 1}, {"proof_time", 0.5}};
  finish("a", plan);
  const DeskCounters& counters = desk_->counters();
  EXPECT_EQ(counters.conflicts_found, 9U);
  EXPECT_EQ(counters.conflicts_resolved, 3U);
  EXPECT_EQ(counters.rounds, 2U);
  EXPECT_EQ(counters.subproblems_exhausted, 2U);
  EXPECT_EQ(counters.subproblems_set_aside, 2U);
  EXPECT_EQ(counters.resolutions,
            (std::map<std::string, std::uint64_t>{{"other", 1}, {"prioritized-query", 2}}));
  EXPECT_EQ(counters.planning.at(PlanStatus::kSolved).sum, 2);
  EXPECT_EQ(counters.proof.sum, 0.5);
  EXPECT_EQ(counters.queued.total(), 2U) << "the other one has been begun";
  EXPECT_EQ(counters.queued.sum, 2);
}

TEST_F(RequestDeskTest, KnowsWhetherTheJournalTakesWrites) {
  open();
  EXPECT_TRUE(desk_->load(now_).takes_writes);
  journal_.fail_next_writes(1);
  submit("a");
  EXPECT_FALSE(desk_->load(now_).takes_writes);
  EXPECT_EQ(desk_->counters().failed_writes, 1U);
  EXPECT_EQ(desk_->counters().rejected.at(Rejection::kNoJournal), 1U);
  submit("b");
  EXPECT_TRUE(desk_->load(now_).takes_writes);
  EXPECT_EQ(desk_->counters().writes, 1U);
}

}  // namespace
}  // namespace accord
