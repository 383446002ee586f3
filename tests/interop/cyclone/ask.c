#include "request.h"

// False: nobody who listens has been found yet.
static bool has_listener(dds_entity_t writer) {
  dds_publication_matched_status_t matched;
  return dds_get_publication_matched_status(writer, &matched) == DDS_RETCODE_OK &&
         matched.current_count > 0;
}

static bool send(dds_entity_t writer, const void* sample) {
  return has_listener(writer) && dds_write(writer, sample) == DDS_RETCODE_OK;
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
