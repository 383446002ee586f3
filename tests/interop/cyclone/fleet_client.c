// Asks an Accord service for plans, as a fleet manager would that speaks another DDS than the
// service's. An example to read beside docs/topics.md, and what cyclone_test.py runs.
//
//   cyclone_fleet_client DOMAIN CLUSTER plan ID SCENE [FILE...]    prints the plan as a plan file
//   cyclone_fleet_client DOMAIN CLUSTER cancel ID SCENE [FILE...]  cancels it once it is accepted
//   cyclone_fleet_client DOMAIN CLUSTER resend ID                  has what others asked for said
//                                                                  again
//   cyclone_fleet_client DOMAIN CLUSTER watch                      until service and worker are
//   there
//
// FILEs are those that the scene names, by these names; so it runs in the scene's folder. What it
// hears on the way goes to stderr, a line each. Exits with 0 where what it waits for has come, a
// plan of whatever status, and all is as docs/topics.md says; with 1 where not; with 2 where it was
// called in another way.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "presence.h"
#include "request.h"

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

static void follow(const struct endpoints* fleet, struct request* request) {
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

static bool run(const struct endpoints* fleet, const char* command, char** words, int count) {
  if (strcmp(command, "watch") == 0) return watch(fleet, dds_time() + kPatience);
  struct request request = {.submission.request_id = words[0],
                            .is_submitted_here = strcmp(command, "resend") != 0,
                            .is_to_be_cancelled = strcmp(command, "cancel") == 0};
  if (request.is_submitted_here) {
    fill_submission(words[0], words + 1, count - 1, &request.submission);
  }
  follow(fleet, &request);
  const bool ok = report(&request);
  free_plan(&request.plan);
  if (request.is_submitted_here) free_submission(&request.submission);
  return ok;
}

// How many words follow a command, at least; -1: there is no such command.
static int words_after(const char* command) {
  if (strcmp(command, "plan") == 0 || strcmp(command, "cancel") == 0) return 2;
  if (strcmp(command, "resend") == 0) return 1;
  return strcmp(command, "watch") == 0 ? 0 : -1;
}

int main(int argc, char** argv) {
  const int words = argc > kCommand ? words_after(argv[kCommand]) : -1;
  const int given = argc - kId;
  if (words < 0 || given < words || (words < 2 && given > words)) {
    fputs(
        "usage: cyclone_fleet_client DOMAIN CLUSTER plan|cancel|resend|watch [ID [SCENE "
        "[FILE...]]]\n",
        stderr);
    return 2;
  }
  struct endpoints fleet;
  const bool ok = join_fleet((uint32_t)strtoul(argv[kDomain], NULL, 10), argv[kCluster], &fleet) &&
                  run(&fleet, argv[kCommand], argv + kId, given);
  dds_delete(fleet.participant);
  return ok ? 0 : 1;
}
