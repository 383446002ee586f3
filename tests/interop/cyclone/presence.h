// Who is there: what the service says of itself and its workers, of no request, to whoever comes
// later as well.
#pragma once

#include <stdbool.h>

#include "endpoints.h"

struct presence {
  bool service;  // one that accepts requests, which has found our readers, since it was heard
  bool worker;   // one that is welcome to it
};

// Takes all that has come, with a line on stderr each.
void hear_presence(const struct endpoints* fleet, struct presence* presence);

// Waits until both have been heard of. False, with a line on stderr: not by `end`.
bool watch(const struct endpoints* fleet, dds_time_t end);
