// Whoever carries out single attempts at subproblems for the coordinator: threads of this process,
// worker processes, or a simulation of either. What is attempted, and what becomes of it, is the
// Foreman's to decide.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "common/planning/subproblem.h"

namespace accord {

using Ticket = std::uint64_t;

// A subproblem and the solvers to try on it, in order: one level of the hierarchy, or several.
struct Attempt {
  Ticket ticket = 0;  // no other attempt's, ever
  std::shared_ptr<const Subproblem> subproblem;
  std::vector<std::string> solvers;
  bool is_ahead = false;  // of need: it may turn out that nobody asks for it
  double seconds = 0;  // it may take; a guess, which decides who gets what, never what comes back
};

// Who carried out an attempt, for the log.
struct Doer {
  std::string task;    // the attempt's name there, as task_name(); empty: it has none
  std::string worker;  // the process; empty: this one
  double seconds = 0;  // it took
};

struct Attempted {
  Ticket ticket = 0;
  Resolution resolution;       // as Worker::solve() gives it, whoever has carried it out
  double seconds = 0;          // it took
  std::exception_ptr failure;  // nobody could carry it out; then there is no resolution
  Doer doer;
};

// Not thread safe: one thread calls.
class Crew {
 public:
  virtual ~Crew() = default;

  // Attempts that are needed go before those ahead of need, whenever these were begun: one of them
  // that is under way is put off where it takes up the hands that a needed one waits for. Those
  // ahead of need go in the order in which they were begun.
  virtual void begin(std::vector<Attempt> attempts) = 0;
  // They are needed now. Nothing happens to those that are, or have ended.
  virtual void hurry(const std::vector<Ticket>& tickets) = 0;
  // Nobody wants to know how they end: they are stopped, and wait() does not return them. Nothing
  // happens to those that it has returned.
  virtual void drop(const std::vector<Ticket>& tickets) = 0;

  // Those that have ended, each once. Waits until there is one; and longer, for as long as needed
  // ones wait for hands. None: `stop` became true.
  // Requires: an attempt that is needed is under way.
  virtual std::vector<Attempted> wait(const std::atomic<bool>& stop) = 0;

  // How many attempts it can carry out at once, at present.
  virtual std::size_t hands() const = 0;
};

}  // namespace accord
