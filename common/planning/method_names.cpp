#include "common/planning/method_names.h"

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

}  // namespace accord
