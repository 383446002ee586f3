// A workforce whose every resolution is looked at: what the workers of honest clusters return must
// not be refused.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "common/geometry/tolerances.h"
#include "common/planning/resolution_check.h"
#include "coordinator/workforce.h"

namespace accord::testing {

class CheckedWorkforce final : public Workforce {
 public:
  using Duration = std::chrono::steady_clock::duration;

  // `workforce` must outlive this.
  CheckedWorkforce(std::shared_ptr<const Scene> scene, Workforce& workforce)
      : world_(std::move(scene), kDetectionMargin), workforce_(workforce) {}

  std::vector<std::string> faults;
  std::size_t solved = 0;       // resolutions that claim something
  Duration spent_on_solving{};  // and handing back
  Duration spent_on_checks{};

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop,
                                const Foresight& foresight) override {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Resolution> resolutions = workforce_.solve(subproblems, stop, foresight);
    const auto middle = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < resolutions.size(); ++i) {
      if (resolutions[i].solved || resolutions[i].improves()) ++solved;
      const auto fault = resolution_fault(world_, subproblems[i], resolutions[i]);
      if (fault) faults.push_back(resolutions[i].solver + ": " + *fault);
    }
    spent_on_solving += middle - begin;
    spent_on_checks += std::chrono::steady_clock::now() - middle;
    return resolutions;
  }

 private:
  CollisionWorld world_;
  Workforce& workforce_;
};

}  // namespace accord::testing
