// Threads of this process that solve subproblems.
#pragma once

#include <string>
#include <vector>

#include "client/engine/work_pool.h"
#include "coordinator/workforce.h"
#include "worker/worker.h"

namespace accord {

class LocalWorkforce final : public Workforce {
 public:
  LocalWorkforce(const CollisionWorld& world, const std::vector<std::string>& solvers,
                 unsigned threads)
      : worker_(world, solvers), pool_(threads) {}

  std::vector<Resolution> solve(const std::vector<Subproblem>& subproblems,
                                const std::atomic<bool>& stop) override;

 private:
  Worker worker_;
  WorkPool pool_;
};

}  // namespace accord
