// How far a request has come, for people who wait.
#pragma once

#include <cstddef>
#include <functional>

namespace accord {

struct Progress {
  enum class Phase { kInitialPaths, kConflicts, kProof };
  Phase phase;
  std::size_t robots_planned;      // initial paths found so far
  std::size_t conflicts_found;     // so far, over all rounds
  std::size_t conflicts_resolved;  // committed resolutions; one may end many conflicts
  std::size_t rounds;
  std::size_t conflicts_left = 0;  // of those found, the ones that are still there
  double sum_of_costs = 0;         // s, of the paths as they stand; 0: not all robots have one yet
};

// How much of the work is done, 0 to 100, as well as can be told before it is: 10 per cent are the
// initial paths, 85 the conflicts, by the share of those found that are gone, 5 the proof. What
// conflicts are still to be found nobody knows, so it may fall; who shows it keeps the highest.
// (On eleven of scenes/, of the time that conflicts took this was off by 10 per cent on average;
// the share of the schedule's time that is free of them by 22.)
double per_cent(const Progress& progress, std::size_t robots);

// Called from the thread that plans.
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace accord
