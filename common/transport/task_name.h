// By what logs name a task, at the coordinator and at its worker alike.
#pragma once

#include <cstdint>
#include <string>

namespace accord {

// The request's number, in hexadecimal digits, and the task's in it: "5f3a9c21-17". A text, since
// not all that reads JSON holds as large a number.
std::string task_name(std::uint64_t task);

}  // namespace accord
