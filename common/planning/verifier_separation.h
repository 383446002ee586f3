// How close a proved plan's robots come to each other and to obstacles: lower bounds over all
// instants. Internal to the verifier.
#pragma once

#include <optional>

#include "common/planning/verifier.h"
#include "common/planning/verifier_slabs.h"
#include "common/planning/verifier_subject.h"

namespace accord::verification {

// Separations from here on (m) are of no interest.
inline constexpr double kSeparationCutoff = 1.0;

// The smallest separation of two robots at any instant; nullopt if none is below the cutoff.
// `sampled` bounds it from above (PairsResult::sampled_separation). Discs and balls are solved in
// closed form, others by bisecting their motions within a bounded number of distance queries, so
// that the bound may lie below the true value, but never above and never below the clearance.
// Requires: the plan is proved. The same result for any number of threads.
std::optional<Separation> robots_separation(const Subject& subject, const TimeSlabs& slabs,
                                            double sampled, unsigned threads);

// The same for robots and obstacles.
std::optional<Separation> obstacles_separation(const Subject& subject, unsigned threads);

}  // namespace accord::verification
