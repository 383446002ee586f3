#include "gathered_plan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void* or_die(void* memory) {
  if (memory == NULL) abort();
  return memory;
}

static void free_paths(struct gathered_plan* plan) {
  for (uint32_t r = 0; r < plan->path_count; ++r) {
    struct gathered_path* path = &plan->paths[r];
    for (uint32_t p = 0; p < path->piece_count; ++p) {
      if (path->pieces[p] != NULL) accord_fleet_RobotPlan_free(path->pieces[p], DDS_FREE_ALL);
    }
    free(path->pieces);
  }
  free(plan->paths);
  plan->paths = NULL;
  plan->path_count = 0;
}

void free_plan(struct gathered_plan* plan) {
  free_paths(plan);
  if (plan->outcome != NULL) accord_fleet_Plan_free(plan->outcome, DDS_FREE_ALL);
  plan->outcome = NULL;
  plan->version = 0;
}

// False: what comes belongs to a version that has been replaced.
static bool is_current(struct gathered_plan* plan, uint32_t version) {
  if (version > plan->version) free_plan(plan);
  if (version < plan->version) return false;
  plan->version = version;
  return true;
}

static struct gathered_path* path_of(struct gathered_plan* plan, uint32_t robot) {
  if (robot >= plan->path_count) {
    const uint32_t count = robot + 1;
    plan->paths = or_die(realloc(plan->paths, count * sizeof *plan->paths));
    memset(plan->paths + plan->path_count, 0, (count - plan->path_count) * sizeof *plan->paths);
    plan->path_count = count;
  }
  return &plan->paths[robot];
}

void gather_outcome(struct gathered_plan* plan, accord_fleet_Plan* outcome) {
  if (!is_current(plan, outcome->version) || plan->outcome != NULL) {
    accord_fleet_Plan_free(outcome, DDS_FREE_ALL);
    return;
  }
  plan->outcome = outcome;
}

bool gather_piece(struct gathered_plan* plan, accord_fleet_RobotPlan* piece) {
  if (!is_current(plan, piece->version)) {
    accord_fleet_RobotPlan_free(piece, DDS_FREE_ALL);
    return true;
  }
  struct gathered_path* path =
      piece->robot_index < 10000 ? path_of(plan, piece->robot_index) : NULL;
  if (path != NULL && path->piece_count == 0 && piece->pieces <= 8192) {
    path->pieces = or_die(calloc(piece->pieces + 1, sizeof *path->pieces));
    path->piece_count = piece->pieces;
  }
  const bool fits = path != NULL && piece->pieces == path->piece_count &&
                    piece->piece < piece->pieces &&
                    piece->configurations._length == piece->times._length * piece->dof;
  if (!fits) {
    fprintf(stderr, "a piece of the path of \"%s\" does not fit\n", piece->robot);
  } else if (path->pieces[piece->piece] == NULL) {
    path->pieces[piece->piece] = piece;
    return true;
  }
  accord_fleet_RobotPlan_free(piece, DDS_FREE_ALL);
  return fits;
}

bool is_whole(const struct gathered_path* path) {
  for (uint32_t p = 0; p < path->piece_count; ++p) {
    if (path->pieces[p] == NULL) return false;
  }
  return path->piece_count > 0;
}

bool is_complete(const struct gathered_plan* plan) {
  if (plan->outcome == NULL || plan->path_count < plan->outcome->robots._length) return false;
  for (uint32_t r = 0; r < plan->outcome->robots._length; ++r) {
    if (!is_whole(&plan->paths[r])) return false;
  }
  return true;
}
