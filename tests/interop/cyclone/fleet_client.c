// Asks an Accord service for plans, as a fleet manager would that speaks another DDS than the
// service's. An example to read beside docs/topics.md, and what cyclone_test.py runs.
//
//   cyclone_fleet_client DOMAIN CLUSTER plan ID SCENE [FILE...]    prints the plan as a plan file
//   cyclone_fleet_client DOMAIN CLUSTER cancel ID SCENE [FILE...]  cancels it once it is accepted
//   cyclone_fleet_client DOMAIN CLUSTER resend ID                  has what others asked for said
//                                                                  again
//
// FILEs are those that the scene names, by these names; so it runs in the scene's folder. What it
// hears on the way goes to stderr, a line each. Exits with 0 where a plan has come, of whatever
// status, and all that came is as docs/topics.md says; with 1 where not; with 2 where it was called
// in another way.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "request.h"

enum { kDomain = 1, kCluster, kCommand, kId, kScene };

static const dds_duration_t kPatience = DDS_SECS(60);  // for all of it
// Of silence, until it is asked again: longer each time, up to the second.
static const dds_duration_t kAgain = DDS_MSECS(500);
static const dds_duration_t kAgainAtMost = DDS_SECS(4);
static const dds_duration_t kUntilFound = DDS_MSECS(20);  // until who was not there is looked for

static bool is_over(const struct request* request) {
  if (request->is_odd || request->is_refused) return true;
  return request->last.phase == kFinished && is_complete(&request->plan);
}

static void follow(const struct endpoints* fleet, struct request* request) {
  const dds_time_t end = dds_time() + kPatience;
  dds_duration_t again = kAgain;
  dds_time_t ask_at = dds_time();
  while (!is_over(request) && dds_time() < end) {
    if (dds_time() >= ask_at) {
      const bool is_sent = ask(fleet, request);
      ask_at = dds_time() + (is_sent ? again : kUntilFound);
      if (is_sent) again = 2 * again < kAgainAtMost ? 2 * again : kAgainAtMost;
    }
    dds_waitset_wait_until(fleet->news, NULL, 0, ask_at);
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

int main(int argc, char** argv) {
  const char* command = argc > kId ? argv[kCommand] : "";
  const bool resends = strcmp(command, "resend") == 0 && argc == kId + 1;
  const bool cancels = strcmp(command, "cancel") == 0 && argc > kScene;
  const bool plans = strcmp(command, "plan") == 0 && argc > kScene;
  if (!resends && !cancels && !plans) {
    fputs("usage: cyclone_fleet_client DOMAIN CLUSTER plan|cancel|resend ID [SCENE [FILE...]]\n",
          stderr);
    return 2;
  }
  struct request request = {.submission.request_id = argv[kId],
                            .is_submitted_here = !resends,
                            .is_to_be_cancelled = cancels};
  if (!resends) fill_submission(argv[kId], argv + kScene, argc - kScene, &request.submission);
  struct endpoints fleet;
  bool ok = join_fleet((uint32_t)strtoul(argv[kDomain], NULL, 10), argv[kCluster], &fleet);
  if (ok) {
    follow(&fleet, &request);
    ok = report(&request);
  }
  dds_delete(fleet.participant);
  free_plan(&request.plan);
  if (!resends) free_submission(&request.submission);
  return ok ? 0 : 1;
}
