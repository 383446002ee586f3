#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gathered_plan.h"

static bool wrong(const char* robot, const char* what) {
  fprintf(stderr, "the path of \"%s\" %s\n", robot, what);
  return false;
}

// Where a path has been followed to, piece by piece.
struct follower {
  const char* robot;
  uint32_t robot_index;
  uint32_t robot_count;
  bool has_begun;
  double time;     // s, of the last waypoint
  double segment;  // s, where the last segment ends
};

static bool follow_waypoints(struct follower* at, const accord_fleet_RobotPlan* piece) {
  for (uint32_t w = 0; w < piece->times._length; ++w) {
    const double time = piece->times._buffer[w];
    if (!at->has_begun && time != 0) return wrong(at->robot, "does not begin at 0 s");
    if (at->has_begun && !(time > at->time)) return wrong(at->robot, "goes back in time");
    at->has_begun = true;
    at->time = time;
  }
  for (uint32_t i = 0; i < piece->configurations._length; ++i) {
    if (!isfinite(piece->configurations._buffer[i])) {
      return wrong(at->robot, "has a number that is not finite");
    }
  }
  return true;
}

static bool follow_segments(struct follower* at, const accord_fleet_RobotPlan* piece) {
  for (uint32_t s = 0; s < piece->segments._length; ++s) {
    const accord_fleet_Segment* segment = &piece->segments._buffer[s];
    if (segment->from != at->segment || !(segment->to > segment->from)) {
      return wrong(at->robot, "has segments with a gap");
    }
    at->segment = segment->to;
    bool is_in = false;
    for (uint32_t i = 0; i < segment->robots._length; ++i) {
      const uint32_t robot = segment->robots._buffer[i];
      if (robot >= at->robot_count) return wrong(at->robot, "was planned with nobody");
      is_in = is_in || robot == at->robot_index;
    }
    if (!is_in) return wrong(at->robot, "was planned without it");
  }
  return true;
}

bool is_sound_path(const struct gathered_path* path, const char* robot, uint32_t robot_index,
                   uint32_t robot_count) {
  struct follower at = {robot, robot_index, robot_count, false, 0, 0};
  for (uint32_t p = 0; p < path->piece_count; ++p) {
    const accord_fleet_RobotPlan* piece = path->pieces[p];
    if (strcmp(piece->robot, robot) != 0) return wrong(robot, "has another robot's piece");
    if (!follow_waypoints(&at, piece) || !follow_segments(&at, piece)) return false;
  }
  if (!at.has_begun) return wrong(robot, "has no waypoints");
  if (at.segment != at.time) return wrong(robot, "ends before or after its segments");
  return true;
}

bool is_sound(const struct gathered_plan* plan) {
  const accord_fleet_Plan* outcome = plan->outcome;
  const uint32_t count = outcome->robots._length;
  for (uint32_t r = 0; r < count; ++r) {
    if (!is_sound_path(&plan->paths[r], outcome->robots._buffer[r], r, count)) return false;
  }
  return true;
}
