// A journal that lasts as long as the object: for tests, where it outlives the coordinators that
// are killed and started on it, and for services that have none on disk.
#pragma once

#include <map>
#include <set>

#include "coordinator/journal/journal.h"

namespace accord {

class MemoryJournal : public Journal {
 public:
  // The next `writes` calls that would change something fail as on a full disk.
  void fail_next_writes(std::size_t writes) { failing_writes_ = writes; }

 protected:
  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override;
  Result<void> do_finish(const std::vector<FinishedRequest>& requests) override;
  Result<std::optional<JournalEntry>> do_find(std::string_view id) const override;
  Result<std::vector<JournalEntry>> do_entries(bool unfinished_only) const override;
  Result<Bytes> do_record(const JournalEntry& entry) const override;
  Result<std::string> do_plan(const JournalEntry& entry) const override;
  Result<std::size_t> do_forget(double time, std::size_t most) override;
  Result<JournalCounts> do_counts() const override;

 private:
  struct Record {
    JournalEntry entry;
    Bytes record;      // empty once finished
    std::string plan;  // empty until then
  };

  // Whether a write is to fail; counts down.
  bool is_full();
  const Record& record_of(const JournalEntry& entry) const { return records_.at(entry.sequence); }

  std::uint64_t next_sequence_ = 1;
  std::map<std::uint64_t, Record> records_;                    // by sequence
  std::map<std::string, std::uint64_t, std::less<>> by_id_;    // to sequence
  std::set<std::pair<double, std::uint64_t>> by_finish_time_;  // with sequence
  std::size_t failing_writes_ = 0;
};

}  // namespace accord
