// What `accord` exits with.
#pragma once

namespace accord {

enum class ExitCode : int {
  kSuccess = 0,     // solved, proved, or done
  kBug = 1,         // accord itself is wrong, or out of memory
  kUsage = 2,       // the command line makes no sense
  kBadInput = 3,    // a file cannot be read or written, or is wrong
  kInfeasible = 4,  // no plan where the search goes no further, or the plan given is refuted
  kTimeout = 5,     // time ran out, or the request was cancelled
  kNoService = 6,   // no planning service answers, or it is not well
  kFault = 7,       // accord doctor has found what stops data or plans
};

}  // namespace accord
