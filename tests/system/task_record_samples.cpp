// Writes recorded tasks into a folder, for replay_test.py: task_record_samples FOLDER.
//
//     solved.task    two discs that cross                     alone.task  a robot on its own
//     exhausted.task two in a corridor that is too narrow     endless.task  the same, without
//     limits unknown.task   names a solver that does not exist
#include <fstream>
#include <iostream>
#include <string>

#include "common/io/wire/scene_codec.h"
#include "common/io/wire/subproblem_codec.h"
#include "common/io/wire/task_record.h"
#include "common/planning/method_names.h"
#include "tests/support/problems.h"

namespace {

using accord::testing::Problem;
using accord::testing::SceneBuilder;

Problem narrow_corridor() {
  return accord::testing::whole_problem(
      SceneBuilder(-6, -0.6, 6, 0.6).disk(0.5, {-4, 0}, {4, 0}).disk(0.5, {4, 0}, {-4, 0}).build(),
      2);
}

bool write(const std::string& path, Problem problem, const std::vector<std::string>& solvers) {
  for (accord::Task& task : problem.subproblem.tasks) {
    task.tail = accord::testing::path({{task.to, task.goal}});
  }
  const accord::Bytes bytes = accord::encode_task_record(
      {accord::encode_scene(*problem.scene), accord::encode_hierarchy(solvers),
       accord::encode_subproblem(problem.subproblem), "three workers were lost with it"});
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.close();
  return out.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "task_record_samples FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  const std::vector<std::string> usual = accord::default_solver_names();
  Problem alone = accord::testing::crossing_discs();
  alone.subproblem.tasks.pop_back();
  Problem exhausted = narrow_corridor();
  exhausted.subproblem.limits.last_factor = 1;
  Problem endless = narrow_corridor();
  endless.subproblem.limits = accord::SolverLimits::unlimited();
  const bool is_written = write(folder + "solved.task", accord::testing::crossing_discs(), usual) &&
                          write(folder + "alone.task", alone, usual) &&
                          write(folder + "exhausted.task", exhausted, usual) &&
                          write(folder + "endless.task", endless, {"composite-prm"}) &&
                          write(folder + "unknown.task", alone, {"prioritized-query", "magic"});
  return is_written ? 0 : 1;
}
