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
  std::size_t conflicts_resolved;  // committed resolutions
  std::size_t rounds;
};

// Called from the thread that plans.
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace accord
