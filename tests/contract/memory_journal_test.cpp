// The journal in memory keeps the contract of Journal, and wrong ones do not.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "coordinator/journal/memory_journal.h"
#include "tests/contract/journal_contract.h"

namespace accord {
namespace {

using journal_contract::Check;

template <typename Kind>
class MemoryWorld final : public journal_contract::World {
 public:
  Journal& journal() override { return journal_; }
  void restart() override {
    if constexpr (requires { journal_.restart(); }) journal_.restart();
  }
  void set_full(bool full) override {
    journal_.fail_next_writes(full ? std::numeric_limits<std::size_t>::max() : 0);
  }

 private:
  Kind journal_;
};

class MemoryJournalTest : public testing::TestWithParam<Check> {};

TEST_P(MemoryJournalTest, KeepsTheContract) {
  MemoryWorld<MemoryJournal> world;
  EXPECT_EQ(GetParam().run(world), "");
}

INSTANTIATE_TEST_SUITE_P(Contract, MemoryJournalTest, testing::ValuesIn(journal_contract::checks()),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(MemoryJournalFaults, AreAsManyAsOrdered) {
  MemoryJournal journal;
  journal.fail_next_writes(2);
  EXPECT_FALSE(journal.accept({journal_contract::sample_request("a")}));
  EXPECT_FALSE(journal.accept({journal_contract::sample_request("a")}));
  EXPECT_TRUE(journal.accept({journal_contract::sample_request("a")}));
}

// ---- Wrong ones ----

struct AcceptsByHalves : MemoryJournal {
  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override {
    return MemoryJournal::do_accept({requests.front()});
  }
};

struct Disordered : MemoryJournal {
  Result<std::vector<JournalEntry>> do_entries(bool unfinished_only) const override {
    auto entries = MemoryJournal::do_entries(unfinished_only);
    std::ranges::sort(*entries, {}, &JournalEntry::id);
    return entries;
  }
};

struct FinishesByHalves : MemoryJournal {
  Result<void> do_finish(const std::vector<FinishedRequest>& requests) override {
    return MemoryJournal::do_finish({requests.front()});
  }
};

struct CutsPlans : MemoryJournal {
  Result<std::string> do_plan(const JournalEntry& entry) const override {
    return MemoryJournal::do_plan(entry)->c_str();
  }
};

struct Optimistic : MemoryJournal {
  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override {
    return MemoryJournal::do_accept(requests).value_or(1);
  }
};

struct TooForgetful : MemoryJournal {
  Result<std::size_t> do_forget(double, std::size_t most) override {
    return MemoryJournal::do_forget(std::numeric_limits<double>::infinity(), most);
  }
};

struct NeverForgetful : MemoryJournal {
  Result<std::size_t> do_forget(double, std::size_t) override { return 0; }
};

// Says that it is accepted before it is on disk.
struct Hasty : MemoryJournal {
  Result<std::uint64_t> do_accept(const std::vector<AcceptedRequest>& requests) override {
    accepted_last_ = requests.back().id;
    return MemoryJournal::do_accept(requests);
  }
  Result<std::optional<JournalEntry>> do_find(std::string_view id) const override {
    if (id == lost_) return std::nullopt;
    return MemoryJournal::do_find(id);
  }
  Result<std::vector<JournalEntry>> do_entries(bool unfinished_only) const override {
    auto entries = MemoryJournal::do_entries(unfinished_only);
    std::erase_if(*entries, [&](const JournalEntry& entry) { return entry.id == lost_; });
    return entries;
  }
  void restart() { lost_ = accepted_last_; }

  std::string accepted_last_;
  std::string lost_;
};

template <typename Wrong>
std::string breach(const std::string& check) {
  MemoryWorld<Wrong> world;
  return journal_contract::check_named(check).run(world);
}

TEST(WrongJournals, AreToldFromRightOnes) {
  EXPECT_EQ(breach<MemoryJournal>("EverythingOutlivesARestart"), "");
  EXPECT_NE(breach<AcceptsByHalves>("NumbersGrowOneByOne"), "");
  EXPECT_NE(breach<Disordered>("UnfinishedOnesComeInTheOrderOfAcceptance"), "");
  EXPECT_NE(breach<CutsPlans>("WhatIsFinishedKeepsItsPlan"), "");
  EXPECT_NE(breach<FinishesByHalves>("ABatchIsFinishedWholeOrNotAtAll"), "");
  EXPECT_NE(breach<Optimistic>("AFullDiskRefusesAndLosesNothing"), "");
  EXPECT_NE(breach<TooForgetful>("OnlyWhatFinishedBeforeIsForgotten"), "");
  EXPECT_NE(breach<NeverForgetful>("AFewAreForgottenAtATime"), "");
  EXPECT_NE(breach<Hasty>("EverythingOutlivesARestart"), "");
}

}  // namespace
}  // namespace accord
