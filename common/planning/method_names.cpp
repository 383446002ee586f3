#include "common/planning/method_names.h"

#include <algorithm>

namespace accord {

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names{kArcMethod, "decoupled-prm", "composite-prm",
                                              "composite-rrt-connect", "cbs-mp"};
  return names;
}

const std::vector<std::string>& local_solver_names() {
  static const std::vector<std::string> names{"lockstep-query", "prioritized-query",
                                              "decoupled-prm", "composite-rrt-connect",
                                              "composite-prm"};
  return names;
}

const std::vector<std::string>& default_solver_names() {
  static const std::vector<std::string> names{"lockstep-query", "prioritized-query",
                                              "decoupled-prm", "composite-prm"};
  return names;
}

const std::vector<std::string>& resolution_solver_names() {
  static const std::vector<std::string> names{"straight",       "prm",
                                              "lockstep-query", "prioritized-query",
                                              "decoupled-prm",  "composite-rrt-connect",
                                              "composite-prm",  "cbs-mp"};
  return names;
}

std::string counted_solver(const std::string& name) {
  const auto& names = resolution_solver_names();
  return std::ranges::find(names, name) == names.end() ? kOtherSolver : name;
}

}  // namespace accord
