#include "client/progress_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace accord {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

std::string shown(const Progress& progress) {
  std::ostringstream terminal;
  ProgressLine line(terminal, 12);
  line.show(progress);
  return terminal.str();
}

TEST(ProgressLine, SaysHowFarEachPhaseIs) {
  EXPECT_THAT(shown({Progress::Phase::kInitialPaths, 6, 0, 0, 0}),
              HasSubstr("5 %, paths of single robots: 6 of 12"));
  EXPECT_THAT(shown({Progress::Phase::kConflicts, 12, 24, 7, 5, 12, 81.44}),
              HasSubstr("52 %, conflicts: 24 found, 7 resolutions, round 5, sum of costs 81.4 s"));
  EXPECT_THAT(shown({Progress::Phase::kProof, 12, 24, 7, 5}), HasSubstr("95 %, proving"));
}

TEST(ProgressLine, NeverSaysThatThereIsMoreToDoThanBefore) {
  const Progress half{Progress::Phase::kConflicts, 12, 4, 1, 1, 2};
  const Progress less{Progress::Phase::kConflicts, 12, 8, 1, 1, 6};
  std::ostringstream terminal;
  {
    ProgressLine line(terminal, 12);
    line.show(half);
    line.show(less);
    EXPECT_THAT(terminal.str(), HasSubstr("52 %, conflicts: 8 found"));
  }
}

TEST(ProgressLine, SaysHowFarARequestToAServiceIs) {
  RequestState state;
  state.robots = 12;
  state.ahead = 1;
  EXPECT_EQ(in_words(state), "accepted, 1 request before it");
  state.phase = RequestPhase::kConflicts;
  state.conflicts_found = 24;
  state.conflicts_resolved = 7;
  state.rounds = 5;
  state.per_cent = 41.3;
  state.best_cost = 81.44;
  EXPECT_EQ(in_words(state),
            "41 %, conflicts: 24 found, 7 resolutions, round 5, sum of costs 81.4 s");
  state.phase = RequestPhase::kFinished;
  EXPECT_EQ(in_words(state), "finished");
}

TEST(ProgressLine, StaysOnOneLineAndLeavesItEmpty) {
  std::ostringstream terminal;
  {
    ProgressLine line(terminal, 2);
    line.show({Progress::Phase::kInitialPaths, 1, 0, 0, 0});
    line.show({Progress::Phase::kProof, 2, 0, 0, 0});
  }
  EXPECT_EQ(terminal.str().find('\n'), std::string::npos);
  EXPECT_THAT(terminal.str(), EndsWith("\r\033[K"));
}

TEST(ProgressLine, WritesNothingWhereNothingWasShown) {
  std::ostringstream terminal;
  { const ProgressLine line(terminal, 2); }
  EXPECT_EQ(terminal.str(), "");
}

}  // namespace
}  // namespace accord
