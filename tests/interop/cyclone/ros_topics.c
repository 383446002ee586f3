#include "ros_topics.h"

#include <stdio.h>
#include <string.h>

#include "endpoints.h"
#include "json.h"
#include "ros.h"

// True: one has come, into `sample`.
static bool wait_for(const struct listener* topic, void* sample, dds_time_t end) {
  while (dds_time() < end) {
    if (take(topic->reader, sample)) return true;
    dds_subscription_matched_status_t matched;  // read, or it triggers for ever
    dds_get_subscription_matched_status(topic->reader, &matched);
    dds_waitset_wait_until(topic->news, NULL, 0, end);
  }
  fputs("no message has come\n", stderr);
  return false;
}

static void print_stamp(const char* key, int32_t sec, uint32_t nanosec, FILE* out) {
  fprintf(out, "\"%s\": [%d, %u]", key, sec, nanosec);
}

static void print_header(const std_msgs_msg_dds__Header_* header, FILE* out) {
  print_stamp("stamp", header->stamp.sec, header->stamp.nanosec, out);
  fputs(", \"frame\": ", out);
  print_text(header->frame_id, out);
}

static void print_path_message(const nav_msgs_msg_dds__Path_* path, FILE* out) {
  fputc('{', out);
  print_header(&path->header, out);
  fputs(", \"poses\": [", out);
  for (uint32_t i = 0; i < path->poses._length; ++i) {
    const geometry_msgs_msg_dds__PoseStamped_* stamped = &path->poses._buffer[i];
    const geometry_msgs_msg_dds__Point_* at = &stamped->pose.position;
    const geometry_msgs_msg_dds__Quaternion_* turn = &stamped->pose.orientation;
    fputs(i == 0 ? "\n  {" : ",\n  {", out);
    print_header(&stamped->header, out);
    fputs(", \"position\": ", out);
    print_numbers((const double[]){at->x, at->y, at->z}, 3, out);
    fputs(", \"orientation\": ", out);
    print_numbers((const double[]){turn->x, turn->y, turn->z, turn->w}, 4, out);
    fputc('}', out);
  }
  fputs("]}\n", out);
}

static void print_joint_trajectory(const trajectory_msgs_msg_dds__JointTrajectory_* trajectory,
                                   FILE* out) {
  fputc('{', out);
  print_header(&trajectory->header, out);
  fputs(", \"joints\": [", out);
  for (uint32_t i = 0; i < trajectory->joint_names._length; ++i) {
    if (i > 0) fputs(", ", out);
    print_text(trajectory->joint_names._buffer[i], out);
  }
  fputs("], \"points\": [", out);
  for (uint32_t i = 0; i < trajectory->points._length; ++i) {
    const trajectory_msgs_msg_dds__JointTrajectoryPoint_* point = &trajectory->points._buffer[i];
    fputs(i == 0 ? "\n  {" : ",\n  {", out);
    print_stamp("time_from_start", point->time_from_start.sec, point->time_from_start.nanosec, out);
    fputs(", \"positions\": ", out);
    print_numbers(point->positions._buffer, point->positions._length, out);
    fputs(", \"velocities\": ", out);
    print_numbers(point->velocities._buffer, point->velocities._length, out);
    fputs(", \"accelerations\": ", out);
    print_numbers(point->accelerations._buffer, point->accelerations._length, out);
    fputs(", \"effort\": ", out);
    print_numbers(point->effort._buffer, point->effort._length, out);
    fputc('}', out);
  }
  fputs("]}\n", out);
}

static bool print_latest_path(const struct listener* topic, dds_time_t end) {
  nav_msgs_msg_dds__Path_* path = nav_msgs_msg_dds__Path___alloc();
  const bool ok = wait_for(topic, path, end);
  if (ok) print_path_message(path, stdout);
  nav_msgs_msg_dds__Path__free(path, DDS_FREE_ALL);
  return ok;
}

static bool print_latest_trajectory(const struct listener* topic, dds_time_t end) {
  trajectory_msgs_msg_dds__JointTrajectory_* trajectory =
      trajectory_msgs_msg_dds__JointTrajectory___alloc();
  const bool ok = wait_for(topic, trajectory, end);
  if (ok) print_joint_trajectory(trajectory, stdout);
  trajectory_msgs_msg_dds__JointTrajectory__free(trajectory, DDS_FREE_ALL);
  return ok;
}

bool print_ros(uint32_t domain, const char* name, const char* robot, const char* kind,
               dds_time_t end) {
  char topic_name[512];
  snprintf(topic_name, sizeof topic_name, "rt/%s/%s/%s", name, robot, kind);
  const bool is_path = strcmp(kind, "path") == 0;
  if (!is_path && strcmp(kind, "joint_trajectory") != 0) {
    fprintf(stderr, "\"%s\" is neither path nor joint_trajectory\n", kind);
    return false;
  }
  struct listener topic;
  bool ok = join_ros(
      domain, topic_name,
      is_path ? &nav_msgs_msg_dds__Path__desc : &trajectory_msgs_msg_dds__JointTrajectory__desc,
      &topic);
  if (ok) ok = is_path ? print_latest_path(&topic, end) : print_latest_trajectory(&topic, end);
  dds_delete(topic.participant);
  return ok;
}
