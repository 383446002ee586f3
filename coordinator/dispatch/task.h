// A unit of work as the coordinator's books know it: opaque bytes for whoever takes it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/io/wire/bytes.h"
#include "common/io/wire/scene_hash.h"
#include "common/transport/endpoint_id.h"
#include "coordinator/dispatch/warm_roadmaps.h"

namespace accord {

using TaskId = std::uint64_t;
using RequestId = std::uint64_t;

// What the tasks of a request have in common.
struct RequestWork {
  RequestId request = 0;
  SceneHash scene;
  std::shared_ptr<const Bytes> scene_bytes;  // canonical; handed to workers who lack the scene
  RoadmapPartners partners = {};
  std::string name = {};  // the request's id, as its sender calls it; for logs
};

struct NewTask {
  TaskId id = 0;      // no other task's, ever
  Bytes hierarchy;    // the solvers to try, in order
  Bytes subproblem;   // its payload
  double weight = 1;  // how long it takes, in units of the caller's; a guess
  // Of need: for threads that would idle, and out of their way as soon as they would not.
  bool is_ahead = false;
  std::vector<RoadmapPlace> places = {};  // whose roadmaps it needs
};

// How a task ended. Only the first outcome of a task counts; what comes later is dropped.
struct FinishedTask {
  enum class How : std::uint8_t {
    kDone,         // `resolution` is what the worker says; it is for the caller to check
    kQuarantined,  // its workers died or failed of it, too often
    kRefused,      // no worker takes it
  };
  RequestId request = 0;
  TaskId task = 0;
  How how = How::kDone;
  Bytes resolution;
  double seconds = 0;  // it took
  EndpointId worker;   // who said so
  std::string text;    // where it is not done: why, for people
};

}  // namespace accord
