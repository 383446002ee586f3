#include "watch.h"

#include <stdio.h>
#include <string.h>

#include "fleet.h"

static bool take_service(const struct endpoints* fleet) {
  bool accepts = false;
  accord_fleet_ServiceStatus* service = accord_fleet_ServiceStatus__alloc();
  while (take(fleet->service, service)) {
    fprintf(stderr, "service: version %s, process %u on %s, %u workers, %s\n", service->version,
            service->process, service->host, service->workers,
            service->accepting ? "accepting" : "about to end");
    accepts = service->accepting;
  }
  accord_fleet_ServiceStatus_free(service, DDS_FREE_ALL);
  return accepts;
}

static bool take_workers(const struct endpoints* fleet) {
  bool is_welcome = false;
  accord_fleet_WorkerStatus* worker = accord_fleet_WorkerStatus__alloc();
  while (take(fleet->workers, worker)) {
    fprintf(stderr, "worker: version %s, process %u on %s, %u threads, %s\n", worker->version,
            worker->process, worker->host, worker->threads, worker->standing);
    is_welcome = is_welcome || strcmp(worker->standing, "welcome") == 0;
  }
  accord_fleet_WorkerStatus_free(worker, DDS_FREE_ALL);
  return is_welcome;
}

bool watch(const struct endpoints* fleet, dds_time_t end) {
  bool has_service = false, has_worker = false;
  while (dds_time() < end) {
    has_service |= take_service(fleet);
    has_worker |= take_workers(fleet);
    if (has_service && has_worker) return true;
    dds_waitset_wait_until(fleet->presence, NULL, 0, end);
  }
  fputs("no service, or no worker of it, was heard of\n", stderr);
  return false;
}
