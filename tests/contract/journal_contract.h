// What every Journal promises, as checks that any implementation (and a wrong one) can be held to.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "coordinator/journal/journal.h"

namespace accord::journal_contract {

// A journal of one implementation, empty at the beginning of each check.
class World {
 public:
  virtual ~World() = default;
  virtual Journal& journal() = 0;
  // The coordinator ends, another one starts on the same journal.
  virtual void restart() = 0;
  // Whatever is written while it is full does not fit.
  virtual void set_full(bool full) = 0;
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

// A request whose bytes follow from its id: `size` of them.
AcceptedRequest sample_request(const std::string& id, std::size_t size = 1000);
// As the bytes of a request, a plan.
std::string sample_plan(const std::string& id, std::size_t size = 3000);

}  // namespace accord::journal_contract
