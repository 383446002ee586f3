// What travels on the public topics and the generated types that carry it. For dds/'s own use.
#pragma once

#include "common/transport/dds/support.h"
#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"
#include "fleetPubSubTypes.h"

namespace accord::fleet {

bool counts_are_sound(const PlanRequest* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const Plan* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const RobotPlan* kind, eprosima::fastcdr::Cdr& in);

}  // namespace accord::fleet

namespace accord::dds {

#define ACCORD_FLEET_TYPE(Value, Name)                                  \
  template <>                                                           \
  struct Wire<Value> {                                                  \
    using Type = fleet::Name;                                           \
    using Support = dds::Support<fleet::Name, fleet::Name##PubSubType>; \
  }
ACCORD_FLEET_TYPE(PlanRequest, PlanRequest);
ACCORD_FLEET_TYPE(CancelRequest, Cancel);
ACCORD_FLEET_TYPE(ResendRequest, Resend);
ACCORD_FLEET_TYPE(RequestReply, RequestReply);
ACCORD_FLEET_TYPE(RequestState, PlanStatus);
ACCORD_FLEET_TYPE(PlanOutline, Plan);
ACCORD_FLEET_TYPE(PathPiece, RobotPlan);
ACCORD_FLEET_TYPE(WorkerStatus, WorkerStatus);
ACCORD_FLEET_TYPE(ServiceStatus, ServiceStatus);
#undef ACCORD_FLEET_TYPE

void to_wire(const PlanRequest& request, fleet::PlanRequest& out);
void to_wire(const CancelRequest& request, fleet::Cancel& out);
void to_wire(const ResendRequest& request, fleet::Resend& out);
void to_wire(const RequestReply& reply, fleet::RequestReply& out);
void to_wire(const RequestState& state, fleet::PlanStatus& out);
void to_wire(const PlanOutline& outline, fleet::Plan& out);
void to_wire(const PathPiece& piece, fleet::RobotPlan& out);
void to_wire(const WorkerStatus& worker, fleet::WorkerStatus& out);
void to_wire(const ServiceStatus& service, fleet::ServiceStatus& out);

// Takes contents out of what came. Bounds are for fleet_fault() to check.
PlanRequest from_wire(fleet::PlanRequest& from);
CancelRequest from_wire(fleet::Cancel& from);
ResendRequest from_wire(fleet::Resend& from);
RequestReply from_wire(fleet::RequestReply& from);
RequestState from_wire(fleet::PlanStatus& from);
PlanOutline from_wire(fleet::Plan& from);
PathPiece from_wire(fleet::RobotPlan& from);
WorkerStatus from_wire(fleet::WorkerStatus& from);
ServiceStatus from_wire(fleet::ServiceStatus& from);

}  // namespace accord::dds
