#include <stdio.h>
#include <string.h>

#include "request.h"

static void on_reply(struct request* request, const accord_fleet_RequestReply* reply) {
  fprintf(stderr, "reply: accepted %d, reason %u, field \"%s\", \"%s\"\n", reply->accepted,
          reply->reason, reply->field, reply->text);
  request->has_reply = true;
  request->is_accepted = reply->accepted;
  // A service without a journal was started anew: it is asked again.
  const bool is_forgotten = reply->reason == accord_fleet_REASON_UNKNOWN_REQUEST;
  request->is_refused = !reply->accepted && !(is_forgotten && request->is_submitted_here);
}

static void on_status(struct request* request, const accord_fleet_PlanStatus* status) {
  fprintf(stderr, "status: phase %u, %.1f %%, %llu of %llu conflicts, %.3f s, cost %.3f s\n",
          status->phase, status->per_cent, (unsigned long long)status->conflicts_resolved,
          (unsigned long long)status->conflicts_found, status->elapsed, status->best_cost);
  const accord_fleet_PlanStatus* last = &request->last;
  const bool goes_on = status->phase >= last->phase && status->per_cent >= last->per_cent &&
                       status->conflicts_found >= last->conflicts_found &&
                       status->elapsed >= last->elapsed;
  const bool is_over = status->phase == accord_fleet_PHASE_FINISHED;
  if (!goes_on || status->best_cost < 0 || is_over != (status->per_cent == 100)) {
    fputs("that status goes back, or says what cannot be\n", stderr);
    request->is_odd = true;
  }
  request->is_accepted = true;
  request->last = *status;
  request->last.request_id = NULL;  // that is the sample's
}

// True: something about the request has come.
static bool take_replies(const struct endpoints* fleet, struct request* request) {
  bool any = false;
  accord_fleet_RequestReply* reply = accord_fleet_RequestReply__alloc();
  while (take(fleet->replies, reply)) {
    if (strcmp(reply->request_id, request->submission.request_id) != 0) continue;
    on_reply(request, reply);
    any = true;
  }
  accord_fleet_RequestReply_free(reply, DDS_FREE_ALL);
  return any;
}

static bool take_statuses(const struct endpoints* fleet, struct request* request) {
  bool any = false;
  accord_fleet_PlanStatus* status = accord_fleet_PlanStatus__alloc();
  while (take(fleet->statuses, status)) {
    if (strcmp(status->request_id, request->submission.request_id) != 0) continue;
    on_status(request, status);
    any = true;
  }
  accord_fleet_PlanStatus_free(status, DDS_FREE_ALL);
  return any;
}

static bool take_plans(const struct endpoints* fleet, struct request* request) {
  bool any = false;
  accord_fleet_Plan* outcome = accord_fleet_Plan__alloc();
  while (take(fleet->plans, outcome)) {
    if (strcmp(outcome->request_id, request->submission.request_id) != 0) continue;
    fprintf(stderr, "plan: version %u, status %u\n", outcome->version, outcome->status);
    gather_outcome(&request->plan, outcome);
    outcome = accord_fleet_Plan__alloc();
    any = true;
  }
  accord_fleet_Plan_free(outcome, DDS_FREE_ALL);
  return any;
}

static bool take_robot_plans(const struct endpoints* fleet, struct request* request) {
  bool any = false;
  accord_fleet_RobotPlan* piece = accord_fleet_RobotPlan__alloc();
  while (take(fleet->robot_plans, piece)) {
    if (strcmp(piece->request_id, request->submission.request_id) != 0) continue;
    request->is_odd |= !gather_piece(&request->plan, piece);
    piece = accord_fleet_RobotPlan__alloc();
    any = true;
  }
  accord_fleet_RobotPlan_free(piece, DDS_FREE_ALL);
  return any;
}

bool hear(const struct endpoints* fleet, struct request* request) {
  bool any = take_replies(fleet, request);
  any |= take_statuses(fleet, request);
  any |= take_plans(fleet, request);
  any |= take_robot_plans(fleet, request);
  return any;
}
