// What the coordinator's log says, with the fields that tell what each line is about: `request`,
// `task`, `worker` (docs/operations.md#log).
// Thread safe.
#pragma once

#include <string>

#include "common/transport/fleet/fleet_messages.h"
#include "coordinator/dispatch/board_note.h"
#include "coordinator/service/planning_threads.h"

namespace accord {

void log_note(const BoardNote& note);
void log_accepted(const std::string& request);
void log_planned(const PlanningThreads::Planned& planned);
// What fleet managers are told, where it is about a request's begin or end.
void log_news(const FleetNews& news);
// What fleet managers ask.
void log_request(const FleetRequest& request);

}  // namespace accord
