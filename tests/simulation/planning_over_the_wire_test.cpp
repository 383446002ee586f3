// A worker that sees nothing but bytes makes the same plan: the scene it plans in, each subproblem
// that it is given and each resolution that it returns have gone through the codecs.
#include <gtest/gtest.h>

#include "common/geometry/tolerances.h"
#include "common/io/scene_file.h"
#include "common/io/wire/resolution_codec.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/planning/schedule.h"
#include "tests/support/planned_paths.h"
#include "worker/worker.h"

namespace accord {
namespace {

class Workers : public Workforce {
 public:
  explicit Workers(const std::shared_ptr<const Scene>& scene)
      : scene_(scene), world_(scene, kPlanningMargin), worker_(world_) {}

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop, const Foresight&) override {
    std::vector<Resolution> out;
    for (const Subproblem& subproblem : subproblems) out.push_back(one(subproblem, stop));
    return out;
  }

 protected:
  virtual Resolution one(const Subproblem& subproblem, const std::atomic<bool>& stop) {
    return worker_.solve(subproblem, default_solver_names(), stop);
  }

  std::shared_ptr<const Scene> scene_;
  CollisionWorld world_;
  Worker worker_;
};

class WorkersBehindTheWire final : public Workers {
 public:
  using Workers::Workers;

  std::size_t largest = 0;  // bytes of a subproblem

 private:
  Resolution one(const Subproblem& subproblem, const std::atomic<bool>& stop) override {
    const Bytes bytes = encode_subproblem(subproblem);
    largest = std::max(largest, bytes.size());
    const auto received = decode_subproblem(bytes, *scene_);
    if (!received) throw std::logic_error(received.error());
    const Resolution resolution = worker_.solve(*received, default_solver_names(), stop);
    auto returned = decode_resolution(encode_resolution(resolution), *scene_, subproblem);
    if (!returned) throw std::logic_error(returned.error());
    return *returned;
  }
};

// Solves every subproblem twice: as a worker that has solved those before, and as one that has not.
class WorkersWithAndWithoutMemory final : public Workers {
 public:
  using Workers::Workers;

 private:
  Resolution one(const Subproblem& subproblem, const std::atomic<bool>& stop) override {
    const CollisionWorld world(scene_, kPlanningMargin);
    const Resolution fresh = Worker(world).solve(subproblem, default_solver_names(), stop);
    Resolution resolution = worker_.solve(subproblem, default_solver_names(), stop);
    EXPECT_EQ(encode_resolution(resolution), encode_resolution(fresh));
    return resolution;
  }
};

class PlanningOverTheWire : public ::testing::TestWithParam<const char*> {};

TEST_P(PlanningOverTheWire, MakesTheSamePlanToTheBit) {
  const auto scene = testing::example_scene(GetParam());
  ASSERT_NE(scene, nullptr);
  const Bytes bytes = encode_scene(*scene);
  const auto copy = decode_scene(bytes);
  ASSERT_TRUE(copy) << copy.error();
  Workers here(scene);
  WorkersBehindTheWire there(*copy);
  EXPECT_EQ(testing::planned_paths(scene, here), testing::planned_paths(scene, there));
  RecordProperty("scene_bytes", static_cast<int>(bytes.size()));
  RecordProperty("largest_subproblem_bytes", static_cast<int>(there.largest));
}

// Efforts too: a plan's statistics must not tell who has made it.
TEST(PlanningByOthers, DoesNotDependOnWhatTheyRemember) {
  for (const char* name : {"adaptive-mobile", "low-manipulator-04", "mixed-cell", "drones-12",
                           "fleet-0050", "peer-hallways-08", "depot-map"}) {
    const auto scene = testing::example_scene(name);
    WorkersWithAndWithoutMemory workers(scene);
    EXPECT_FALSE(testing::planned_paths(scene, workers).empty()) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PlanningOverTheWire,
                         ::testing::Values("adaptive-mobile", "low-mobile-16", "low-manipulator-02",
                                           "mixed-floor", "mixed-cell", "drones-12", "rack-drones",
                                           "depot-map", "fleet-0050", "fleet-1000",
                                           "random-crossing-0100", "panda-four", "ur5e-pair",
                                           "peer-hallways-08", "high-mobile", "low-manipulator-16",
                                           "ros-floor", "carts-6", "peer-planar-cross-008"),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace accord
