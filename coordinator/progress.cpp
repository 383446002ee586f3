#include "coordinator/progress.h"

#include <algorithm>

namespace accord {
namespace {

// Per cent of the work.
constexpr double kInitialPaths = 10;
constexpr double kConflicts = 85;

double share(std::size_t part, std::size_t whole) {
  if (whole == 0) return 0;
  return std::min(1.0, static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

double per_cent(const Progress& progress, std::size_t robots) {
  switch (progress.phase) {
    case Progress::Phase::kInitialPaths:
      return kInitialPaths * share(progress.robots_planned, robots);
    case Progress::Phase::kConflicts: {
      const std::size_t gone =
          progress.conflicts_found - std::min(progress.conflicts_left, progress.conflicts_found);
      return kInitialPaths + kConflicts * share(gone, progress.conflicts_found);
    }
    case Progress::Phase::kProof:
      return kInitialPaths + kConflicts;
  }
  return 0;
}

}  // namespace accord
