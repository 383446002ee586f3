// All pairs of robots against each other, continuously, from 0 to the end of time. Internal to the
// verifier.
#pragma once

#include <optional>

#include "common/planning/verifier.h"
#include "common/planning/verifier_slabs.h"
#include "common/planning/verifier_subject.h"

namespace accord::verification {

struct PairsResult {
  std::optional<Violation> violation;  // the earliest; the lowest robots where several are
  // The smallest distance between two robots that was met at the slabs' beginnings, at most
  // kSeparationCutoff: a bound from above on the smallest there is. The cutoff unless `sample`.
  double sampled_separation;
};

// The same result for any number of threads.
PairsResult check_pairs(const Subject& subject, const TimeSlabs& slabs, unsigned threads,
                        bool sample);

}  // namespace accord::verification
