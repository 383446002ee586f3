#include "client/watch/screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "client/watch/change_lines.h"
#include "client/watch/live_screen.h"
#include "tests/unit/client/watch/news.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using namespace watch_news;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

WatchedFleet busy_fleet() {
  WatchedFleet fleet;
  ServiceStatus service = service_of(1, 0, 1);
  service.uptime = 3600;
  fleet.take(service, 0s);
  RequestState state = state_of("a", RequestPhase::kConflicts, 1);
  state.robots = state.robots_planned = 16;
  state.conflicts_found = 24;
  state.conflicts_resolved = 7;
  state.rounds = 5;
  fleet.take(state, 0s);
  fleet.take(worker_of(1), 0s);
  return fleet;
}

TEST(Screen, ShowsServiceRequestsAndWorkers) {
  EXPECT_THAT(screen_of(busy_fleet(), 0s, {}),
              ElementsAre("host  version   uptime  workers  queued  planning  finished  accepting",
                          "base  1.2.3    1:00:00        1       0         1         0        yes",
                          "", "request  phase      found  resolved  round  elapsed",
                          "a        conflicts     24         7      5    1.0 s",  //
                          "", "worker            host  process  threads  busy  standing",
                          "0000000000000001  box         1        2     0  welcome"));
}

TEST(Screen, SaysWhatIsNotThere) {
  WatchedFleet fleet;
  EXPECT_THAT(screen_of(fleet, 0s, {}), ElementsAre("no service has answered yet"));
  fleet.take(service_of(0, 0, 0), 0s);
  EXPECT_THAT(screen_of(fleet, 0s, {}), Contains("no requests"));
  EXPECT_THAT(screen_of(fleet, 0s, {}), Contains("no workers"));
  fleet.set_present(true, 0s);
  fleet.set_present(false, 1s);
  EXPECT_THAT(screen_of(fleet, 13s, {}), Contains("no service for 12 s; what it last said:"));
  ServiceStatus ending = service_of(0, 0, 0);
  ending.accepting = false;
  fleet.take(ending, 14s);
  EXPECT_THAT(screen_of(fleet, 14s, {})[0], HasSubstr("takes no more requests"));
}

TEST(Screen, FitsIntoAnyTerminal) {
  WatchedFleet fleet = busy_fleet();
  for (int i = 0; i < 30; ++i) {
    fleet.take(state_of("request-" + std::to_string(i), RequestPhase::kQueued, 0), 0s);
    fleet.take(worker_of(static_cast<std::uint64_t>(i) + 2), 0s);
  }
  for (std::size_t height = 1; height < 80; ++height) {
    for (const std::size_t width : {1U, 10U, 40U, 80U, 200U}) {
      const auto lines = screen_of(fleet, 0s, {width, height});
      EXPECT_LE(lines.size(), height);
      for (const std::string& line : lines) EXPECT_LE(line.size(), width);
    }
  }
  EXPECT_EQ(screen_of(fleet, 0s, {80, 24}).size(), 24U) << "and uses it";
  EXPECT_EQ(screen_of(fleet, 0s, {}).size(), 2U + 1 + 32 + 1 + 32);
}

TEST(Screen, SaysHowManyRowsAreLeftOut) {
  WatchedFleet fleet = busy_fleet();
  for (int i = 0; i < 29; ++i) {
    fleet.take(state_of("request-" + std::to_string(i), RequestPhase::kQueued, 0), 0s);
  }
  // 24 lines: 2 of the service, 2 empty ones, 2 of the worker; 18 for requests, heading and end
  // among them.
  EXPECT_THAT(screen_of(fleet, 0s, {80, 24}), Contains("... and 14 more"));
}

TEST(Screen, LeavesLostWorkersOutOfTheirList) {
  WatchedFleet fleet = busy_fleet();
  fleet.take(worker_of(1, "lost"), 5s);
  fleet.take(worker_of(2, "refused"), 5s);
  EXPECT_EQ(rows_of_workers(fleet).size(), 1U);
  EXPECT_EQ(screen_of(fleet, 5s, {}).size(), 9U) << "watched, it is shown";
}

TEST(LiveScreen, IsDrawnInItsPlaceAndLeavesTheTerminalAsItWas) {
  std::ostringstream terminal;
  {
    LiveScreen screen(terminal);
    screen.draw({"one", "two"});
    screen.draw({"three"});
    EXPECT_THAT(terminal.str(), EndsWith("\033[Hthree\033[K\033[J"));
  }
  EXPECT_THAT(terminal.str(), StartsWith("\033[?1049h\033[?25l"));
  EXPECT_THAT(terminal.str(), EndsWith("\033[?25h\033[?1049lthree\n")) << "the last one stays";
}

TEST(ChangeLines, AreOneEach) {
  const WatchedFleet fleet = busy_fleet();
  std::ostringstream text;
  ChangeLines(text, ChangeLines::As::kText).write_all(fleet, 0s);
  EXPECT_EQ(text.str(),
            "service present=true host=base process=7 version=1.2.3 uptime=3600.000 workers=1 "
            "threads=0 queued=0 planning=1 finished=0 accepting=true\n"
            "worker worker=0000000000000001 host=box process=1 threads=2 busy=0 standing=welcome\n"
            "request id=a phase=conflicts ahead=0 robots=16 robots_planned=16 conflicts_found=24 "
            "conflicts_resolved=7 rounds=5 elapsed=1.000\n");
  std::ostringstream json;
  ChangeLines(json, ChangeLines::As::kJson).write(*fleet.service(), 0s, "noon");
  EXPECT_THAT(json.str(), StartsWith(R"({"kind": "service", "time": "noon", "present": true,)"));
  EXPECT_THAT(json.str(), EndsWith("}\n"));
}

TEST(ChangeLines, HaveTheHourInUtc) {
  EXPECT_THAT(utc_now(), testing::MatchesRegex("....-..-..T..:..:..[.]...Z"));
}

}  // namespace
}  // namespace accord
