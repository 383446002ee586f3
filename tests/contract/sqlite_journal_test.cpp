// The journal on disk keeps the contract of Journal, whichever write fails, and says what is wrong
// with files that it cannot use. Killed processes: sqlite_journal_kill_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <sstream>

#include "coordinator/journal/sqlite_journal.h"
#include "tests/contract/disk_faults.h"
#include "tests/contract/journal_contract.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

namespace disk = testing::disk;
namespace fs = std::filesystem;
using journal_contract::Check;
using journal_contract::sample_plan;
using journal_contract::sample_request;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::unique_ptr<SqliteJournal> open(const fs::path& path, SqliteJournal::Options options = {}) {
  auto journal = SqliteJournal::open(path, options);
  if (!journal) throw std::runtime_error(journal.error());
  return std::move(*journal);
}

// Why it cannot be opened; empty where it can.
std::string refusal(const fs::path& path) {
  const auto journal = SqliteJournal::open(path);
  return journal ? "" : journal.error();
}

class SqliteWorld final : public journal_contract::World {
 public:
  SqliteWorld() { restart(); }
  ~SqliteWorld() override { disk::heal(); }
  Journal& journal() override { return *journal_; }
  void restart() override {
    journal_.reset();
    journal_ = open(folder_.path() / "accord.db");
  }
  void set_full(bool full) override { full ? disk::fail_after_writes(0) : disk::heal(); }

 private:
  testing::ScratchFolder folder_;
  std::unique_ptr<SqliteJournal> journal_;
};

class SqliteJournalTest : public ::testing::TestWithParam<Check> {};

TEST_P(SqliteJournalTest, KeepsTheContract) {
  SqliteWorld world;
  EXPECT_EQ(GetParam().run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, SqliteJournalTest,
                         ::testing::ValuesIn(journal_contract::checks()),
                         [](const auto& param_info) { return param_info.param.name; });

// ---- Disks ----

class JournalOnDisk : public ::testing::Test {
 protected:
  ~JournalOnDisk() override { disk::heal(); }

  void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  std::string read(const fs::path& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
  }

  testing::ScratchFolder folder_;
  const fs::path path_ = folder_.path() / "accord.db";
};

TEST_F(JournalOnDisk, HasSyncedEverythingBeforeItReturns) {
  const auto journal = open(path_);
  EXPECT_TRUE(disk::all_synced());
  for (int i = 0; i < 50; ++i) {  // far enough for checkpoints
    const std::string id = std::to_string(i);
    ASSERT_TRUE(journal->accept({sample_request(id, 200'000)}));
    ASSERT_TRUE(disk::all_synced()) << i;
    ASSERT_TRUE(journal->finish(
        {{id, PlanStatus::kSolved, sample_plan(id, 100'000), static_cast<double>(i)}}));
    ASSERT_TRUE(disk::all_synced()) << i;
  }
  ASSERT_TRUE(journal->forget_finished_before(20, 100));
  EXPECT_TRUE(disk::all_synced());
}

// Fails the disk after every possible number of writes (or syncs), and checks each time that what
// was there still is, and that it goes on once the disk is well.
void expect_to_survive(const fs::path& path, void (*fail_after)(std::size_t)) {
  auto journal = open(path);
  ASSERT_TRUE(journal->accept({sample_request("old", 10'000), sample_request("open", 10'000)}));
  ASSERT_TRUE(journal->finish({{"old", PlanStatus::kSolved, sample_plan("old"), 1}}));
  std::size_t failures = 0;
  for (bool failed = true; failed; ++failures) {
    fail_after(failures);
    const std::string id = "new" + std::to_string(failures);
    failed = !journal->accept({sample_request(id, 100'000), sample_request(id + "b", 100)});
    ASSERT_EQ(journal->plan("old").value(), sample_plan("old"));
    ASSERT_EQ(journal->record("open").value(), sample_request("open", 10'000).record);
    ASSERT_EQ(journal->find(id).value().has_value(), !failed);
    ASSERT_EQ(journal->find(id + "b").value().has_value(), !failed);
    disk::heal();
    if (failed) {
      ASSERT_TRUE(journal->accept({sample_request(id, 100'000)}));
    }
    if (failures % 3 == 0) {
      journal.reset();
      journal = open(path);
    }
    ASSERT_EQ(journal->record(id).value(), sample_request(id, 100'000).record);
    ASSERT_EQ(journal->unfinished()->size(), failures + (failed ? 2 : 3));
  }
  EXPECT_GT(failures, 1U);
}

TEST_F(JournalOnDisk, SurvivesAFullDiskAtEveryWrite) {
  expect_to_survive(path_, disk::fail_after_writes);
}

TEST_F(JournalOnDisk, SurvivesADriveThatFailsAtEverySync) {
  expect_to_survive(path_, disk::fail_after_syncs);
}

TEST_F(JournalOnDisk, SaysThatTheDiskIsFull) {
  const auto journal = open(path_);
  disk::fail_after_writes(0);
  EXPECT_EQ(journal->accept({sample_request("a")}).error(),
            "journal \"" + path_.string() +
                "\": no room: the disk is full, or the journal as large as it may be");
  disk::heal();
  disk::fail_after_syncs(0);
  EXPECT_EQ(journal->accept({sample_request("a")}).error(),
            "journal \"" + path_.string() + "\": the disk fails, or takes no larger files");
}

TEST_F(JournalOnDisk, GrowsNoFurtherThanItMay) {
  auto journal = open(path_, {.max_bytes = 1'000'000});
  int accepted = 0;
  while (journal->accept({sample_request(std::to_string(accepted), 100'000)})) ++accepted;
  EXPECT_GE(accepted, 5);
  EXPECT_LT(accepted, 10);
  EXPECT_THAT(journal->accept({sample_request("x", 100'000)}).error(), HasSubstr("no room"));
  EXPECT_EQ(journal->unfinished()->size(), accepted);
  // A plan that takes less room than its request did makes some.
  ASSERT_TRUE(journal->finish({{"0", PlanStatus::kSolved, sample_plan("0", 3000), 0}}));
  ASSERT_TRUE(journal->accept({sample_request("x", 90'000)}));
  journal.reset();
  EXPECT_LE(fs::file_size(path_), 1'000'000);
  // It may be more another time.
  journal = open(path_);
  EXPECT_TRUE(journal->accept({sample_request("y", 500'000)}));
}

TEST_F(JournalOnDisk, UsesTheRoomOfWhatIsForgottenAgain) {
  const auto journal = open(path_);
  std::uint64_t most = 0;
  for (int i = 0; i < 100; ++i) {
    const std::string id = std::to_string(i);
    ASSERT_TRUE(journal->accept({sample_request(id, 50'000)}));
    ASSERT_TRUE(journal->finish(
        {{id, PlanStatus::kSolved, sample_plan(id, 50'000), static_cast<double>(i)}}));
    ASSERT_TRUE(journal->forget_finished_before(i - 5, 10));
    if (i == 20) most = journal->counts()->bytes;
  }
  EXPECT_LE(journal->counts()->bytes, most);
}

// ---- Files that are no journals, or not any more ----

TEST_F(JournalOnDisk, IsOneCoordinatorsAtATime) {
  const std::string expected = "journal \"" + path_.string() + "\": in use by another coordinator";
  auto journal = open(path_);
  EXPECT_EQ(refusal(path_), expected);
  ASSERT_TRUE(journal->accept({sample_request("a")}));
  EXPECT_EQ(refusal(path_), expected);
  journal.reset();
  EXPECT_EQ(refusal(path_), "");
}

TEST_F(JournalOnDisk, SaysWhatIsWrongWithAPlace) {
  EXPECT_EQ(refusal(folder_.path()),
            "journal \"" + folder_.path().string() + "\": cannot be opened: it is a folder");
  EXPECT_EQ(refusal(folder_.path() / "none" / "accord.db"),
            "journal \"" + (folder_.path() / "none" / "accord.db").string() +
                "\": cannot be opened: there is no folder \"" + (folder_.path() / "none").string() +
                "\"");
  EXPECT_EQ(refusal("/dev/null"),
            "journal \"/dev/null\": cannot be opened: it is not a regular file");
  EXPECT_THAT(refusal("/sys/accord.db"),  // where nobody can make a file
              StartsWith("journal \"/sys/accord.db\": cannot be opened: "));
}

TEST_F(JournalOnDisk, IsNotTakenForAFileOfAnotherKind) {
  write(path_, "accord: scene/1\n" + std::string(5000, '#'));
  EXPECT_EQ(refusal(path_),
            "journal \"" + path_.string() + "\": not a journal: the file is no SQLite database");
  EXPECT_EQ(read(path_).size(), 5016U);  // and left as it is
}

// Runs SQL on a database of any kind.
void execute(const fs::path& path, const char* sql) {
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

TEST_F(JournalOnDisk, IsNotTakenForAnotherProgramsDatabase) {
  execute(path_, "CREATE TABLE requests (id TEXT); INSERT INTO requests VALUES ('a')");
  EXPECT_EQ(refusal(path_),
            "journal \"" + path_.string() + "\": not a journal: it is another program's database");
}

TEST_F(JournalOnDisk, OfANewerAccordIsRefused) {
  open(path_).reset();
  execute(path_, "PRAGMA user_version = 2");
  EXPECT_EQ(refusal(path_), "journal \"" + path_.string() +
                                "\": written by a newer Accord: its format is 2, and this one "
                                "knows formats up to 1");
}

TEST_F(JournalOnDisk, BeginsInAnEmptyFile) {
  write(path_, "");
  EXPECT_EQ(refusal(path_), "");
}

// A journal with entries, closed.
void fill(const fs::path& path) {
  const auto journal = open(path);
  for (int i = 0; i < 40; ++i) {
    const std::string id = "request-" + std::to_string(i);
    ASSERT_TRUE(journal->accept({sample_request(id, 3000)}));
    if (i % 2 == 0) {
      ASSERT_TRUE(journal->finish(
          {{id, PlanStatus::kSolved, sample_plan(id, 9000), static_cast<double>(i)}}));
    }
  }
}

TEST_F(JournalOnDisk, ThatIsDamagedIsNoticedWhereverTheDamageIs) {
  fill(path_);
  const std::string sound = read(path_);
  std::size_t refused = 0;
  std::size_t failed = 0;
  constexpr std::size_t kPage = 4096;
  for (std::size_t page = 0; page < sound.size() / kPage; ++page) {
    std::string damaged = sound;
    for (std::size_t i = page == 0 ? 100 : 0; i < kPage; ++i) damaged[page * kPage + i] ^= '\x5a';
    write(path_, damaged);
    const auto journal = SqliteJournal::open(path_);
    if (!journal) {
      EXPECT_THAT(journal.error(), HasSubstr("journal \"" + path_.string() + "\": "));
      ++refused;
      continue;
    }
    bool all_there = true;
    for (int i = 0; i < 40; ++i) {
      const std::string id = "request-" + std::to_string(i);
      if (i % 2 == 0) {
        const auto plan = (*journal)->plan(id);
        all_there = all_there && plan;
        EXPECT_EQ(plan.value_or(sample_plan(id, 9000)), sample_plan(id, 9000));
      } else {
        const auto request = (*journal)->record(id);
        all_there = all_there && request;
        EXPECT_EQ(request.value_or(sample_request(id, 3000).record),
                  sample_request(id, 3000).record);
      }
    }
    if (!all_there) ++failed;
  }
  EXPECT_GE(refused, 3U);
  EXPECT_GE(failed, 50U);
}

TEST_F(JournalOnDisk, ThatIsCutShortIsNoticed) {
  fill(path_);
  const std::string sound = read(path_);
  for (const std::size_t size : {std::size_t{10}, std::size_t{100}, std::size_t{5000}}) {
    write(path_, sound.substr(0, size));
    EXPECT_THAT(refusal(path_), StartsWith("journal \"" + path_.string() + "\": ")) << size;
  }
}

TEST_F(JournalOnDisk, NoticesOneBitOfAPlanThatTheDiskTurned) {
  {
    const auto journal = open(path_);
    ASSERT_TRUE(journal->accept({sample_request("a", 30'000), sample_request("b", 30'000)}));
    ASSERT_TRUE(journal->finish({{"a", PlanStatus::kSolved, sample_plan("a", 30'000), 1}}));
  }
  std::string bytes = read(path_);
  for (const std::string& part : {sample_plan("a", 30'000).substr(20'000, 32), [] {
                                    const Bytes request = sample_request("b", 30'000).record;
                                    return std::string(request.begin() + 20'000,
                                                       request.begin() + 20'032);
                                  }()}) {
    const std::size_t at = bytes.find(part);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 7] ^= 4;
  }
  write(path_, bytes);
  const auto journal = open(path_);
  EXPECT_THAT(journal->plan("a").error(), EndsWith("damaged: the bytes of request \"a\""));
  EXPECT_THAT(journal->record("b").error(), EndsWith("damaged: the bytes of request \"b\""));
}

}  // namespace
}  // namespace accord
