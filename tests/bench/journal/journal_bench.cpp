// What it takes to have requests and plans on disk.
//
//   journal_bench FOLDER      on whose disk
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "coordinator/journal/sqlite_journal.h"

namespace {

using namespace accord;

std::vector<AcceptedRequest> batch_of(std::size_t count, std::size_t bytes) {
  static int number = 0;
  std::vector<AcceptedRequest> batch;
  for (std::size_t i = 0; i < count; ++i) {
    const Bytes request(bytes, static_cast<std::uint8_t>(number));
    batch.push_back({std::to_string(number++), hash_of(request), request, 0});
  }
  return batch;
}

void finish(Journal& journal, const std::string& id, const std::string& plan, double time) {
  const auto done = journal.finish({{id, PlanStatus::kSolved, plan, time}});
  if (!done) std::printf("%s\n", done.error().c_str());
}

void report(const char* what, std::vector<double> milliseconds) {
  std::ranges::sort(milliseconds);
  const auto at = [&](double share) {
    return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size()))];
  };
  std::printf("%-34s median %7.2f ms, p99 %7.2f ms, most %7.2f ms\n", what, at(0.5), at(0.99),
              milliseconds.back());
}

double milliseconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const auto spent = std::chrono::steady_clock::now() - begin;
  return std::chrono::duration<double, std::milli>(spent).count();
}

void accept(Journal& journal, const char* what, std::size_t count, std::size_t bytes, int times) {
  std::vector<double> all;
  for (int i = 0; i < times; ++i) {
    const auto batch = batch_of(count, bytes);
    all.push_back(milliseconds_of([&] { journal.accept(batch).value(); }));
  }
  report(what, std::move(all));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto path = std::filesystem::path(argv[1]) / "journal_bench.db";
  std::filesystem::remove(path);
  auto journal = std::move(SqliteJournal::open(path).value());
  accept(*journal, "accept 1 of 4 KiB", 1, 4'096, 1'000);
  accept(*journal, "accept 64 of 4 KiB", 64, 4'096, 100);
  accept(*journal, "accept 1 of 200 KB", 1, 200'000, 200);
  accept(*journal, "accept 64 of 200 KB", 64, 200'000, 20);
  accept(*journal, "accept 1 of 64 MB", 1, 64'000'000, 3);

  const auto unfinished = journal->unfinished().value();
  std::vector<double> finds;
  for (const JournalEntry& entry : unfinished) {
    finds.push_back(milliseconds_of([&] { journal->find(entry.id).value(); }));
  }
  report("find", std::move(finds));
  std::vector<double> finishes;
  const std::string plan(1'000'000, 'x');
  for (std::size_t i = 0; i < 300; ++i) {
    finishes.push_back(milliseconds_of([&] { finish(*journal, unfinished[i].id, plan, 0); }));
  }
  report("finish, a plan of 1 MB", std::move(finishes));
  std::vector<double> forgets;
  for (int i = 0; i < 100; ++i) {
    forgets.push_back(milliseconds_of([&] { journal->forget_finished_before(1, 2).value(); }));
  }
  report("forget 2 of these", std::move(forgets));
  const std::string large(100'000'000, 'x');
  finish(*journal, unfinished.back().id, large, 2);
  std::printf("forget one of 100 MB               %.2f ms\n",
              milliseconds_of([&] { journal->forget_finished_before(3, 1000).value(); }));
  journal.reset();
  std::printf("open                               %.2f ms\n",
              milliseconds_of([&] { journal = std::move(SqliteJournal::open(path).value()); }));
  journal.reset();
  std::filesystem::remove(path);
}
