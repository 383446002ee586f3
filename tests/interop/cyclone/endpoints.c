#include "endpoints.h"

#include <stdio.h>

#include "fleet.h"

// Deep enough for the pieces of a large plan that come while others are looked at.
enum { kReaderDepth = 4096 };

// How DDS entities of one participant are made, until something is refused.
struct maker {
  dds_entity_t participant;
  dds_entity_t publisher;
  dds_entity_t subscriber;
  bool ok;
};

static dds_entity_t made(struct maker* maker, const char* what, dds_entity_t entity) {
  if (entity >= 0) return entity;
  if (maker->ok) fprintf(stderr, "DDS refuses %s: %s\n", what, dds_strretcode(entity));
  maker->ok = false;
  return entity;
}

static dds_entity_t topic(struct maker* maker, const char* name,
                          const dds_topic_descriptor_t* type) {
  char full[64];
  snprintf(full, sizeof full, "accord/fleet/v1/%s", name);
  return made(maker, full, dds_create_topic(maker->participant, type, full, NULL, NULL));
}

// Nothing is thrown away: a write waits where the service has not taken `depth` before it.
static dds_entity_t writer(struct maker* maker, const char* name,
                           const dds_topic_descriptor_t* type, int32_t depth) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  dds_qset_resource_limits(qos, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  const dds_entity_t out =
      made(maker, name, dds_create_writer(maker->publisher, topic(maker, name, type), qos, NULL));
  dds_delete_qos(qos);
  return out;
}

// `durability`: transient-local gets what the service has said before. `waitset`: what it triggers.
static dds_entity_t reader(struct maker* maker, const char* name,
                           const dds_topic_descriptor_t* type, dds_durability_kind_t durability,
                           dds_entity_t waitset) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, 0);
  dds_qset_durability(qos, durability);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, kReaderDepth);
  const dds_entity_t out =
      made(maker, name, dds_create_reader(maker->subscriber, topic(maker, name, type), qos, NULL));
  dds_delete_qos(qos);
  if (maker->ok) {
    dds_set_status_mask(out, DDS_DATA_AVAILABLE_STATUS);
    const dds_return_t attached = dds_waitset_attach(waitset, out, 0);
    made(maker, "to wait for news", attached);
  }
  return out;
}

bool join_fleet(uint32_t domain, const char* cluster, struct endpoints* out) {
  struct maker maker = {.ok = true};
  maker.participant = made(&maker, "to join", dds_create_participant(domain, NULL, NULL));
  dds_qos_t* qos = dds_create_qos();
  dds_qset_partition1(qos, cluster);
  maker.publisher = made(&maker, "a publisher", dds_create_publisher(maker.participant, qos, NULL));
  maker.subscriber =
      made(&maker, "a subscriber", dds_create_subscriber(maker.participant, qos, NULL));
  dds_delete_qos(qos);

  out->participant = maker.participant;
  out->news = made(&maker, "a waitset", dds_create_waitset(maker.participant));
  out->plan_requests = writer(&maker, "plan_requests", &accord_fleet_PlanRequest_desc, 8);
  out->cancels = writer(&maker, "cancels", &accord_fleet_Cancel_desc, 64);
  out->resends = writer(&maker, "resends", &accord_fleet_Resend_desc, 64);
  const dds_durability_kind_t now = DDS_DURABILITY_VOLATILE,
                              before = DDS_DURABILITY_TRANSIENT_LOCAL;
  out->replies = reader(&maker, "replies", &accord_fleet_RequestReply_desc, now, out->news);
  out->statuses = reader(&maker, "statuses", &accord_fleet_PlanStatus_desc, before, out->news);
  out->plans = reader(&maker, "plans", &accord_fleet_Plan_desc, now, out->news);
  out->robot_plans = reader(&maker, "robot_plans", &accord_fleet_RobotPlan_desc, now, out->news);
  out->workers = reader(&maker, "workers", &accord_fleet_WorkerStatus_desc, before, out->news);
  // Last: the service finds readers in this order, so whoever hears on this one is heard on all.
  out->service = reader(&maker, "service", &accord_fleet_ServiceStatus_desc, before, out->news);
  return maker.ok;
}

bool take(dds_entity_t reader, void* sample) {
  dds_sample_info_t info;
  dds_return_t count;
  do {
    count = dds_take(reader, &sample, &info, 1, 1);
  } while (count == 1 && !info.valid_data);  // such as that the service has left
  return count == 1;
}
