// Looks through bytes that came for how many elements they say to have, allocating nothing.
#include <fastcdr/exceptions/NotEnoughMemoryException.h>

#include "common/transport/dds/fleet/conversions.h"
#include "common/transport/fleet/fleet_limits.h"

namespace accord::fleet {
namespace {

using eprosima::fastcdr::Cdr;

std::uint32_t length(Cdr& in) {
  std::uint32_t out = 0;
  in >> out;
  return out;
}

void skip_bytes(std::size_t bytes, Cdr& in) {
  if (bytes == 0) return;
  if (!in.jump(bytes - 1)) {
    throw eprosima::fastcdr::exception::NotEnoughMemoryException("more bytes than there are");
  }
  std::uint8_t last = 0;  // read, so that Cdr aligns what comes next
  in >> last;
}

void skip_string(Cdr& in) {
  skip_bytes(length(in), in);
}

// Of numbers. Their alignment is that of the first.
template <typename Number>
void skip_sequence(Cdr& in) {
  const std::size_t count = length(in);
  if (count == 0) return;
  Number first{};
  in >> first;
  skip_bytes((count - 1) * sizeof(Number), in);
}

template <typename Number>
void skip(Cdr& in) {
  Number number{};
  in >> number;
}

}  // namespace

bool counts_are_sound(const PlanRequest*, Cdr& in) {
  skip_string(in);  // request_id
  skip_string(in);  // scene_text
  const std::uint32_t attachments = length(in);
  if (attachments > kAttachments) return false;
  for (std::uint32_t i = 0; i < attachments; ++i) {
    skip_string(in);                  // name
    skip_sequence<std::uint8_t>(in);  // content
  }
  skip_string(in);  // scene_name
  const std::uint32_t queries = length(in);
  if (queries > limits::kRobots) return false;
  for (std::uint32_t i = 0; i < queries; ++i) {
    skip_string(in);  // robot
    for (int end = 0; end < 2; ++end) {
      skip<std::uint8_t>(in);     // has_start, has_goal
      skip_sequence<double>(in);  // start, goal
    }
  }
  skip_string(in);          // method
  skip<std::uint64_t>(in);  // seed
  return length(in) <= limits::kSolvers;
}

bool counts_are_sound(const Plan*, Cdr& in) {
  skip_string(in);          // request_id
  skip_string(in);          // content
  skip<std::uint32_t>(in);  // version
  skip_string(in);          // scene
  skip<std::uint8_t>(in);   // status
  skip_string(in);          // message
  skip_string(in);          // method
  skip<std::uint64_t>(in);  // seed
  // timestep, planning_time, makespan, sum_of_costs
  for (int i = 0; i < 4; ++i) skip<double>(in);
  skip<std::int64_t>(in);  // sum_of_costs_timesteps
  const std::uint32_t statistics = length(in);
  if (statistics > kStatistics) return false;
  for (std::uint32_t i = 0; i < statistics; ++i) {
    skip_string(in);   // name
    skip<double>(in);  // value
  }
  return length(in) <= limits::kRobots;
}

bool counts_are_sound(const RobotPlan*, Cdr& in) {
  skip_string(in);          // request_id
  skip<std::uint32_t>(in);  // version
  skip_string(in);          // robot
  // robot_index, dof, piece, pieces
  for (int i = 0; i < 4; ++i) skip<std::uint32_t>(in);
  skip_sequence<double>(in);  // times
  skip_sequence<double>(in);  // configurations
  return length(in) <= kPathPieceSegments;
}

}  // namespace accord::fleet
