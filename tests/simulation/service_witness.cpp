#include "tests/simulation/service_witness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <variant>

#include "common/io/plan_file.h"
#include "common/io/wire/request_codec.h"

namespace accord::testing {

using ::testing::HasSubstr;

void ServiceWitness::expect(const PlanRequest& request, std::string plan) {
  plans_[request_hash(request)] = std::move(plan);
}

void ServiceWitness::on_begun() {
  in_use_.reset();
  under_way_.clear();
  to_cancel_.clear();
  const auto unfinished = journal_.unfinished();
  for (const JournalEntry& entry : *unfinished) under_way_.insert(entry.id);
}

void ServiceWitness::on_taken(const FleetRequest& request) {
  EXPECT_FALSE(in_use_) << *in_use_ << ": other content under its id was not refused";
  in_use_.reset();
  if (const auto* cancel = std::get_if<CancelRequest>(&request)) {
    asked_to_cancel_.insert(cancel->id);
    if (under_way_.contains(cancel->id)) to_cancel_.insert(cancel->id);
  } else if (const auto* plan = std::get_if<PlanRequest>(&request)) {
    const auto entry = entry_of(plan->id);
    if (entry && entry->content != request_hash(*plan)) in_use_ = plan->id;
  }
}

void ServiceWitness::on_said(const FleetNews& news) {
  if (const auto* reply = std::get_if<RequestReply>(&news)) {
    on_reply(*reply);
  } else if (const auto* state = std::get_if<RequestState>(&news)) {
    EXPECT_TRUE(entry_of(state->id)) << state->id << " was spoken of before it was written";
  } else if (const auto* finished = std::get_if<FinishedPlan>(&news)) {
    check_outcome(finished->id, finished->plan);
    const bool is_plan = finished->plan.status == PlanStatus::kSolved;
    under_way_.erase(finished->id);
    EXPECT_FALSE(is_plan && to_cancel_.contains(finished->id)) << finished->id << " went on";
    const Ending ending{is_plan, canonical_bytes(finished->plan)};
    const auto [said, is_first] = endings_.emplace(finished->id, ending);
    if (is_first || said->second == ending) return;
    // A plan that was said before it was written may yet be cancelled, after a crash.
    EXPECT_TRUE((said->second.is_plan && !is_plan) || unwritten_.contains(finished->id))
        << finished->id << " ended twice, differently";
    said->second = ending;
  }
}

void ServiceWitness::on_reply(const RequestReply& reply) {
  if (in_use_ == reply.id) {
    EXPECT_EQ(reply.reason, Rejection::kIdInUse) << reply.id << ": " << reply.text;
    in_use_.reset();
  }
  if (!reply.accepted) {
    on_refusal(reply);
    return;
  }
  EXPECT_EQ(reply.reason, Rejection::kNone);
  if (!endings_.contains(reply.id)) under_way_.insert(reply.id);
  EXPECT_TRUE(entry_of(reply.id)) << reply.id << " was accepted before it was written";
}

void ServiceWitness::on_refusal(const RequestReply& reply) {
  ++refusals_[reply.reason];
  EXPECT_FALSE(reply.text.empty()) << reply.id << " was refused without a word";
  switch (reply.reason) {
    case Rejection::kIdInUse:
      return;
    case Rejection::kNoJournal:
      check_fault(reply.text);
      break;
    case Rejection::kBadScene:
    case Rejection::kQueueFull:
    case Rejection::kShuttingDown:
    case Rejection::kUnknownRequest:
      break;
    default:
      ADD_FAILURE() << reply.id << " was refused for no reason: " << reply.text;
  }
  EXPECT_FALSE(entry_of(reply.id)) << reply.id << " was accepted, then refused: " << reply.text;
}

// Of an accepted request: that it ended so is as it should be.
void ServiceWitness::check_outcome(const std::string& id, const Plan& plan) {
  const auto entry = entry_of(id);
  ASSERT_TRUE(entry) << id << " has ended before it was accepted";
  if (plan.status == PlanStatus::kSolved) {
    EXPECT_TRUE(canonical_bytes(plan) == plans_.at(entry->content))
        << id << " has another plan than in one process";
    return;
  }
  ASSERT_EQ(plan.status, PlanStatus::kCancelled) << id << ": " << plan.message;
  if (plan.message.starts_with("given up: ")) {
    given_up_.insert(id);
  } else {
    EXPECT_TRUE(asked_to_cancel_.contains(id)) << id << " was cancelled, but not by who asked";
    cancelled_.insert(id);
  }
  // Planned anew after a crash, it would end otherwise.
  EXPECT_TRUE(entry->outcome || unwritten_.contains(id))
      << id << " was said to have ended, and that was not written: " << plan.message;
}

void ServiceWitness::on_written(const RequestDesk::Accept& work, const std::string& fault) {
  check_fault(fault);
  if (!fault.empty()) return;
  for (const AcceptedRequest& request : work.requests) {
    EXPECT_EQ(++accepts_[request.id], 1U) << request.id << " was accepted again";
  }
}

void ServiceWitness::on_written(const RequestDesk::Finish& work, const std::string& fault) {
  check_fault(fault);
  if (fault.empty()) return;
  for (const FinishedRequest& request : work.requests) unwritten_.insert(request.id);
}

// The journal refuses nothing but what it was ordered to.
void ServiceWitness::check_fault(const std::string& fault) const {
  if (fault.empty()) return;
  EXPECT_THAT(fault, HasSubstr("a fault that was ordered"));
}

void ServiceWitness::check_kept(const std::string& id, const std::string& heard) {
  const auto entry = entry_of(id);
  ASSERT_TRUE(entry && entry->outcome) << id << " was lost";
  const auto json = journal_.plan(id);
  ASSERT_TRUE(json) << json.error();
  const PlanResult kept = parse_plan(*json, id);
  ASSERT_TRUE(kept.plan) << to_string(kept.faults.front());
  EXPECT_EQ(kept.plan->status, entry->outcome->status);
  check_outcome(id, *kept.plan);
  if (kept.plan->status != PlanStatus::kSolved || unwritten_.contains(id)) return;
  EXPECT_TRUE(canonical_bytes(*kept.plan) == heard) << id << ": not what is kept was heard";
}

}  // namespace accord::testing
