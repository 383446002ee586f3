// What every Crew promises, as checks that any implementation (and a wrong one) can be held to.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/model/scene.h"
#include "coordinator/crew.h"

namespace accord::crew_contract {

// Makes a crew of so many hands, for a scene; all of them are there when it is returned.
using MakeCrew =
    std::function<std::unique_ptr<Crew>(const std::shared_ptr<const Scene>& scene, unsigned hands)>;

// What a check found to be broken; empty where all is well.
using Breach = std::string;

struct Candidate {
  MakeCrew make;
  std::chrono::milliseconds patience;  // how long anything may take that has to happen
};

struct Check {
  std::string name;
  std::function<Breach(const Candidate&)> run;
};

inline void PrintTo(const Check& check, std::ostream* out) {
  *out << check.name;
}

const std::vector<Check>& checks();
const Check& check_named(const std::string& name);

}  // namespace accord::crew_contract
