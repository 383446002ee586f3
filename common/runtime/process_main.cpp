#include "common/runtime/process_main.h"

#include <exception>
#include <iostream>
#include <new>

namespace accord {

int process_main(const char* program, const std::function<ProcessExit()>& run) {
  try {
    return static_cast<int>(run());
  } catch (const std::bad_alloc&) {
    std::cerr << program << ": out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << program << ": internal error: " << error.what()
              << "\nThis is a bug in accord. Please report it.\n";
  }
  return static_cast<int>(ProcessExit::kBug);
}

}  // namespace accord
