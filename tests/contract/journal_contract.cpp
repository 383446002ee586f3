#include "tests/contract/journal_contract.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "common/planning/random.h"

namespace accord::journal_contract {
namespace {

constexpr double kNow = 1.7e9;  // s since 1970

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

template <typename Value>
Value value_of(tl::expected<Value, std::string> result) {
  if (!result) throw std::runtime_error("failed: " + result.error());
  if constexpr (!std::is_void_v<Value>) return std::move(*result);
}

template <typename Value>
void require_failure(const tl::expected<Value, std::string>& result, const char* what) {
  require(!result, what);
  require(!result.error().empty(), "it failed without a sentence");
}

std::uint64_t accept(World& world, const std::vector<std::string>& ids) {
  std::vector<AcceptedRequest> requests;
  for (const std::string& id : ids) requests.push_back(sample_request(id));
  return value_of(world.journal().accept(requests));
}

void finish(World& world, const std::string& id, double time = kNow,
            PlanStatus status = PlanStatus::kSolved) {
  value_of(world.journal().finish({{id, status, sample_plan(id), time}}));
}

std::vector<std::string> unfinished(World& world) {
  std::vector<std::string> ids;
  for (const JournalEntry& entry : value_of(world.journal().unfinished())) ids.push_back(entry.id);
  return ids;
}

using Ids = std::vector<std::string>;

// ---- Accepting ----

void nothing_is_there_at_first(World& world) {
  require(!value_of(world.journal().find("a")), "a stranger was found");
  require(unfinished(world).empty(), "there is something to finish");
  const JournalCounts counts = value_of(world.journal().counts());
  require(counts.unfinished == 0 && counts.finished == 0, "something was counted");
  require_failure(world.journal().record("a"), "a stranger's request was found");
  require_failure(world.journal().plan("a"), "a stranger's plan was found");
}

void what_is_accepted_is_found(World& world) {
  AcceptedRequest request = sample_request("fleet-7:order.12", 100'000);
  request.accepted_at = kNow + 0.125;
  const std::uint64_t sequence = value_of(world.journal().accept({request}));
  const auto found = value_of(world.journal().find(request.id));
  require(found.has_value(), "it was not found");
  require(*found == JournalEntry{sequence, request.id, request.content, request.accepted_at, {}},
          "something about it was changed");
  require(value_of(world.journal().record(request.id)) == request.record, "its bytes were changed");
  require(value_of(world.journal().unfinished()) == std::vector{*found}, "it is not unfinished");
  require_failure(world.journal().plan(request.id), "it has a plan");
}

void ids_are_told_apart_by_every_byte(World& world) {
  const Ids ids{"a", "A", "a ", "a.", "aa", "\xc3\xa4", "1", "01", "1.0"};
  accept(world, ids);
  for (const std::string& id : ids) {
    require(value_of(world.journal().record(id)) == sample_request(id).record,
            "one id was taken for another");
  }
  require(unfinished(world) == ids, "they are not in the order of acceptance");
}

void numbers_grow_one_by_one(World& world) {
  const std::uint64_t first = accept(world, {"a"});
  require(first > 0, "numbers begin with 1");
  const std::uint64_t batch = accept(world, {"z", "y", "x"});
  require(batch > first, "a later one has no greater number");
  for (const auto& [id, number] : {std::pair{"z", batch}, {"y", batch + 1}, {"x", batch + 2}}) {
    require(value_of(world.journal().find(id))->sequence == number, "numbers do not follow");
  }
  require(accept(world, {"b"}) > batch + 2, "a number was given out twice");
}

void unfinished_ones_come_in_the_order_of_acceptance(World& world) {
  accept(world, {"m", "c"});
  accept(world, {"z"});
  accept(world, {"a", "k"});
  finish(world, "z");
  require(unfinished(world) == Ids{"m", "c", "a", "k"}, "their order is another");
}

void a_batch_is_accepted_whole_or_not_at_all(World& world) {
  accept(world, {"a"});
  require_failure(world.journal().accept({sample_request("b"), sample_request("a")}),
                  "an id was accepted twice");
  require_failure(world.journal().accept({sample_request("c"), sample_request("c")}),
                  "an id was accepted twice in one call");
  require(unfinished(world) == Ids{"a"}, "a part of a batch was accepted");
  require(!value_of(world.journal().find("b")), "a part of a batch was accepted");
  accept(world, {"b", "c"});
  finish(world, "b");
  require_failure(world.journal().accept({sample_request("b")}), "a finished id was accepted");
}

void what_makes_no_sense_is_refused(World& world) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  require_failure(world.journal().accept({}), "nothing was accepted");
  require_failure(world.journal().accept({sample_request("")}), "no id was accepted");
  AcceptedRequest timeless = sample_request("a");
  timeless.accepted_at = kNan;
  require_failure(world.journal().accept({timeless}), "no time was accepted");
  accept(world, {"a"});
  require_failure(world.journal().finish({{"a", PlanStatus::kSolved, "{}", kNan}}),
                  "it was finished at no time");
  require(unfinished(world) == Ids{"a"}, "a refusal changed something");
}

// ---- Finishing ----

void what_is_finished_keeps_its_plan(World& world) {
  accept(world, {"a", "b"});
  const std::string plan = sample_plan("a", 1'000'000);
  value_of(world.journal().finish({{"a", PlanStatus::kInfeasible, plan, kNow + 0.5}}));
  const auto found = value_of(world.journal().find("a"));
  require(found && found->outcome, "it is not finished");
  require(*found->outcome == JournalEntry::Outcome{PlanStatus::kInfeasible, kNow + 0.5},
          "its outcome is another");
  require(found->content == sample_request("a").content, "it is not known any more what was asked");
  require(value_of(world.journal().plan("a")) == plan, "its plan was changed");
  require_failure(world.journal().record("a"), "its bytes are kept for ever");
  require(unfinished(world) == Ids{"b"}, "it is still unfinished, or another one is not");
}

void every_status_and_size_is_kept(World& world) {
  int number = 0;
  for (const PlanStatus status :
       {PlanStatus::kSolved, PlanStatus::kInfeasible, PlanStatus::kTimeout, PlanStatus::kCancelled,
        PlanStatus::kInvalid}) {
    const std::string id = "r" + std::to_string(number);
    AcceptedRequest request = sample_request(id, number == 0 ? 0 : 5);
    value_of(world.journal().accept({request}));
    require(value_of(world.journal().record(id)) == request.record, "its bytes were changed");
    const std::string plan = sample_plan(id, number == 0 ? 0 : 70'000);
    value_of(world.journal().finish({{id, status, plan, kNow}}));
    require(value_of(world.journal().find(id))->outcome->status == status, "its status is another");
    require(value_of(world.journal().plan(id)) == plan, "its plan was changed");
    ++number;
  }
}

void only_what_is_unfinished_can_be_finished(World& world) {
  accept(world, {"a"});
  require_failure(world.journal().finish({{"b", PlanStatus::kSolved, "{}", kNow}}),
                  "a stranger was finished");
  finish(world, "a");
  require_failure(world.journal().finish({{"a", PlanStatus::kCancelled, "{}", kNow + 1}}),
                  "it was finished twice");
  require(value_of(world.journal().plan("a")) == sample_plan("a"), "its plan was replaced");
}

void a_batch_is_finished_whole_or_not_at_all(World& world) {
  accept(world, {"a", "b"});
  const FinishedRequest a{"a", PlanStatus::kSolved, sample_plan("a"), kNow};
  const FinishedRequest b{"b", PlanStatus::kTimeout, sample_plan("b"), kNow};
  const FinishedRequest stranger{"c", PlanStatus::kSolved, "{}", kNow};
  require_failure(world.journal().finish({a, stranger}), "a stranger was finished with another");
  require_failure(world.journal().finish({a, a}), "one was finished twice at once");
  require(unfinished(world) == std::vector<std::string>{"a", "b"},
          "a batch was finished by halves");
  value_of(world.journal().finish({a, b}));
  require(unfinished(world).empty(), "a batch was not finished");
  require(value_of(world.journal().plan("b")) == b.plan, "a plan was changed");
}

void entries_are_finished_ones_and_others(World& world) {
  accept(world, {"b", "a", "c"});
  finish(world, "a");
  std::vector<std::string> ids;
  for (const JournalEntry& entry : value_of(world.journal().entries())) {
    ids.push_back(entry.id);
    require(entry.outcome.has_value() == (entry.id == "a"), "it is not known what is finished");
  }
  require(ids == std::vector<std::string>{"b", "a", "c"},
          "they are not in the order of acceptance");
}

// ---- Forgetting ----

void only_what_finished_before_is_forgotten(World& world) {
  accept(world, {"a", "b", "c", "d"});
  finish(world, "b", kNow);
  finish(world, "d", kNow + 1);
  finish(world, "a", kNow + 2);
  require(value_of(world.journal().forget_finished_before(kNow, 100)) == 0,
          "one was forgotten too early");
  require(value_of(world.journal().forget_finished_before(kNow + 2, 100)) == 2,
          "others were forgotten");
  require(!value_of(world.journal().find("b")) && !value_of(world.journal().find("d")),
          "the wrong ones were forgotten");
  require_failure(world.journal().plan("b"), "the plan of a forgotten one was found");
  require(value_of(world.journal().plan("a")) == sample_plan("a"), "a plan was lost");
  require(unfinished(world) == Ids{"c"}, "an unfinished one was forgotten");
  constexpr double kEver = std::numeric_limits<double>::infinity();
  require(value_of(world.journal().forget_finished_before(kEver, 100)) == 1 &&
              unfinished(world) == Ids{"c"},
          "an unfinished one was forgotten");
}

void a_few_are_forgotten_at_a_time(World& world) {
  accept(world, {"a", "b", "c", "d", "e"});
  double time = kNow;
  for (const char* id : {"c", "a", "e", "b", "d"}) finish(world, id, time++);
  require(value_of(world.journal().forget_finished_before(time, 0)) == 0, "more were forgotten");
  require(value_of(world.journal().forget_finished_before(time, 2)) == 2, "more were forgotten");
  require(!value_of(world.journal().find("c")) && !value_of(world.journal().find("a")),
          "those that finished first were not the first");
  require(value_of(world.journal().forget_finished_before(time, 2)) == 2, "they were not");
  require(value_of(world.journal().forget_finished_before(time, 2)) == 1, "they were not");
  require(value_of(world.journal().forget_finished_before(time, 2)) == 0, "there are more");
}

void a_forgotten_id_is_free_again(World& world) {
  const std::uint64_t first = accept(world, {"a"});
  finish(world, "a");
  value_of(world.journal().forget_finished_before(kNow + 1, 1));
  world.restart();
  require(accept(world, {"a"}) > first, "a number was given out twice");
  require(unfinished(world) == Ids{"a"}, "it was not accepted");
}

void counts_say_what_is_there(World& world) {
  const auto are = [&](std::uint64_t open, std::uint64_t done) {
    const JournalCounts counts = value_of(world.journal().counts());
    require(counts.unfinished == open && counts.finished == done, "counts are wrong");
    return counts.bytes;
  };
  are(0, 0);
  value_of(world.journal().accept({sample_request("a", 100'000), sample_request("b")}));
  require(are(2, 0) >= 100'000, "bytes are not counted");
  finish(world, "a");
  are(1, 1);
  finish(world, "b");
  are(0, 2);
  value_of(world.journal().forget_finished_before(kNow + 1, 1));
  are(0, 1);
}

// ---- Lasting ----

void everything_outlives_a_restart(World& world) {
  accept(world, {"a", "b", "c", "d"});
  finish(world, "b", kNow, PlanStatus::kTimeout);
  finish(world, "c", kNow - 100);
  value_of(world.journal().forget_finished_before(kNow, 9));
  const auto before = value_of(world.journal().find("b"));
  const JournalCounts counts = value_of(world.journal().counts());
  for (int i = 0; i < 3; ++i) {
    world.restart();
    require(unfinished(world) == Ids{"a", "d"}, "unfinished ones were lost, or came back");
    require(value_of(world.journal().record("d")) == sample_request("d").record,
            "bytes were changed");
    require(value_of(world.journal().find("b")) == before, "an outcome was lost");
    require(value_of(world.journal().plan("b")) == sample_plan("b"), "a plan was changed");
    require(!value_of(world.journal().find("c")), "a forgotten one came back");
    require(value_of(world.journal().counts()) == counts, "counts are others");
  }
}

void a_full_disk_refuses_and_loses_nothing(World& world) {
  accept(world, {"a", "b", "old"});
  finish(world, "old", kNow - 100);
  world.set_full(true);
  for (int i = 0; i < 3; ++i) {
    require_failure(world.journal().accept({sample_request("c", 100'000)}),
                    "something was accepted that does not fit");
    require_failure(world.journal().finish({{"a", PlanStatus::kSolved, sample_plan("a"), kNow}}),
                    "something was finished that does not fit");
    require_failure(world.journal().forget_finished_before(kNow, 9), "it was forgotten");
    require(unfinished(world) == Ids{"a", "b"}, "what failed changed something");
    require(value_of(world.journal().record("a")) == sample_request("a").record,
            "what was there cannot be read");
    require(value_of(world.journal().plan("old")) == sample_plan("old"),
            "what was there cannot be read");
  }
  world.set_full(false);
  accept(world, {"c"});
  finish(world, "a");
  require(value_of(world.journal().forget_finished_before(kNow, 9)) == 1, "it was not forgotten");
  world.restart();
  require(unfinished(world) == Ids{"b", "c"}, "there is room again, and it was not used");
  require(value_of(world.journal().plan("a")) == sample_plan("a"), "a plan was changed");
}

// Runs a check that says what is broken by throwing.
Check check(std::string name, void (*run)(World&)) {
  return {std::move(name), [run](World& world) -> Breach {
            try {
              run(world);
            } catch (const std::runtime_error& found) {
              return found.what();
            }
            return {};
          }};
}

std::uint64_t seed_of(const std::string& id, std::uint64_t salt) {
  for (const char c : id) salt = 31 * salt + static_cast<unsigned char>(c);
  return salt;
}

}  // namespace

const std::vector<Check>& checks() {
  static const std::vector<Check> all{
      check("NothingIsThereAtFirst", nothing_is_there_at_first),
      check("WhatIsAcceptedIsFound", what_is_accepted_is_found),
      check("IdsAreToldApartByEveryByte", ids_are_told_apart_by_every_byte),
      check("NumbersGrowOneByOne", numbers_grow_one_by_one),
      check("UnfinishedOnesComeInTheOrderOfAcceptance",
            unfinished_ones_come_in_the_order_of_acceptance),
      check("ABatchIsAcceptedWholeOrNotAtAll", a_batch_is_accepted_whole_or_not_at_all),
      check("WhatMakesNoSenseIsRefused", what_makes_no_sense_is_refused),
      check("WhatIsFinishedKeepsItsPlan", what_is_finished_keeps_its_plan),
      check("EveryStatusAndSizeIsKept", every_status_and_size_is_kept),
      check("OnlyWhatIsUnfinishedCanBeFinished", only_what_is_unfinished_can_be_finished),
      check("ABatchIsFinishedWholeOrNotAtAll", a_batch_is_finished_whole_or_not_at_all),
      check("EntriesAreFinishedOnesAndOthers", entries_are_finished_ones_and_others),
      check("OnlyWhatFinishedBeforeIsForgotten", only_what_finished_before_is_forgotten),
      check("AFewAreForgottenAtATime", a_few_are_forgotten_at_a_time),
      check("AForgottenIdIsFreeAgain", a_forgotten_id_is_free_again),
      check("CountsSayWhatIsThere", counts_say_what_is_there),
      check("EverythingOutlivesARestart", everything_outlives_a_restart),
      check("AFullDiskRefusesAndLosesNothing", a_full_disk_refuses_and_loses_nothing),
  };
  return all;
}

const Check& check_named(const std::string& name) {
  return *std::ranges::find(checks(), name, &Check::name);
}

AcceptedRequest sample_request(const std::string& id, std::size_t size) {
  RandomStream random(seed_of(id, 1));
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  const RequestHash hash = hash_of(bytes);
  return {id, hash, std::move(bytes), kNow};
}

std::string sample_plan(const std::string& id, std::size_t size) {
  RandomStream random(seed_of(id, 2));
  std::string plan(size, '\0');
  for (char& c : plan) c = static_cast<char>(random.next());
  return plan;
}

}  // namespace accord::journal_contract
