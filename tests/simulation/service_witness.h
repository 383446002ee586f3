// Looks on as a service that suffers takes requests and speaks of them, and knows what must hold of
// every word: what it has said it must have written, and all it says of one request, over all of
// its lives, must agree.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "common/io/wire/scene_hash.h"
#include "common/transport/fleet/fleet_messages.h"
#include "coordinator/journal/journal.h"
#include "coordinator/service/request_desk.h"

namespace accord::testing {

// What is wrong is a test's failure.
class ServiceWitness {
 public:
  // The journal must outlive this.
  explicit ServiceWitness(const Journal& journal) : journal_(journal) {}

  // Somebody may send this request; planned, it has a plan of these canonical bytes.
  void expect(const PlanRequest& request, std::string plan);

  void on_taken(const FleetRequest& request);
  void on_said(const FleetNews& news);
  void on_written(const RequestDesk::Accept& work, const std::string& fault);
  void on_written(const RequestDesk::Finish& work, const std::string& fault);

  // A coordinator has taken up what the journal holds.
  void on_begun();

  // In the end: what is kept of a request that was accepted, and what was heard of it last.
  void check_kept(const std::string& id, const std::string& heard);

  std::size_t given_up() const { return given_up_.size(); }
  std::size_t cancelled() const { return cancelled_.size(); }
  const std::map<Rejection, std::size_t>& refusals() const { return refusals_; }

 private:
  struct Ending {
    bool is_plan;
    std::string bytes;  // canonical
    friend bool operator==(const Ending&, const Ending&) = default;
  };

  std::optional<JournalEntry> entry_of(const std::string& id) const { return *journal_.find(id); }
  void on_reply(const RequestReply& reply);
  void on_refusal(const RequestReply& reply);
  void check_outcome(const std::string& id, const Plan& plan);
  void check_fault(const std::string& fault) const;

  const Journal& journal_;
  std::map<RequestHash, std::string> plans_;    // canonical bytes
  std::map<std::string, std::size_t> accepts_;  // by id
  std::map<std::string, Ending> endings_;       // that were said, by id
  std::set<std::string> unwritten_;             // outcomes that the journal has refused once
  std::set<std::string> asked_to_cancel_, cancelled_, given_up_;
  std::map<Rejection, std::size_t> refusals_;
  // Of the present life:
  std::optional<std::string> in_use_;  // of this id other content has come: it is to be refused
  std::set<std::string> under_way_;    // accepted, and nothing said of its end
  std::set<std::string> to_cancel_;    // of these; no plan is to come any more
};

}  // namespace accord::testing
