// The coordinator's memory: which requests it has accepted, and what became of them.
//
// A request is here, for good, before its sender is told that it is accepted; so a coordinator that
// was killed finds it again and finishes it. Finished plans stay until they are forgotten, to be
// served again. Two implementations, which pass one suite of checks
// (tests/contract/journal_contract.h): SqliteJournal, on disk, and MemoryJournal, for tests and
// for services that need not outlive their process.
//
// Failure is a sentence for the operator: the disk is full, the file is damaged, or the caller asks
// for what the entries do not allow. What fails changes nothing, and may be tried again: nothing
// has to be opened anew when there is room once more.
//
// Thread safety: one thread owns a journal. Nothing throws but std::bad_alloc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"
#include "common/model/plan.h"

namespace accord {

struct AcceptedRequest {
  std::string id;
  RequestHash content;     // of what its sender put: tells requests of one id apart
  Bytes record;            // all that it takes to finish it
  double accepted_at = 0;  // s since 1970, wall clock
};

struct FinishedRequest {
  std::string id;
  PlanStatus status = PlanStatus::kInvalid;
  std::string plan;        // its plan file (to_json)
  double finished_at = 0;  // s since 1970, wall clock
};

// What is known of a request without looking at its bytes, which may be many.
struct JournalEntry {
  // What became of it.
  struct Outcome {
    PlanStatus status = PlanStatus::kInvalid;
    double finished_at = 0;  // s since 1970, wall clock

    friend bool operator==(const Outcome&, const Outcome&) = default;
  };

  std::uint64_t sequence = 0;  // from 1, in the order of acceptance; no number is given out twice
  std::string id;
  RequestHash content;
  double accepted_at = 0;          // s since 1970
  std::optional<Outcome> outcome;  // nullopt: unfinished

  friend bool operator==(const JournalEntry&, const JournalEntry&) = default;
};

struct JournalCounts {
  std::uint64_t unfinished = 0;
  std::uint64_t finished = 0;
  std::uint64_t bytes = 0;  // that all of it takes, room that can be used again included

  friend bool operator==(const JournalCounts&, const JournalCounts&) = default;
};

class Journal {
 public:
  template <typename Value>
  using Result = tl::expected<Value, std::string>;

  Journal() = default;
  virtual ~Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // Takes in all of the requests or none; once it returns, they outlive this process and a loss of
  // power. One call costs about as much for many requests as for one. Returns the first one's
  // sequence number, which the others' follow one by one. Fails where there is none, where an id is
  // empty or is here already, or a time is no number.
  Result<std::uint64_t> accept(const std::vector<AcceptedRequest>& requests);

  // Records what became of unfinished requests, all of them or none, and gives up their records. As
  // durable as accept(), and as cheap for many. Where it fails the requests stay unfinished;
  // planned again, they have the same plans.
  Result<void> finish(const std::vector<FinishedRequest>& requests);

  Result<std::optional<JournalEntry>> find(std::string_view id) const;
  // In the order of acceptance: all there are, and those that are not finished.
  Result<std::vector<JournalEntry>> entries() const;
  Result<std::vector<JournalEntry>> unfinished() const;

  // The record of an unfinished request, and the plan file of a finished one, to the byte as they
  // were given: what disks make of them is noticed, and is a failure.
  Result<Bytes> record(std::string_view id) const;
  Result<std::string> plan(std::string_view id) const;

  // Forgets at most `most` of the requests that finished before `time` (s since 1970), those first
  // that finished first, and returns how many. Their ids are free again. What it costs grows with
  // the size of their plans, so a loop asks for a few at a time until none are left.
  Result<std::size_t> forget_finished_before(double time, std::size_t most);

  Result<JournalCounts> counts() const;

 private:
  // As the public ones, with arguments that are sound in themselves.
  virtual Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) = 0;
  virtual Result<void> do_finish(const std::vector<FinishedRequest>& requests) = 0;
  virtual Result<std::optional<JournalEntry>> do_find(std::string_view id) const = 0;
  virtual Result<std::vector<JournalEntry>> do_entries(bool unfinished_only) const = 0;
  // Require: there is such an entry, unfinished or finished, respectively.
  virtual Result<Bytes> do_record(const JournalEntry& entry) const = 0;
  virtual Result<std::string> do_plan(const JournalEntry& entry) const = 0;
  virtual Result<std::size_t> do_forget(double time, std::size_t most) = 0;
  virtual Result<JournalCounts> do_counts() const = 0;
};

}  // namespace accord
