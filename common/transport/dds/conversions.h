// The bus's messages and the generated types that carry them. For dds/'s own use.
#pragma once

#include "accordPubSubTypes.h"
#include "common/transport/dds/support.h"
#include "common/transport/messages.h"

namespace accord::wire {

bool counts_are_sound(const TaskBatch* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const ResultBatch* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const Command* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const Heartbeat* kind, eprosima::fastcdr::Cdr& in);

}  // namespace accord::wire

namespace accord::dds {

#define ACCORD_WIRE_TYPE(Name)                                        \
  template <>                                                         \
  struct Wire<Name> {                                                 \
    using Type = wire::Name;                                          \
    using Support = dds::Support<wire::Name, wire::Name##PubSubType>; \
  }
ACCORD_WIRE_TYPE(TaskBatch);
ACCORD_WIRE_TYPE(Command);
ACCORD_WIRE_TYPE(ScenePiece);
ACCORD_WIRE_TYPE(Announcement);
ACCORD_WIRE_TYPE(ResultBatch);
ACCORD_WIRE_TYPE(Heartbeat);
ACCORD_WIRE_TYPE(SceneRequest);
#undef ACCORD_WIRE_TYPE

// All but the head.
void to_wire(const TaskBatch& message, wire::TaskBatch& out);
void to_wire(const Command& message, wire::Command& out);
void to_wire(const ScenePiece& message, wire::ScenePiece& out);
void to_wire(const Announcement& message, wire::Announcement& out);
void to_wire(const ResultBatch& message, wire::ResultBatch& out);
void to_wire(const Heartbeat& message, wire::Heartbeat& out);
void to_wire(const SceneRequest& message, wire::SceneRequest& out);

// Takes payloads out of what came. Bounds are for message_fault() to check.
TaskBatch from_wire(wire::TaskBatch& from);
Command from_wire(wire::Command& from);
ScenePiece from_wire(wire::ScenePiece& from);
Announcement from_wire(wire::Announcement& from);
ResultBatch from_wire(wire::ResultBatch& from);
Heartbeat from_wire(wire::Heartbeat& from);
SceneRequest from_wire(wire::SceneRequest& from);

}  // namespace accord::dds
