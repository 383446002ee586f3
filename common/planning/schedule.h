// P of the ARC paper: every robot's present trajectory with its version, and the coupling timeline
// (which robots were planned together, when, by which solver). Changed by commits only; a commit
// that was computed from other versions is refused, not repaired.
// Not thread safe; one loop owns it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/model/scene.h"
#include "common/model/trajectory.h"
#include "common/planning/subproblem.h"

namespace accord {

// A stretch of one robot's path and the composition of robots it was planned in.
struct CouplingSegment {
  double from;
  double to;
  std::vector<RobotId> robots;  // sorted
  std::string solver;
  std::uint64_t subproblem = 0;  // the caller's number for what it came of; 0: it has none
};

class Schedule {
 public:
  explicit Schedule(std::shared_ptr<const Scene> scene);

  // Sets a robot's first path, planned alone from time 0. (Alg. 1, lines 2 to 5)
  void set_initial(RobotId robot, Trajectory path, std::string solver, std::uint64_t number = 0);

  std::size_t size() const { return entries_.size(); }
  const Trajectory& path(RobotId robot) const { return entries_[robot.index()].path; }
  std::uint64_t version(RobotId robot) const { return entries_[robot.index()].version; }
  // From 0 to the path's end, without gaps.
  const std::vector<CouplingSegment>& coupling(RobotId robot) const {
    return entries_[robot.index()].coupling;
  }

  // UpdateSolution of the paper: replaces each robot's path between the subproblem's window by its
  // local path, from whose end it goes on along its old path at once. (The paper lets all robots
  // leave the window together; that makes everyone wait for the slowest, and what a robot meets on
  // its tail is found by the next scan either way.)
  // False, and nothing changes, when a version differs or the resolution has a form_fault().
  // `number`: CouplingSegment::subproblem, of what is new.
  [[nodiscard]] bool commit(const Subproblem& subproblem, const Resolution& resolution,
                            std::uint64_t number = 0);

 private:
  struct Entry {
    Trajectory path;
    std::uint64_t version = 0;
    std::vector<CouplingSegment> coupling;
  };

  void splice(Entry& entry, const Subproblem& subproblem, const Task& task,
              const Trajectory& local) const;

  std::shared_ptr<const Scene> scene_;
  std::vector<Entry> entries_;
};

}  // namespace accord
