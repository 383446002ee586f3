// What every Bus promises, as checks that any implementation (and a wrong one) can be held to.
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/transport/bus.h"

namespace accord::bus_contract {

// A network of one implementation, fresh for each check.
class World {
 public:
  virtual ~World() = default;
  virtual std::unique_ptr<Bus> join(Role role, std::uint32_t protocol = kProtocol) = 0;
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

// Messages of every kind, with something in every field.
std::vector<Message> sample_messages();

}  // namespace accord::bus_contract
