#pragma once
#include <filesystem>
#include <string>

#include "coordinator/dispatch/remote_crew.h"
namespace accord {
inline std::string kept_where(const std::filesystem::path&, const std::string&,
                              const TaskFailure&) {
  return "";
}
}  // namespace accord
