// Ctrl-C as a flag: the first asks the running request to end, the second ends the program.
#pragma once

#include <atomic>

namespace accord {

// Installs the handler for SIGINT and SIGTERM and returns the flag that it raises. Call once.
const std::atomic<bool>& interrupt_flag();

}  // namespace accord
