#include "presence.h"

#include <stdio.h>
#include <string.h>

#include "fleet.h"

static void take_service(const struct endpoints* fleet, struct presence* presence) {
  accord_fleet_ServiceStatus* service = accord_fleet_ServiceStatus__alloc();
  while (take(fleet->service, service)) {
    fprintf(stderr, "service: version %s, process %u on %s, %u workers, %s\n", service->version,
            service->process, service->host, service->workers,
            service->accepting ? "accepting" : "about to end");
    presence->service = service->accepting;
  }
  accord_fleet_ServiceStatus_free(service, DDS_FREE_ALL);
}

static void take_workers(const struct endpoints* fleet, struct presence* presence) {
  accord_fleet_WorkerStatus* worker = accord_fleet_WorkerStatus__alloc();
  while (take(fleet->workers, worker)) {
    fprintf(stderr, "worker: version %s, process %u on %s, %u threads, %s\n", worker->version,
            worker->process, worker->host, worker->threads, worker->standing);
    if (strcmp(worker->standing, "welcome") == 0) presence->worker = true;
  }
  accord_fleet_WorkerStatus_free(worker, DDS_FREE_ALL);
}

void hear_presence(const struct endpoints* fleet, struct presence* presence) {
  take_service(fleet, presence);
  take_workers(fleet, presence);
}

bool watch(const struct endpoints* fleet, dds_time_t end) {
  struct presence presence = {false, false};
  while (dds_time() < end) {
    hear_presence(fleet, &presence);
    if (presence.service && presence.worker) return true;
    dds_waitset_wait_until(fleet->news, NULL, 0, end);
  }
  fputs("no service, or no worker of it, was heard of\n", stderr);
  return false;
}
