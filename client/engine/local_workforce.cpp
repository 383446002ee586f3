#include "client/engine/local_workforce.h"

namespace accord {

std::vector<Resolution> LocalWorkforce::solve(const std::vector<Subproblem>& subproblems,
                                              const std::atomic<bool>& stop) {
  std::vector<Resolution> resolutions(subproblems.size());
  pool_.run(subproblems.size(),
            [&](std::size_t i) { resolutions[i] = worker_.solve(subproblems[i], stop); });
  return resolutions;
}

}  // namespace accord
