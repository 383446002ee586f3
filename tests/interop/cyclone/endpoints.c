#include "endpoints.h"

#include <stdio.h>

#include "fleet.h"

enum {
  // Deep enough for the pieces of a large plan that come while others are looked at.
  kReaderDepth = 4096,
  kRobotDepth = 256,
};

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
  return made(maker, name, dds_create_topic(maker->participant, type, name, NULL, NULL));
}

static dds_entity_t fleet_topic(struct maker* maker, const char* name,
                                const dds_topic_descriptor_t* type) {
  char full[64];
  snprintf(full, sizeof full, "accord/fleet/v1/%s", name);
  return topic(maker, full, type);
}

// Nothing is thrown away: a write waits where the service has not taken `depth` before it.
static dds_entity_t writer(struct maker* maker, const char* name,
                           const dds_topic_descriptor_t* type, int32_t depth) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  dds_qset_resource_limits(qos, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  const dds_entity_t out = made(
      maker, name, dds_create_writer(maker->publisher, fleet_topic(maker, name, type), qos, NULL));
  dds_delete_qos(qos);
  return out;
}

// `durability`: transient-local gets what was said before.
static dds_entity_t reader(struct maker* maker, dds_entity_t topic,
                           dds_durability_kind_t durability, int32_t depth) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, 0);
  dds_qset_durability(qos, durability);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  const dds_entity_t out =
      made(maker, "a reader", dds_create_reader(maker->subscriber, topic, qos, NULL));
  dds_delete_qos(qos);
  return out;
}

// What of a reader triggers `waitset`.
static void attach(struct maker* maker, dds_entity_t waitset, dds_entity_t reader, uint32_t mask) {
  if (!maker->ok) return;
  dds_set_status_mask(reader, mask);
  made(maker, "to wait for news", dds_waitset_attach(waitset, reader, 0));
}

static dds_entity_t fleet_reader(struct maker* maker, const char* name,
                                 const dds_topic_descriptor_t* type,
                                 dds_durability_kind_t durability, dds_entity_t waitset) {
  const dds_entity_t out = reader(maker, fleet_topic(maker, name, type), durability, kReaderDepth);
  attach(maker, waitset, out, DDS_DATA_AVAILABLE_STATUS);
  return out;
}

// NULL: in no partition.
static struct maker join(uint32_t domain, const char* partition) {
  struct maker maker = {.ok = true};
  maker.participant = made(&maker, "to join", dds_create_participant(domain, NULL, NULL));
  dds_qos_t* qos = dds_create_qos();
  if (partition != NULL) dds_qset_partition1(qos, partition);
  maker.publisher = made(&maker, "a publisher", dds_create_publisher(maker.participant, qos, NULL));
  maker.subscriber =
      made(&maker, "a subscriber", dds_create_subscriber(maker.participant, qos, NULL));
  dds_delete_qos(qos);
  return maker;
}

bool join_fleet(uint32_t domain, const char* cluster, struct endpoints* out) {
  struct maker maker = join(domain, cluster);
  out->participant = maker.participant;
  out->news = made(&maker, "a waitset", dds_create_waitset(maker.participant));
  out->plan_requests = writer(&maker, "plan_requests", &accord_fleet_PlanRequest_desc, 8);
  out->cancels = writer(&maker, "cancels", &accord_fleet_Cancel_desc, 64);
  out->resends = writer(&maker, "resends", &accord_fleet_Resend_desc, 64);
  const dds_durability_kind_t now = DDS_DURABILITY_VOLATILE,
                              before = DDS_DURABILITY_TRANSIENT_LOCAL;
  const dds_entity_t news = out->news;
  out->replies = fleet_reader(&maker, "replies", &accord_fleet_RequestReply_desc, now, news);
  out->statuses = fleet_reader(&maker, "statuses", &accord_fleet_PlanStatus_desc, before, news);
  out->plans = fleet_reader(&maker, "plans", &accord_fleet_Plan_desc, now, news);
  out->robot_plans = fleet_reader(&maker, "robot_plans", &accord_fleet_RobotPlan_desc, now, news);
  out->workers = fleet_reader(&maker, "workers", &accord_fleet_WorkerStatus_desc, before, news);
  // Last: the service finds readers in this order, so whoever hears on this one is heard on all.
  out->service = fleet_reader(&maker, "service", &accord_fleet_ServiceStatus_desc, before, news);
  return maker.ok;
}

static bool listen_on(struct maker* maker, dds_entity_t topic, int32_t depth,
                      struct listener* out) {
  out->participant = maker->participant;
  out->news = made(maker, "a waitset", dds_create_waitset(maker->participant));
  out->reader = reader(maker, topic, DDS_DURABILITY_TRANSIENT_LOCAL, depth);
  attach(maker, out->news, out->reader,
         DDS_DATA_AVAILABLE_STATUS | DDS_SUBSCRIPTION_MATCHED_STATUS);
  return maker->ok;
}

bool join_as_robot(uint32_t domain, const char* cluster, const char* robot, struct listener* out) {
  char partition[512];
  const int size = snprintf(partition, sizeof partition, "%s/robot/%s", cluster, robot);
  if (size < 0 || (size_t)size >= sizeof partition) {
    fputs("the names of cluster and robot are too long\n", stderr);
    out->participant = DDS_RETCODE_BAD_PARAMETER;
    return false;
  }
  struct maker maker = join(domain, partition);
  return listen_on(&maker, fleet_topic(&maker, "robot_plans", &accord_fleet_RobotPlan_desc),
                   kRobotDepth, out);
}

bool join_ros(uint32_t domain, const char* topic_name, const dds_topic_descriptor_t* type,
              struct listener* out) {
  struct maker maker = join(domain, NULL);
  return listen_on(&maker, topic(&maker, topic_name, type), 1, out);
}

bool take(dds_entity_t reader, void* sample) {
  dds_sample_info_t info;
  dds_return_t count;
  do {
    count = dds_take(reader, &sample, &info, 1, 1);
  } while (count == 1 && !info.valid_data);  // such as that the service has left
  return count == 1;
}
