// What one request, one piece of news and one plan may hold, in one place; idl/fleet.idl states the
// same bounds for sequences. Both ends check them: who sends refuses, who receives drops and
// counts. They are no narrower than what the service itself takes, so that a request that is wrong
// in a way that people make mistakes is answered, not dropped.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "common/io/limits.h"
#include "common/transport/fleet/fleet_messages.h"
#include "common/transport/fleet/plan_parts.h"

namespace accord {

inline constexpr std::size_t kFleetIdBytes = 256;            // of a request
inline constexpr std::size_t kFleetNameBytes = 1024;         // of whatever else has a name
inline constexpr std::size_t kFleetTextBytes = 64U << 10U;   // of what people read
inline constexpr std::size_t kAttachments = 1024;            // of a request
inline constexpr std::size_t kAttachmentBytes = 64U << 20U;  // of a request's together
inline constexpr std::size_t kStatistics = 1000;             // of a plan
inline constexpr std::size_t kPathPieceBytes = 64U << 10U;   // of a piece's waypoints and segments
inline constexpr std::size_t kSegmentHeadBytes = 32;         // a segment's, but for its names
inline constexpr std::size_t kPathPieceDoubles = kPathPieceBytes / sizeof(double);
inline constexpr std::size_t kPathPieceSegments = kPathPieceBytes / kSegmentHeadBytes;
inline constexpr std::size_t kPathPieces = 8192;            // of a robot's path
inline constexpr std::size_t kPlanWireBytes = 256U << 20U;  // of a plan's pieces together

// Why it cannot travel, as a sentence; nullopt where it can. Beyond a limit, a zero byte in a text
// (a file's content may have some), a number of a path that is not finite, a segment with a robot
// that the plan does not have.
std::optional<std::string> fleet_fault(const FleetRequest& request);
std::optional<std::string> fleet_fault(const FleetNews& news);
std::optional<std::string> fleet_fault(const FleetPart& part);

// What kPathPieceBytes bounds: about how many bytes a piece's contents take on the wire.
std::size_t waypoint_bytes(std::size_t dof);
std::size_t segment_bytes(std::size_t solver_bytes, std::size_t robots);
std::size_t content_bytes(const PathPiece& piece);

// About how much memory a plan's paths take, in bytes.
std::size_t memory_of(const FinishedPlan& finished);

}  // namespace accord
