// What one message may hold, in one place; idl/accord.idl states the same bounds. Both ends check
// them: the sender refuses to publish, the receiver drops and counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "common/io/limits.h"
#include "common/transport/endpoint_id.h"
#include "common/transport/messages.h"

namespace accord {

inline constexpr std::size_t kTaskBytes = limits::kSubproblemBytes;
inline constexpr std::size_t kResultBytes = limits::kResolutionBytes;
inline constexpr std::size_t kBatchItems = 128;                    // tasks or results of one batch
inline constexpr std::size_t kBatchBytes = std::size_t{16} << 20;  // of their payloads together
inline constexpr std::size_t kHierarchyBytes = 2048;
inline constexpr std::size_t kPieceBytes = std::size_t{256} << 10;
inline constexpr std::size_t kKeys = 4096;       // tasks that one command or heartbeat names
inline constexpr std::size_t kTextBytes = 1024;  // of what people read

// Who may send such a message.
Role sender_of(const Message& message);

// Why a message cannot travel, as a sentence; nullopt where it can.
std::optional<std::string> message_fault(const Message& message);

// About how many bytes it takes on the wire.
std::size_t wire_bytes(const Message& message);

}  // namespace accord
