// Makes a timed path shorter after it was found: cuts corners, then searches again on the complete
// graph of its own places and the points between them. A path found on samples wanders; this takes
// most of it out.
#pragma once

#include "common/planning/subproblem.h"
#include "worker/safe_interval_search.h"

namespace accord {

// Replaces `path` where the new search arrives earlier. Never makes it worse; leaves it at `stop`.
// The request is the one that the path answers; only its times are used.
void shorten(Team& team, const SearchRequest& request, Trajectory& path,
             const std::atomic<bool>& stop, Effort& effort);

}  // namespace accord
