#include "request.h"

static bool send(dds_entity_t writer, const void* sample) {
  return dds_write(writer, sample) == DDS_RETCODE_OK;
}

bool ask(const struct endpoints* fleet, const struct request* request) {
  if (request->is_submitted_here && !request->is_accepted) {
    return send(fleet->plan_requests, &request->submission);
  }
  if (request->is_to_be_cancelled && request->last.phase != accord_fleet_PHASE_FINISHED) {
    const accord_fleet_Cancel cancel = {request->submission.request_id};
    return send(fleet->cancels, &cancel);
  }
  const accord_fleet_Resend resend = {request->submission.request_id};
  return send(fleet->resends, &resend);
}
