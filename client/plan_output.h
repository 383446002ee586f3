// What `accord plan` and `accord submit` have in common: what is asked, and how the answer is
// handed out.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/exit_code.h"
#include "common/model/plan.h"
#include "common/model/scene.h"

namespace accord {

struct PlanQuestion {
  std::string scene;   // file
  std::string output;  // file; empty: none
  std::string method = "arc";
  std::uint64_t seed = 1;
  std::vector<std::string> solvers;  // empty: the default ones
  double timeout = 0;                // s; 0: none
  bool json = false;
  bool quiet = false;
};

void add_plan_question(CLI::App& command, PlanQuestion& question);

// Proves a solved plan with so many threads, writes and prints it as the question says, and tells
// why there is none.
ExitCode hand_out(const std::shared_ptr<const Scene>& scene, const Plan& plan,
                  const PlanQuestion& question, unsigned threads);

ExitCode exit_code_of(PlanStatus status);

}  // namespace accord
