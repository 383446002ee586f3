// What a request desk counts of what it does, for whoever watches over the service.
// A plain value.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "common/model/plan.h"
#include "common/model/request_state.h"
#include "common/runtime/time_histogram.h"

namespace accord {

struct DeskCounters {
  // Requests.
  std::uint64_t accepted = 0;
  std::uint64_t restored = 0;                   // unfinished ones, from the journal
  std::map<Rejection, std::uint64_t> rejected;  // questions after what nobody knows included
  std::map<PlanStatus, std::uint64_t> finished;
  TimeHistogram queued;                          // from acceptance until planning was begun
  std::map<PlanStatus, TimeHistogram> planning;  // from then until it was done, proof included
  TimeHistogram proof;                           // of plans that were proved

  // Planning, as far as it has told.
  std::uint64_t conflicts_found = 0;
  std::uint64_t conflicts_resolved = 0;
  std::uint64_t rounds = 0;
  // Told when a request's planning is done. But for the robots' own first paths.
  std::uint64_t subproblems_exhausted = 0;           // no level has solved them
  std::uint64_t subproblems_set_aside = 0;           // solved, but a larger one was tried instead
  std::map<std::string, std::uint64_t> resolutions;  // that were committed, by solver

  // The journal.
  std::uint64_t writes = 0;  // that have gone well
  std::uint64_t failed_writes = 0;
};

}  // namespace accord
