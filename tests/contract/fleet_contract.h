// What both ends of the public topics promise, as checks that any implementation (and a wrong one)
// can be held to.
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/transport/fleet/fleet_port.h"

namespace accord::fleet_contract {

// A network of one implementation, fresh for each check.
class World {
 public:
  virtual ~World() = default;
  virtual std::unique_ptr<FleetServicePort> serve(std::function<void()> wake) = 0;
  virtual std::unique_ptr<FleetClientPort> join() = 0;
};

// What a check found to be broken; empty where all is well.
using Breach = std::string;

struct Check {
  std::string name;
  std::function<Breach(World&)> run;
};

inline void PrintTo(const Check& check, std::ostream* out) {
  *out << check.name;
}

const std::vector<Check>& checks();
const Check& check_named(const std::string& name);

}  // namespace accord::fleet_contract
