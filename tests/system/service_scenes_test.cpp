// Every scene over the service, with one, two and four workers: the plan is the one of one process,
// to the byte.
//
// ACCORD_ALL_SCENES=1: all of scenes/, seeds 1 to 5 (the campaign, some minutes); else a few, one
// seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/support/service_processes.h"

namespace accord {
namespace {

using testing::planned_here;
using testing::request_for;

bool is_campaign() {
  return std::getenv("ACCORD_ALL_SCENES") != nullptr;
}

std::vector<std::string> scenes() {
  if (!is_campaign()) {
    return {"carts-6",     "depot-map",  "drones-12", "fleet-0100",
            "panda-four",  "mixed-cell", "ros-floor", "peer-planar-cross-032",
            "rack-drones", "peer-inlet"};
  }
  std::vector<std::string> all;
  for (const auto& file : std::filesystem::directory_iterator(ACCORD_SOURCE_DIR "/scenes")) {
    const bool is_scene = load_scene(file.path()).scene != nullptr;
    if (file.path().extension() == ".yaml" && is_scene) all.push_back(file.path().stem());
  }
  std::ranges::sort(all);
  return all;
}

TEST(ServiceScenes, AreAllPlannedAsOneProcessDoes) {
  const std::uint64_t seeds = is_campaign() ? 5 : 1;
  for (const int workers : {1, 2, 4}) {
    testing::ServiceProcesses service;
    service.start_coordinator();
    for (int i = 0; i < workers; ++i) service.start_worker();
    for (const std::string& scene : scenes()) {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        PlanRequest request = request_for(scene, seed);
        request.id += "-" + std::to_string(workers);
        const auto answer = service.plan(request);
        ASSERT_TRUE(answer) << scene << ": " << answer.error().reply.text;
        EXPECT_EQ(canonical_bytes(*answer), planned_here(scene, seed))
            << scene << ", seed " << seed << ", " << workers << " workers";
      }
    }
  }
}

}  // namespace
}  // namespace accord
