// The journal on disk in processes that are killed, that may write no more, that have no
// permission.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <optional>

#include "common/planning/random.h"
#include "coordinator/journal/sqlite_journal.h"
#include "tests/contract/journal_contract.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

namespace fs = std::filesystem;
using journal_contract::sample_plan;
using journal_contract::sample_request;
using Say = std::function<void(const std::string& line)>;

// A fork of this process that does `work`, and what it said.
class Fork {
 public:
  explicit Fork(const std::function<void(const Say&)>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      close(ends[0]);
      run(work, ends[1]);
    }
    close(ends[1]);
    reading_ = ends[0];
  }
  ~Fork() {
    kill();
    close(reading_);
  }
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = 0;
  }

  // The next line, once it is there; nullopt when there will be none.
  std::optional<std::string> line() {
    std::string out;
    for (char c = 0; read(reading_, &c, 1) == 1;) {
      if (c == '\n') return out;
      out += c;
    }
    return std::nullopt;
  }

  // All that are left, once it has ended.
  std::vector<std::string> lines() {
    std::vector<std::string> out;
    while (auto next = line()) out.push_back(std::move(*next));
    return out;
  }

 private:
  // Never comes back: the tests are the parent's. What is thrown ends the process.
  [[noreturn]] static void run(const std::function<void(const Say&)>& work, int pipe) noexcept {
    work([pipe](const std::string& line) {
      const std::string text = line + "\n";
      if (write(pipe, text.data(), text.size()) < 0) _exit(1);
    });
    _exit(0);
  }

  pid_t child_ = 0;
  int reading_ = -1;
};

std::size_t request_size(const std::string& id) {
  return 1 + std::hash<std::string>()(id) % 60'000;
}

// ---- Killed ----

// Accepts and finishes without end, and says so only afterwards.
void work_until_killed(const fs::path& path, std::uint64_t seed, const Say& say) {
  RandomStream random(seed);
  auto journal = SqliteJournal::open(path);
  if (!journal) return say("cannot open " + journal.error());
  std::vector<std::string> open;
  const auto left = (*journal)->unfinished().value();
  for (const JournalEntry& entry : left) open.push_back(entry.id);
  for (int number = 0;; ++number) {
    std::vector<AcceptedRequest> batch;
    for (std::size_t i = 0; i <= random.below(6); ++i) {
      const std::string id =
          std::to_string(seed) + "." + std::to_string(number) + "." + std::to_string(i);
      batch.push_back(sample_request(id, request_size(id)));
    }
    const auto accepted = (*journal)->accept(batch);
    if (!accepted) return say("cannot accept: " + accepted.error());
    for (const AcceptedRequest& request : batch) {
      say("accepted " + request.id);
      open.push_back(request.id);
    }
    while (open.size() > 20 || (!open.empty() && random.below(2) == 0)) {
      const std::string id = open.front();
      open.erase(open.begin());
      const std::string plan = sample_plan(id, 2 * request_size(id));
      const auto finished =
          (*journal)->finish({{id, PlanStatus::kSolved, plan, static_cast<double>(number)}});
      if (!finished) return say("cannot finish: " + finished.error());
      say("finished " + id);
    }
  }
}

// How often each id was reported, by what it was reported as.
using Reports = std::map<std::string, std::map<std::string, int>>;

void expect_all_there(const fs::path& path, const Reports& reports) {
  const auto opened = SqliteJournal::open(path);
  ASSERT_TRUE(opened) << opened.error();
  const Journal& journal = **opened;
  for (const auto& [id, what] : reports) {
    const auto entry = journal.find(id);
    ASSERT_TRUE(entry && *entry) << id << " was lost";
    if (what.contains("finished")) {
      ASSERT_TRUE((*entry)->outcome) << id << " is unfinished again";
    }
    if ((*entry)->outcome) {
      ASSERT_EQ(journal.plan(id).value(), sample_plan(id, 2 * request_size(id)));
    }
  }
  // Those that nobody was told of are whole, too, and nobody is there twice.
  std::uint64_t last = 0;
  const auto unfinished = journal.unfinished().value();
  for (const JournalEntry& entry : unfinished) {
    ASSERT_GT(entry.sequence, last);
    last = entry.sequence;
    ASSERT_EQ(journal.record(entry.id).value(),
              sample_request(entry.id, request_size(entry.id)).record);
  }
  const JournalCounts counts = journal.counts().value();
  EXPECT_EQ(counts.unfinished, unfinished.size());
  // At most what was under way at a kill was done and not reported.
  EXPECT_GE(counts.unfinished + counts.finished, reports.size());
}

// ACCORD_JOURNAL_KILLS: how many; ACCORD_SEED: other moments.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

TEST(KilledProcess, LosesNothingThatItSaidWasAccepted) {
  const std::uint64_t rounds = from_environment("ACCORD_JOURNAL_KILLS", 20);
  const std::uint64_t seed = from_environment("ACCORD_SEED", 1);
  RandomStream random(seed);
  testing::ScratchFolder folder;
  fs::path path;
  Reports reports;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    if (round % 20 == 0) {  // else looking at all of it takes longer and longer
      path = folder.path() / (std::to_string(round) + ".db");
      reports.clear();
    }
    Fork child([&](const Say& say) { work_until_killed(path, combine({seed, round}), say); });
    // From before the file is there to many commits later.
    const double seconds = random.uniform(0, random.below(2) == 0 ? 0.02 : 0.15);
    const timespec pause{0, static_cast<long>(1e9 * seconds)};
    nanosleep(&pause, nullptr);
    child.kill();
    for (const std::string& line : child.lines()) {
      const std::size_t space = line.find(' ');
      const std::string what = line.substr(0, space);
      ASSERT_TRUE(what == "accepted" || what == "finished") << line;
      ASSERT_EQ(++reports[line.substr(space + 1)][what], 1) << line;
    }
    expect_all_there(path, reports);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(reports.size(), 10U) << "nobody got anything done";
}

TEST(KilledProcess, LeavesTheJournalToTheNextCoordinatorAtOnce) {
  testing::ScratchFolder folder;
  const fs::path path = folder.path() / "accord.db";
  Fork child([&](const Say& say) {
    const auto journal = SqliteJournal::open(path);
    say(journal ? "open" : journal.error());
    pause();
  });
  const auto refusal = [&] {
    const auto journal = SqliteJournal::open(path);
    return journal ? std::string() : journal.error();
  };
  ASSERT_EQ(child.line(), "open");
  EXPECT_EQ(refusal(), "journal \"" + path.string() + "\": in use by another coordinator");
  child.kill();
  EXPECT_EQ(refusal(), "");
}

// ---- Full ----

TEST(ProcessThatMayWriteNoMore, KeepsWhatItHasAndGoesOnWhenThereIsRoom) {
  testing::ScratchFolder folder;
  const fs::path path = folder.path() / "accord.db";
  Fork child([&](const Say& say) {
    std::signal(SIGXFSZ, SIG_IGN);
    auto journal = std::move(SqliteJournal::open(path).value());
    const rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
    const rlimit limit{1'000'000, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
    int accepted = 0;
    std::string why;
    for (; why.empty(); ++accepted) {
      const auto done = journal->accept({sample_request(std::to_string(accepted), 100'000)});
      if (!done) why = done.error();
    }
    say(why);
    const int last = accepted - 1;
    bool readable = true;
    for (int i = 0; i < last; ++i) {
      const std::string id = std::to_string(i);
      readable = readable && journal->record(id) == sample_request(id, 100'000).record;
    }
    say(readable && !journal->find(std::to_string(last)).value() ? "readable" : "lost");
    setrlimit(RLIMIT_FSIZE, &unlimited);
    say(journal->accept({sample_request(std::to_string(last), 100'000)}) ? "goes on" : "stuck");
    journal.reset();
    journal = std::move(SqliteJournal::open(path).value());
    say(journal->unfinished()->size() == static_cast<std::size_t>(accepted) ? "whole" : "damaged");
  });
  EXPECT_THAT(child.lines(),
              ::testing::ElementsAre(
                  "journal \"" + path.string() + "\": the disk fails, or takes no larger files",
                  "readable", "goes on", "whole"));
}

// ---- Without permission ----

TEST(ProcessWithoutPermission, IsTold) {
  testing::ScratchFolder folder;
  const fs::path old = folder.path() / "old.db";
  ASSERT_TRUE(SqliteJournal::open(old));
  fs::permissions(old, fs::perms::owner_read | fs::perms::others_read);
  fs::permissions(folder.path(),
                  fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  Fork child([&](const Say& say) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) {
      return say("cannot become somebody else");
    }
    say(SqliteJournal::open(old).error());
    if (getuid() == kNobody) say(SqliteJournal::open(folder.path() / "new.db").error());
  });
  const auto said = child.lines();
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said[0], "journal \"" + old.string() + "\": cannot be opened: Permission denied");
  if (said.size() > 1) {
    EXPECT_EQ(said[1], "journal \"" + (folder.path() / "new.db").string() +
                           "\": cannot be opened: Permission denied");
  }
}

}  // namespace
}  // namespace accord
