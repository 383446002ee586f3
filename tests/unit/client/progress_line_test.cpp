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
  EXPECT_THAT(shown({Progress::Phase::kInitialPaths, 5, 0, 0, 0}),
              HasSubstr("paths of single robots: 5 of 12"));
  EXPECT_THAT(shown({Progress::Phase::kConflicts, 12, 24, 7, 5}),
              HasSubstr("conflicts: 24 found, 7 resolutions, round 5"));
  EXPECT_THAT(shown({Progress::Phase::kProof, 12, 24, 7, 5}), HasSubstr("proving"));
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
  EXPECT_EQ(in_words(state), "conflicts: 24 found, 7 resolutions, round 5");
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
