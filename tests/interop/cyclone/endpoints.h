// A fleet manager's ends of Accord's public topics, in C on Eclipse Cyclone DDS. Written from
// docs/topics.md and idl/fleet.idl alone, as anybody would who has no other part of Accord.
#pragma once

#include <dds/dds.h>
#include <stdbool.h>
#include <stdint.h>

struct endpoints {
  dds_entity_t participant;
  // Writers, to the service.
  dds_entity_t plan_requests;
  dds_entity_t cancels;
  dds_entity_t resends;
  // Readers, of what it says.
  dds_entity_t replies;
  dds_entity_t statuses;
  dds_entity_t plans;
  dds_entity_t robot_plans;
  dds_entity_t workers;
  dds_entity_t service;
  // Triggered while a reader has something to take.
  dds_entity_t news;
};

// Joins a cluster's topics. False, with a line on stderr, where DDS refuses. All of it goes with
// dds_delete(participant).
bool join_fleet(uint32_t domain, const char* cluster, struct endpoints* out);

// One reader, of what was said last before it came, and of all since.
struct listener {
  dds_entity_t participant;
  dds_entity_t reader;
  dds_entity_t news;  // triggered while it has something to take, and when writers come or go
};

// Joins the topic of one robot's own path; or one of ROS 2, such as "rt/accord/agv1/path".
// Otherwise as join_fleet().
bool join_as_robot(uint32_t domain, const char* cluster, const char* robot, struct listener* out);
bool join_ros(uint32_t domain, const char* topic, const dds_topic_descriptor_t* type,
              struct listener* out);

// Takes the next sample into one that was allocated by its type's __alloc(). False: there is none.
bool take(dds_entity_t reader, void* sample);
