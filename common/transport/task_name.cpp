#include "common/transport/task_name.h"

#include <cstdio>

namespace accord {

std::string task_name(std::uint64_t task) {
  char text[32];
  const auto request = static_cast<unsigned long>(task >> 32U);
  const auto number = static_cast<unsigned long>(task & UINT32_MAX);
  std::snprintf(text, sizeof text, "%lx-%lu", request, number);
  return text;
}

}  // namespace accord
