// Who is there: what the service says of itself and its workers, of no request, to whoever comes
// later as well.
#pragma once

#include <stdbool.h>

#include "endpoints.h"

// A line on stderr for all that is said, until a service that accepts requests and a worker that it
// welcomes have been heard of. False: not by `end`.
bool watch(const struct endpoints* fleet, dds_time_t end);
