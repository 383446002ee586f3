// What this machine calls itself, for people.
#pragma once

#include <string>

namespace accord {

std::string host_name();  // empty where it has none

}  // namespace accord
