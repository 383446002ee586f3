// Our messages and the generated types that carry them. For dds/'s own use.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include "accordPubSubTypes.h"
#include "common/transport/messages.h"

namespace accord::dds {

// Whether what comes states no more elements than a message may have: generated code allocates for
// as many as there are bytes, a hundred bytes and more each, before it looks at the first.
bool counts_are_sound(const wire::TaskBatch* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const wire::ResultBatch* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const wire::Command* kind, eprosima::fastcdr::Cdr& in);
bool counts_are_sound(const wire::Heartbeat* kind, eprosima::fastcdr::Cdr& in);
inline bool counts_are_sound(const void*, eprosima::fastcdr::Cdr&) {
  return true;
}

// Generated support that refuses such bytes.
template <typename Type, typename Generated>
class Support final : public Generated {
 public:
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* out) override {
    // Generated code lets some exceptions through, such as of a bool that is neither 0 nor 1.
    try {
      return has_sound_counts(*payload) && Generated::deserialize(payload, out);
    } catch (const eprosima::fastcdr::exception::Exception&) {
      return false;
    }
  }

 private:
  static bool has_sound_counts(eprosima::fastrtps::rtps::SerializedPayload_t& payload) {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload.data), payload.length);
    eprosima::fastcdr::Cdr in(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                              eprosima::fastcdr::Cdr::DDS_CDR);
    in.read_encapsulation();
    return counts_are_sound(static_cast<const Type*>(nullptr), in);
  }
};

// The generated type of a message, and what serialises it.
template <typename Message>
struct Wire;

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
