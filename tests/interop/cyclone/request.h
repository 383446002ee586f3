// One request, and what has been heard of it.
#pragma once

#include <stdbool.h>

#include "endpoints.h"
#include "fleet.h"
#include "gathered_plan.h"

struct request {
  // Whole, where this program submits it; else only its id is set.
  accord_fleet_PlanRequest submission;
  bool is_submitted_here;
  bool is_to_be_cancelled;

  bool is_accepted;  // a reply or a status said so
  bool has_reply;
  bool is_refused;  // a reply said so
  bool is_odd;      // something came that cannot be
  accord_fleet_PlanStatus last;
  struct gathered_plan plan;
};

// Puts the question whose answer is missing: accept it, cancel it, say it again. Whatever was lost
// or missed, to ask again is right: the same request twice is one request, and what is finished can
// be said again. False: DDS does not take it.
bool ask(const struct endpoints* fleet, const struct request* request);

// Takes all that has come of a request. True: something about the request was among it. A line on
// stderr each.
bool hear(const struct endpoints* fleet, struct request* request);
