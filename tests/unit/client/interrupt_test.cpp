#include "client/interrupt.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "client/exit_code.h"

namespace accord {
namespace {

const auto kEnds = testing::ExitedWithCode(static_cast<int>(ExitCode::kTimeout));
const auto kLives = testing::ExitedWithCode(0);

// Each runs in a process of its own: handlers and the flag are the process's.
class Signals : public testing::TestWithParam<int> {
 protected:
  // The tests themselves may run under nohup.
  Signals() { std::signal(SIGHUP, SIG_DFL); }
};

TEST_P(Signals, EndTheProgramWithAWord) {
  EXPECT_EXIT(
      {
        end_on_signals();
        raise(GetParam());
      },
      kEnds, "cancelled: ended by SIG(INT|TERM|HUP)");
}

TEST_P(Signals, RaiseTheFlagWhereSomeoneLooksAtIt) {
  EXPECT_EXIT(
      {
        end_on_signals();
        const CancelOnSignal on_signal;
        if (on_signal.cancelled()) std::exit(1);
        raise(GetParam());
        std::exit(on_signal.cancelled() ? 0 : 1);
      },
      kLives, "");
}

TEST_P(Signals, EndTheProgramWhereTheyComeTwice) {
  EXPECT_EXIT(
      {
        end_on_signals();
        const CancelOnSignal on_signal;
        raise(GetParam());
        raise(GetParam());
      },
      kEnds, "cancelled");
}

TEST_P(Signals, EndTheProgramWhereNobodyLooksAnyMore) {
  EXPECT_EXIT(
      {
        end_on_signals();
        { const CancelOnSignal on_signal; }
        raise(GetParam());
      },
      kEnds, "cancelled");
}

TEST_P(Signals, WaitWhereTheyAreHeld) {
  EXPECT_EXIT(
      {
        end_on_signals();
        {
          const HeldSignals held;
          raise(GetParam());
          std::fputs("whole;", stderr);
        }
      },
      kEnds, "whole;cancelled");
}

INSTANTIATE_TEST_SUITE_P(All, Signals, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(IgnoredSignals, StaySoUnderNohup) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        end_on_signals();
        raise(SIGHUP);
        std::exit(0);
      },
      kLives, "");
}

TEST(IgnoredSignals, CountInTheBackgroundOfAShell) {
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        end_on_signals();
        raise(SIGINT);
      },
      kEnds, "SIGINT");
}

}  // namespace
}  // namespace accord
