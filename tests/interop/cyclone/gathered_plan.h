// A plan put together from what came on `plans` and `robot_plans`, in whatever order and however
// often it came.
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "fleet.h"

struct gathered_path {
  accord_fleet_RobotPlan** pieces;  // by number; NULL: still to come
  uint32_t piece_count;             // 0: none has come
};

struct gathered_plan {
  uint32_t version;             // 0: nothing has come
  accord_fleet_Plan* outcome;   // NULL: still to come
  struct gathered_path* paths;  // by place in the outcome's robots, as far as pieces have come
  uint32_t path_count;
};

// Take a sample over, which was allocated by its type's __alloc(), and ignore it where it has come
// before or belongs to a plan that a newer version has replaced. A piece that fits into no plan is
// dropped: false, with a line on stderr.
void gather_outcome(struct gathered_plan* plan, accord_fleet_Plan* outcome);
bool gather_piece(struct gathered_plan* plan, accord_fleet_RobotPlan* piece);

// Whether all pieces of a path are there.
bool is_whole(const struct gathered_path* path);

// Whether the outcome and, of every robot that it names, all pieces are there.
bool is_complete(const struct gathered_plan* plan);

// Whether it is a plan: every robot's waypoints begin at 0, their times ascend, their numbers are
// finite, and its segments lead from the first to the last one. A line on stderr where not.
// Requires: is_complete().
bool is_sound(const struct gathered_plan* plan);
// The same of one path, of the robot of this name and place among so many. Requires: is_whole().
bool is_sound_path(const struct gathered_path* path, const char* robot, uint32_t robot_index,
                   uint32_t robot_count);

// As a plan file (docs/formats.md). Requires: is_complete().
void print_plan(const struct gathered_plan* plan, FILE* out);
// A path as a plan file has it, but for the robots of its segments: places, not names.
// Requires: is_whole().
void print_path(const struct gathered_path* path, FILE* out);

void free_plan(struct gathered_plan* plan);
