#include "own_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "endpoints.h"
#include "gathered_plan.h"
#include "json.h"

static const dds_duration_t kQuiet = DDS_SECS(1);

struct own_path {
  const char* robot;
  char* request_id;           // the latest that something has come of; NULL: none
  struct gathered_plan plan;  // that request's, of which only this robot's path comes
  uint32_t robot_index;
  unsigned own_pieces;
  unsigned other_pieces;
  bool is_odd;  // something came that cannot be
};

static bool is_there(const struct own_path* own) {
  return own->robot_index < own->plan.path_count && is_whole(&own->plan.paths[own->robot_index]);
}

// Takes a piece of this robot over.
static void add(struct own_path* own, accord_fleet_RobotPlan* piece) {
  if (own->request_id == NULL || strcmp(own->request_id, piece->request_id) != 0) {
    free(own->request_id);
    own->request_id = strdup(piece->request_id);
    free_plan(&own->plan);
  }
  own->robot_index = piece->robot_index;
  own->is_odd |= !gather_piece(&own->plan, piece);
}

// True: something has come, of whichever robot.
static bool take_pieces(dds_entity_t reader, struct own_path* own) {
  bool any = false;
  accord_fleet_RobotPlan* piece = accord_fleet_RobotPlan__alloc();
  while (take(reader, piece)) {
    any = true;
    if (strcmp(piece->robot, own->robot) != 0) {
      ++own->other_pieces;
      continue;
    }
    ++own->own_pieces;
    add(own, piece);
    piece = accord_fleet_RobotPlan__alloc();
  }
  accord_fleet_RobotPlan_free(piece, DDS_FREE_ALL);
  return any;
}

static void say_whether_found(dds_entity_t reader) {
  dds_subscription_matched_status_t matched;
  if (dds_get_subscription_matched_status(reader, &matched) == DDS_RETCODE_OK &&
      matched.current_count_change != 0) {
    fprintf(stderr, "writers: %u\n", matched.current_count);
  }
}

static void listen(const struct listener* topic, struct own_path* own, dds_time_t end) {
  dds_time_t quiet_at = end;
  while (dds_time() < quiet_at) {
    dds_waitset_wait_until(topic->news, NULL, 0, quiet_at);
    say_whether_found(topic->reader);
    if (take_pieces(topic->reader, own) && is_there(own)) quiet_at = dds_time() + kQuiet;
  }
}

static bool report(const struct own_path* own) {
  fprintf(stderr, "pieces: %u, of other robots %u\n", own->own_pieces, own->other_pieces);
  if (own->is_odd || own->other_pieces > 0) return false;
  if (!is_there(own)) {
    fputs("no whole path has come\n", stderr);
    return false;
  }
  const struct gathered_path* path = &own->plan.paths[own->robot_index];
  // How many robots there are it does not hear.
  if (!is_sound_path(path, own->robot, own->robot_index, UINT32_MAX)) return false;
  fputs("{\"request\": ", stdout);
  print_text(own->request_id, stdout);
  fprintf(stdout, ", \"index\": %u, \"path\":\n    ", own->robot_index);
  print_path(path, stdout);
  fputs("}\n", stdout);
  return true;
}

bool follow_robot(uint32_t domain, const char* cluster, const char* robot, dds_time_t end) {
  struct listener topic;
  struct own_path own = {.robot = robot};
  bool ok = join_as_robot(domain, cluster, robot, &topic);
  if (ok) {
    listen(&topic, &own, end);
    ok = report(&own);
  }
  free(own.request_id);
  free_plan(&own.plan);
  dds_delete(topic.participant);
  return ok;
}
