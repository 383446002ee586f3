// The journal on disk: an SQLite database with a write-ahead log, one commit an accept().
//
// Whoever is killed, or loses power, at any moment leaves a journal with all that was accepted and
// finished, and nothing by halves. Only what failed (because a drive could not sync, say) just
// before the process was killed may be there after all. It is one coordinator's at a time. A copy
// may be made of the file and its "-wal" while no coordinator has it open.
#pragma once

#include <filesystem>
#include <memory>

#include "coordinator/journal/journal.h"

namespace accord {

class SqliteDatabase;

class SqliteJournal : public Journal {
 public:
  struct Options {
    // The file grows no further: then the journal is full like a disk. 0: as large as the disk
    // allows. The log beside it comes on top, 64 MiB and the largest commit.
    std::uint64_t max_bytes = 0;
  };

  // Opens the journal, or begins one where there is no file; its folder is there. Fails where the
  // file is no journal, a newer Accord's, damaged, another coordinator's at the moment, or cannot
  // be written.
  static Result<std::unique_ptr<SqliteJournal>> open(const std::filesystem::path& path,
                                                     const Options& options);
  static Result<std::unique_ptr<SqliteJournal>> open(const std::filesystem::path& path) {
    return open(path, Options{});
  }
  ~SqliteJournal() override;

 private:
  explicit SqliteJournal(std::unique_ptr<SqliteDatabase> database);

  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override;
  Result<void> do_finish(const std::vector<FinishedRequest>& requests) override;
  Result<std::optional<JournalEntry>> do_find(std::string_view id) const override;
  Result<std::vector<JournalEntry>> do_entries(bool unfinished_only) const override;
  Result<Bytes> do_record(const JournalEntry& entry) const override;
  Result<std::string> do_plan(const JournalEntry& entry) const override;
  Result<std::size_t> do_forget(double time, std::size_t most) override;
  Result<JournalCounts> do_counts() const override;

  Result<void> store(const FinishedRequest& request);

  std::unique_ptr<SqliteDatabase> database_;
};

}  // namespace accord
