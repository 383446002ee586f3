// From a scene file to a request that brings all of it along.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/model/plan_request.h"
#include "common/model/scene.h"

namespace accord {

struct RequestFile {
  PlanRequest request;                 // its scene and the files that it names; no id, no options
  std::shared_ptr<const Scene> scene;  // null where there is a fault
  std::vector<Diagnostic> faults;
};

// Reads the scene as load_scene() does, so that what is wrong with it is said before anything is
// sent. Thread safe.
RequestFile request_for_scene(const std::string& path);

}  // namespace accord
