#include <stdio.h>
#include <string.h>

#include "request.h"

static void on_reply(struct request* request, const accord_fleet_RequestReply* reply) {
  fprintf(stderr, "reply: accepted %d, reason %u, field \"%s\", \"%s\"\n", reply->accepted,
          reply->reason, reply->field, reply->text);
  request->is_accepted = reply->accepted;
  request->is_refused = !reply->accepted;
}

static void on_status(struct request* request, const accord_fleet_PlanStatus* status) {
  fprintf(stderr, "status: phase %u, %.1f %%, %llu of %llu conflicts, %.3f s, cost %.3f s\n",
          status->phase, status->per_cent, (unsigned long long)status->conflicts_resolved,
          (unsigned long long)status->conflicts_found, status->elapsed, status->best_cost);
  const accord_fleet_PlanStatus* last = &request->last;
  const bool goes_on = status->phase >= last->phase && status->per_cent >= last->per_cent &&
                       status->conflicts_found >= last->conflicts_found &&
                       status->elapsed >= last->elapsed;
  const bool is_over = status->phase == kFinished;
  if (!goes_on || status->best_cost < 0 || is_over != (status->per_cent == 100)) {
    fputs("that status goes back, or says what cannot be\n", stderr);
    request->is_odd = true;
  }
  request->is_accepted = true;
  request->last = *status;
  request->last.request_id = NULL;  // that is the sample's
}

// Takes one sample that was allocated by its type's __alloc(). False: there is none.
static bool take(dds_entity_t reader, void* sample) {
  dds_sample_info_t info;
  dds_return_t count;
  do {
    count = dds_take(reader, &sample, &info, 1, 1);
  } while (count == 1 && !info.valid_data);  // such as that the service has left
  return count == 1;
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
    request->is_odd |= !gather_outcome(&request->plan, outcome);
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

// Of no request, and there for whoever comes later.
static void take_service(const struct endpoints* fleet) {
  accord_fleet_ServiceStatus* service = accord_fleet_ServiceStatus__alloc();
  while (take(fleet->service, service)) {
    fprintf(stderr, "service: process %u on %s, %s\n", service->process, service->host,
            service->accepting ? "accepting" : "about to end");
  }
  accord_fleet_ServiceStatus_free(service, DDS_FREE_ALL);
  accord_fleet_WorkerStatus* worker = accord_fleet_WorkerStatus__alloc();
  while (take(fleet->workers, worker)) {
    fprintf(stderr, "worker: process %u on %s, %s\n", worker->process, worker->host,
            worker->standing);
  }
  accord_fleet_WorkerStatus_free(worker, DDS_FREE_ALL);
}

bool hear(const struct endpoints* fleet, struct request* request) {
  take_service(fleet);
  bool any = take_replies(fleet, request);
  any |= take_statuses(fleet, request);
  any |= take_plans(fleet, request);
  any |= take_robot_plans(fleet, request);
  return any;
}
