#include "client/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "client/counted.h"

namespace accord {
namespace {

constexpr const char* kClearLine = "\r\033[K";

std::string words(const Progress& progress, std::size_t robots) {
  switch (progress.phase) {
    case Progress::Phase::kInitialPaths:
      return fmt::format("paths of single robots: {} of {}", progress.robots_planned, robots);
    case Progress::Phase::kConflicts:
      return fmt::format("conflicts: {} found, {}, round {}, sum of costs {:.1f} s",
                         progress.conflicts_found,
                         counted(progress.conflicts_resolved, "resolution"), progress.rounds,
                         progress.sum_of_costs);
    case Progress::Phase::kProof:
      return "proving the plan";
  }
  return {};
}

std::string after_per_cent(double per_cent, const std::string& words) {
  return fmt::format("{:.0f} %, {}", per_cent, words);
}

}  // namespace

std::string in_words(const RequestState& state) {
  Progress progress{Progress::Phase::kInitialPaths,
                    state.robots_planned,
                    state.conflicts_found,
                    state.conflicts_resolved,
                    state.rounds,
                    0,
                    state.best_cost};
  switch (state.phase) {
    case RequestPhase::kQueued:
      return fmt::format("accepted, {} before it", counted(state.ahead, "request"));
    case RequestPhase::kInitialPaths:
      break;
    case RequestPhase::kConflicts:
      progress.phase = Progress::Phase::kConflicts;
      break;
    case RequestPhase::kProof:
      progress.phase = Progress::Phase::kProof;
      break;
    case RequestPhase::kFinished:
      return "finished";
  }
  return after_per_cent(state.per_cent, words(progress, state.robots));
}

bool stderr_is_a_terminal() {
  return isatty(STDERR_FILENO) != 0;
}

ProgressLine::ProgressLine(std::ostream& terminal, std::size_t robots)
    : terminal_(terminal), robots_(robots), begin_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (shown_) terminal_ << kClearLine << std::flush;
}

void ProgressLine::show(const Progress& progress) {
  per_cent_ = std::max(per_cent_, per_cent(progress, robots_));
  show(after_per_cent(per_cent_, words(progress, robots_)));
}

void ProgressLine::show(const RequestState& state) {
  show(in_words(state));
}

void ProgressLine::show(const std::string& words) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  terminal_ << kClearLine << fmt::format("{:6.1f} s  {}", elapsed.count(), words) << std::flush;
  shown_ = true;
}

}  // namespace accord
