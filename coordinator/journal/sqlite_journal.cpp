#include "coordinator/journal/sqlite_journal.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "common/io/words.h"
#include "coordinator/journal/sqlite_database.h"
#include "coordinator/journal/sqlite_schema.h"

namespace accord {
namespace {

template <typename Value>
using Result = Journal::Result<Value>;

std::optional<PlanStatus> status_in(std::string_view word) {
  constexpr std::array kAll = {PlanStatus::kSolved, PlanStatus::kInfeasible, PlanStatus::kTimeout,
                               PlanStatus::kCancelled, PlanStatus::kInvalid};
  const auto found = std::ranges::find(kAll, word, [](PlanStatus s) { return to_string(s); });
  return found == kAll.end() ? std::nullopt : std::optional(*found);
}

BytesView bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Result<SceneHash> checked_hash(BytesView bytes) {
  try {
    return hash_of(bytes);
  } catch (const std::runtime_error& error) {
    return tl::unexpected(std::string(error.what()));
  }
}

// An entry from the columns sequence, id, content, accepted_at, status, finished_at.
Result<JournalEntry> entry_in(const SqliteQuery& row, const SqliteDatabase& database) {
  JournalEntry entry;
  entry.sequence = row.number(0);
  entry.id = row.text(1);
  const BytesView content = row.bytes(2);
  entry.accepted_at = row.real(3);
  const auto status = row.is_null(4) ? PlanStatus::kInvalid : status_in(row.text(4));
  if (content.size() != entry.content.bytes.size() || !status) {
    return tl::unexpected(database.about("damaged: the entry of request " + in_quotes(entry.id)));
  }
  std::ranges::copy(content, entry.content.bytes.begin());
  if (!row.is_null(4)) entry.outcome = {*status, row.real(5)};
  return entry;
}

// The bytes that are a query's only result, with the hash that they had when they went in, if they
// still have it.
Result<BytesView> sound_bytes(SqliteQuery& query, const JournalEntry& entry,
                              const SqliteDatabase& database) {
  const auto row = query.next();
  if (!row) return tl::unexpected(row.error());
  const BytesView bytes = *row ? query.bytes(0) : BytesView();
  const auto found = checked_hash(bytes);
  if (!found) return tl::unexpected(found.error());
  if (*row && std::ranges::equal(found->bytes, query.bytes(1))) return bytes;
  return tl::unexpected(database.about("damaged: the bytes of request " + in_quotes(entry.id)));
}

}  // namespace

SqliteJournal::SqliteJournal(std::unique_ptr<SqliteDatabase> database)
    : database_(std::move(database)) {}
SqliteJournal::~SqliteJournal() = default;

Result<std::unique_ptr<SqliteJournal>> SqliteJournal::open(const std::filesystem::path& path,
                                                           const Options& options) {
  auto database = SqliteDatabase::open(path);
  if (!database) return tl::unexpected(database.error());
  if (const auto ready = prepare_schema(**database); !ready) return tl::unexpected(ready.error());
  if (options.max_bytes > 0) {
    const auto page = (*database)->number("PRAGMA page_size");
    if (!page) return tl::unexpected(page.error());
    const std::uint64_t pages = std::max<std::uint64_t>(1, options.max_bytes / *page);
    const std::string limit = "PRAGMA max_page_count = " + std::to_string(pages);
    if (const auto set = (*database)->execute(limit.c_str()); !set) {
      return tl::unexpected(set.error());
    }
  }
  return std::unique_ptr<SqliteJournal>(new SqliteJournal(std::move(*database)));
}

Result<std::uint64_t> SqliteJournal::do_accept(const std::vector<AcceptedRequest>& requests) {
  const auto transaction = SqliteTransaction::begin(*database_);
  if (!transaction) return tl::unexpected(transaction.error());
  std::uint64_t last = 0;
  for (const auto& [id, content, bytes, accepted_at] : requests) {
    const auto hash = checked_hash(bytes);
    if (!hash) return tl::unexpected(hash.error());
    auto entered =
        database_
            ->query(
                "INSERT INTO requests (id, content, accepted_at, bytes_hash) VALUES (?, ?, ?, ?)")
            .with(std::string_view(id))
            .with(BytesView(content.bytes))
            .with(accepted_at)
            .with(BytesView(hash->bytes))
            .run();
    if (!entered) return tl::unexpected(entered.error());
    last = database_->last_inserted();
    entered = database_->query("INSERT INTO record_bytes (sequence, bytes) VALUES (?, ?)")
                  .with(last)
                  .with(BytesView(bytes))
                  .run();
    if (!entered) return tl::unexpected(entered.error());
  }
  if (const auto done = (*transaction)->commit(); !done) return tl::unexpected(done.error());
  return last - requests.size() + 1;
}

Result<void> SqliteJournal::do_finish(const std::vector<FinishedRequest>& requests) {
  const auto transaction = SqliteTransaction::begin(*database_);
  if (!transaction) return tl::unexpected(transaction.error());
  for (const FinishedRequest& request : requests) {
    if (auto done = store(request); !done) return done;
  }
  return (*transaction)->commit();
}

Result<void> SqliteJournal::store(const FinishedRequest& request) {
  const auto& [id, status, plan, finished_at] = request;
  const auto hash = checked_hash(bytes_of(plan));
  if (!hash) return tl::unexpected(hash.error());
  SqliteQuery update = database_->query(
      "UPDATE requests SET status = ?, finished_at = ?, bytes_hash = ? WHERE id = ?"
      " RETURNING sequence");
  const auto row = update.with(to_string(status))
                       .with(finished_at)
                       .with(BytesView(hash->bytes))
                       .with(std::string_view(id))
                       .next();
  if (!row) return tl::unexpected(row.error());
  const std::uint64_t sequence = update.number(0);
  auto done = update.run();
  if (!done) return done;
  done = database_->query("INSERT INTO plan_bytes (sequence, bytes) VALUES (?, ?)")
             .with(sequence)
             .with(bytes_of(plan))
             .run();
  if (!done) return done;
  return database_->query("DELETE FROM record_bytes WHERE sequence = ?").with(sequence).run();
}

Result<std::optional<JournalEntry>> SqliteJournal::do_find(std::string_view id) const {
  SqliteQuery query = database_->query(
      "SELECT sequence, id, content, accepted_at, status, finished_at FROM requests WHERE id = ?");
  const auto row = query.with(id).next();
  if (!row) return tl::unexpected(row.error());
  if (!*row) return std::nullopt;
  return entry_in(query, *database_);
}

Result<std::vector<JournalEntry>> SqliteJournal::do_entries(bool unfinished_only) const {
  SqliteQuery query = database_->query(
      unfinished_only
          ? "SELECT sequence, id, content, accepted_at, status, finished_at FROM requests"
            " WHERE status IS NULL ORDER BY sequence"
          : "SELECT sequence, id, content, accepted_at, status, finished_at FROM requests"
            " ORDER BY sequence");
  std::vector<JournalEntry> out;
  while (true) {
    const auto row = query.next();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return out;
    auto entry = entry_in(query, *database_);
    if (!entry) return tl::unexpected(entry.error());
    out.push_back(std::move(*entry));
  }
}

Result<Bytes> SqliteJournal::do_record(const JournalEntry& entry) const {
  SqliteQuery query = database_->query(
      "SELECT bytes, bytes_hash FROM record_bytes JOIN requests USING (sequence)"
      " WHERE sequence = ?");
  query.with(entry.sequence);
  const auto bytes = sound_bytes(query, entry, *database_);
  if (!bytes) return tl::unexpected(bytes.error());
  return Bytes(bytes->begin(), bytes->end());
}

Result<std::string> SqliteJournal::do_plan(const JournalEntry& entry) const {
  SqliteQuery query = database_->query(
      "SELECT bytes, bytes_hash FROM plan_bytes JOIN requests USING (sequence)"
      " WHERE sequence = ?");
  query.with(entry.sequence);
  const auto bytes = sound_bytes(query, entry, *database_);
  if (!bytes) return tl::unexpected(bytes.error());
  return std::string(bytes->begin(), bytes->end());
}

Result<std::size_t> SqliteJournal::do_forget(double time, std::size_t most) {
  std::vector<std::uint64_t> old;
  {
    SqliteQuery query = database_->query(
        "SELECT sequence FROM requests WHERE status IS NOT NULL AND finished_at < ?"
        " ORDER BY finished_at, sequence LIMIT ?");
    query.with(time).with(static_cast<std::uint64_t>(most));
    while (true) {
      const auto row = query.next();
      if (!row) return tl::unexpected(row.error());
      if (!*row) break;
      old.push_back(query.number(0));
    }
  }
  if (old.empty()) return 0;
  const auto transaction = SqliteTransaction::begin(*database_);
  if (!transaction) return tl::unexpected(transaction.error());
  for (const std::uint64_t sequence : old) {
    auto done = database_->query("DELETE FROM plan_bytes WHERE sequence = ?").with(sequence).run();
    if (!done) return tl::unexpected(done.error());
    done = database_->query("DELETE FROM requests WHERE sequence = ?").with(sequence).run();
    if (!done) return tl::unexpected(done.error());
  }
  if (const auto done = (*transaction)->commit(); !done) return tl::unexpected(done.error());
  return old.size();
}

Result<JournalCounts> SqliteJournal::do_counts() const {
  const auto all = database_->number("SELECT count(*) FROM requests");
  if (!all) return tl::unexpected(all.error());
  const auto unfinished = database_->number("SELECT count(*) FROM requests WHERE status IS NULL");
  if (!unfinished) return tl::unexpected(unfinished.error());
  const auto pages = database_->number("PRAGMA page_count");
  if (!pages) return tl::unexpected(pages.error());
  const auto page = database_->number("PRAGMA page_size");
  if (!page) return tl::unexpected(page.error());
  return JournalCounts{*unfinished, *all - *unfinished, *pages * *page};
}

}  // namespace accord
