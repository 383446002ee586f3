// A look at Protobuf bytes before they are parsed. Parsing allocates a hundred bytes and more for
// each message that two bytes announce, passes over fields that it does not know, and takes fields
// in any order and number; here such bytes are refused first. For the decoders' use.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "common/io/wire/bytes.h"

namespace google::protobuf {
class Message;
}

namespace accord {

struct ScanLimits {
  std::size_t bytes;
  std::size_t parts;  // messages and names, at any depth
};

// Parses the bytes into `out`, or says why they cannot be what our encoders write: cut short,
// fields that are unknown, of the wrong type, repeated where they are single or out of order, lists
// of numbers that are not packed, more parts than the limit. `what` names the payload in messages:
// "a scene".
std::optional<std::string> parse_payload(BytesView bytes, std::string_view what,
                                         const ScanLimits& limits, google::protobuf::Message& out);

// The bytes of a message, the same for the same message.
Bytes serialize_payload(const google::protobuf::Message& message);

}  // namespace accord
