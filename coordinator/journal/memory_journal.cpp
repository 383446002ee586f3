#include "coordinator/journal/memory_journal.h"

namespace accord {
namespace {

tl::unexpected<std::string> full() {
  return tl::unexpected(
      std::string("the journal cannot be written: the disk is full (a fault that "
                  "was ordered)"));
}

}  // namespace

bool MemoryJournal::is_full() {
  if (failing_writes_ == 0) return false;
  --failing_writes_;
  return true;
}

Journal::Result<std::uint64_t> MemoryJournal::do_accept(
    const std::vector<AcceptedRequest>& requests) {
  if (is_full()) return full();
  const std::uint64_t first = next_sequence_;
  for (const auto& [id, content, bytes, accepted_at] : requests) {
    const std::uint64_t sequence = next_sequence_++;
    records_.emplace(sequence, Record{{sequence, id, content, accepted_at, {}}, bytes, {}});
    by_id_.emplace(id, sequence);
  }
  return first;
}

Journal::Result<void> MemoryJournal::do_finish(const std::vector<FinishedRequest>& requests) {
  if (is_full()) return full();
  for (const auto& [id, status, plan, finished_at] : requests) {
    Record& record = records_.at(by_id_.find(id)->second);
    record.entry.outcome = {status, finished_at};
    record.plan = plan;
    record.record = {};
    by_finish_time_.emplace(finished_at, record.entry.sequence);
  }
  return {};
}

Journal::Result<std::optional<JournalEntry>> MemoryJournal::do_find(std::string_view id) const {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return std::nullopt;
  return records_.at(found->second).entry;
}

Journal::Result<std::vector<JournalEntry>> MemoryJournal::do_entries(bool unfinished_only) const {
  std::vector<JournalEntry> out;
  for (const auto& [sequence, record] : records_) {
    if (!unfinished_only || !record.entry.outcome) out.push_back(record.entry);
  }
  return out;
}

Journal::Result<Bytes> MemoryJournal::do_record(const JournalEntry& entry) const {
  return record_of(entry).record;
}

Journal::Result<std::string> MemoryJournal::do_plan(const JournalEntry& entry) const {
  return record_of(entry).plan;
}

Journal::Result<std::size_t> MemoryJournal::do_forget(double time, std::size_t most) {
  const bool any = !by_finish_time_.empty() && by_finish_time_.begin()->first < time;
  if (any && is_full()) return full();
  std::size_t forgotten = 0;
  while (forgotten < most && !by_finish_time_.empty() && by_finish_time_.begin()->first < time) {
    const auto record = records_.find(by_finish_time_.begin()->second);
    by_id_.erase(record->second.entry.id);
    records_.erase(record);
    by_finish_time_.erase(by_finish_time_.begin());
    ++forgotten;
  }
  return forgotten;
}

Journal::Result<JournalCounts> MemoryJournal::do_counts() const {
  JournalCounts counts;
  counts.finished = by_finish_time_.size();
  counts.unfinished = records_.size() - counts.finished;
  for (const auto& [sequence, record] : records_) {
    counts.bytes += record.record.size() + record.plan.size();
  }
  return counts;
}

}  // namespace accord
