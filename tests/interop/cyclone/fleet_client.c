// Asks an Accord service for plans, as a fleet manager would that speaks another DDS than the
// service's. An example to read beside docs/topics.md, and what cyclone_test.py runs.
//
//   cyclone_fleet_client DOMAIN CLUSTER plan ID SCENE [FILE...]    prints the plan as a plan file
//   cyclone_fleet_client DOMAIN CLUSTER cancel ID SCENE [FILE...]  cancels it once it is accepted
//   cyclone_fleet_client DOMAIN CLUSTER resend ID                  has what others asked for said
//                                                                  again
//   cyclone_fleet_client DOMAIN CLUSTER watch                      until service and worker are
//                                                                  there
//   cyclone_fleet_client DOMAIN CLUSTER follow ROBOT               prints that robot's own path, of
//                                                                  which alone it is told
//   cyclone_fleet_client DOMAIN CLUSTER ros ROBOT KIND NAME        prints ROS 2's message on
//                                                                  /NAME/ROBOT/KIND: path or
//                                                                  joint_trajectory
//
// FILEs are those that the scene names, by these names; so it runs in the scene's folder. What it
// hears on the way goes to stderr, a line each. Exits with 0 where what it waits for has come, a
// plan of whatever status, and all is as docs/topics.md says; with 1 where not; with 2 where it was
// called in another way.
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "own_path.h"
#include "presence.h"
#include "request.h"
#include "ros_topics.h"

enum { kDomain = 1, kCluster, kCommand, kId };

static const dds_duration_t kPatience = DDS_SECS(60);  // for all of it
// Of silence, until it is asked again: longer each time, up to the second.
static const dds_duration_t kAgain = DDS_MSECS(500);
static const dds_duration_t kAgainAtMost = DDS_SECS(4);

static bool is_over(const struct request* request) {
  if (request->is_odd || request->is_refused) return true;
  return request->has_reply && request->last.phase == accord_fleet_PHASE_FINISHED &&
         is_complete(&request->plan);
}

static void pursue(const struct endpoints* fleet, struct request* request) {
  struct presence presence = {false, false};
  const dds_time_t end = dds_time() + kPatience;
  dds_duration_t again = kAgain;
  dds_time_t ask_at = dds_time();
  while (!is_over(request) && dds_time() < end) {
    if (presence.service && dds_time() >= ask_at && ask(fleet, request)) {
      ask_at = dds_time() + again;
      again = 2 * again < kAgainAtMost ? 2 * again : kAgainAtMost;
    }
    dds_waitset_wait_until(fleet->news, NULL, 0, presence.service ? ask_at : end);
    hear_presence(fleet, &presence);
    const bool was_accepted = request->is_accepted;
    if (hear(fleet, request)) ask_at = dds_time() + again;
    // A cancel need not wait for silence.
    if (request->is_to_be_cancelled && request->is_accepted && !was_accepted) ask_at = dds_time();
  }
}

static bool report(const struct request* request) {
  if (request->is_odd || request->is_refused) return false;
  if (!is_complete(&request->plan)) {
    fputs("no whole plan has come\n", stderr);
    return false;
  }
  if (!is_sound(&request->plan)) return false;
  print_plan(&request->plan, stdout);
  return true;
}

// ---- What is asked for ----

// A file's content, followed by a zero byte. Exits where it cannot be read.
static uint8_t* content_of(const char* path, uint32_t* size) {
  uint8_t* content = NULL;
  long bytes = -1;
  FILE* file = fopen(path, "rb");
  if (file != NULL && fseek(file, 0, SEEK_END) == 0) bytes = ftell(file);
  if (bytes >= 0) content = calloc((size_t)bytes + 1, 1);
  if (content != NULL) rewind(file);
  if (content == NULL || fread(content, 1, (size_t)bytes, file) != (size_t)bytes) {
    fprintf(stderr, "%s cannot be read\n", path);
    exit(1);
  }
  fclose(file);
  *size = (uint32_t)bytes;
  return content;
}

// All else is none: no queries, no deadline, the default solvers. Strings are never null.
static void fill_submission(char* id, char** files, int file_count, accord_fleet_PlanRequest* out) {
  uint32_t size;
  out->request_id = id;
  out->scene_text = (char*)content_of(files[0], &size);
  out->scene_name = "";
  out->method = "arc";
  out->seed = 1;
  out->attachments._length = (uint32_t)file_count - 1;
  out->attachments._buffer = calloc((size_t)file_count, sizeof *out->attachments._buffer);
  for (int i = 1; i < file_count; ++i) {
    accord_fleet_Attachment* attachment = &out->attachments._buffer[i - 1];
    attachment->name = files[i];
    attachment->content._buffer = content_of(files[i], &attachment->content._length);
  }
}

static void free_submission(accord_fleet_PlanRequest* submission) {
  for (uint32_t i = 0; i < submission->attachments._length; ++i) {
    free(submission->attachments._buffer[i].content._buffer);
  }
  free(submission->attachments._buffer);
  free(submission->scene_text);
}

static bool pursue_request(const struct endpoints* fleet, const char* command, char** words,
                           int count) {
  struct request request = {.submission.request_id = words[0],
                            .is_submitted_here = strcmp(command, "resend") != 0,
                            .is_to_be_cancelled = strcmp(command, "cancel") == 0};
  if (request.is_submitted_here) {
    fill_submission(words[0], words + 1, count - 1, &request.submission);
  }
  pursue(fleet, &request);
  const bool ok = report(&request);
  free_plan(&request.plan);
  if (request.is_submitted_here) free_submission(&request.submission);
  return ok;
}

// How many words follow a command, at least and at most; false: there is no such command.
static bool words_after(const char* command, int* least, int* most) {
  static const struct {
    const char* command;
    int least, most;
  } kCommands[] = {{"plan", 2, INT_MAX}, {"cancel", 2, INT_MAX}, {"resend", 1, 1},
                   {"watch", 0, 0},      {"follow", 1, 1},       {"ros", 3, 3}};
  for (size_t i = 0; i < sizeof kCommands / sizeof *kCommands; ++i) {
    if (strcmp(command, kCommands[i].command) != 0) continue;
    *least = kCommands[i].least;
    *most = kCommands[i].most;
    return true;
  }
  return false;
}

static bool run(uint32_t domain, const char* cluster, const char* command, char** words,
                int count) {
  const dds_time_t end = dds_time() + kPatience;
  if (strcmp(command, "follow") == 0) return follow_robot(domain, cluster, words[0], end);
  if (strcmp(command, "ros") == 0) return print_ros(domain, words[2], words[0], words[1], end);
  struct endpoints fleet;
  bool ok = join_fleet(domain, cluster, &fleet);
  if (ok) {
    ok = strcmp(command, "watch") == 0 ? watch(&fleet, end)
                                       : pursue_request(&fleet, command, words, count);
  }
  dds_delete(fleet.participant);
  return ok;
}

int main(int argc, char** argv) {
  int least = 0, most = 0;
  const int given = argc - kId;
  if (argc <= kCommand || !words_after(argv[kCommand], &least, &most) || given < least ||
      given > most) {
    fputs(
        "usage: cyclone_fleet_client DOMAIN CLUSTER plan|cancel ID SCENE [FILE...]\n"
        "       cyclone_fleet_client DOMAIN CLUSTER resend ID\n"
        "       cyclone_fleet_client DOMAIN CLUSTER watch\n"
        "       cyclone_fleet_client DOMAIN CLUSTER follow ROBOT\n"
        "       cyclone_fleet_client DOMAIN CLUSTER ros ROBOT path|joint_trajectory NAME\n",
        stderr);
    return 2;
  }
  const uint32_t domain = (uint32_t)strtoul(argv[kDomain], NULL, 10);
  return run(domain, argv[kCluster], argv[kCommand], argv + kId, given) ? 0 : 1;
}
