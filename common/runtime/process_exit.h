// What Accord's services exit with: the one list, for mains, service units and
// docs/operations.md. The `accord` command has its own (client/exit_code.h); the first four agree.
#pragma once

namespace accord {

enum class ProcessExit : int {
  kEnded = 0,        // asked to end, and did so in order
  kBug = 1,          // accord itself is wrong, or out of memory
  kUsage = 2,        // a flag or an environment variable makes no sense
  kBadFile = 3,      // the configuration file cannot be read, or is wrong
  kUnavailable = 4,  // what it needs of the machine is not to be had: the bus, a port, a folder
};

}  // namespace accord
