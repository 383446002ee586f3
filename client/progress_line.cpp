#include "client/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <string>

namespace accord {
namespace {

constexpr const char* kClearLine = "\r\033[K";

std::string words(const Progress& progress, std::size_t robots) {
  switch (progress.phase) {
    case Progress::Phase::kInitialPaths:
      return fmt::format("paths of single robots: {} of {}", progress.robots_planned, robots);
    case Progress::Phase::kConflicts:
      return fmt::format("conflicts: {} found, {} resolved, round {}", progress.conflicts_found,
                         progress.conflicts_resolved, progress.rounds);
    case Progress::Phase::kProof:
      return "proving the plan";
  }
  return {};
}

}  // namespace

ProgressLine::ProgressLine(std::size_t robots)
    : visible_(isatty(STDERR_FILENO) != 0),
      robots_(robots),
      begin_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  if (visible_) std::cerr << kClearLine << std::flush;
}

void ProgressLine::show(const Progress& progress) {
  if (!visible_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  std::cerr << kClearLine << fmt::format("{:6.1f} s  {}", elapsed.count(), words(progress, robots_))
            << std::flush;
}

}  // namespace accord
